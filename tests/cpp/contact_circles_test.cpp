// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/contact_circles.hpp"

#include <catch2/catch.hpp>

using namespace pn;

namespace {

RationalPolynomial polynomial(long c, long b, long a) {
  return RationalPolynomial({Rational(c), Rational(b), Rational(a)});
}

/// (8 t, y t^2, 0) with radius 4 + r t^2: D = 64 + 4 (y^2 - r^2) t^2.
SphereCurve curve(long y, long r) {
  return {{polynomial(0, 8, 0), polynomial(0, 0, y), polynomial(0, 0, 0)},
          polynomial(4, 0, r),
          RationalPolynomial(std::vector<Rational>{Rational(1L)})};
}

}  // namespace

TEST_CASE("Without real roots of D the circles have the curve's parameter", "[contact_circles]") {
  const ContactCircles circles(curve(3, 1));
  for (const double t : {0.0, 0.3, 1.0}) CHECK(circles.parameter(t) == t);
}

TEST_CASE("With real roots beyond the ends the circles keep the curve's own places",
          "[contact_circles]") {
  const ContactCircles circles(curve(0, 3));
  CHECK(circles.parameter(0) == 0);
  CHECK(circles.parameter(1) == 1);
  const auto forms = circles.envelope().enclosure(128);
  const auto& local = std::get<SphereCurveForms<RealBall>>(forms.carrier);
  for (const double t : {0.2, 0.5, 0.9}) {
    const double s = circles.parameter(t);
    CHECK(std::abs(s - t) > 1e-3);
    // The centre there is that of the curve at t.
    const auto at = [&](const Form<RealBall>& form) { return midpoint(form)(s); };
    CHECK(at(local.centre[0]) / at(local.denominator) == Approx(8 * t).epsilon(1e-12));
    CHECK(at(local.radius) / at(local.denominator) == Approx(4 + 3 * t * t).epsilon(1e-12));
  }
}
