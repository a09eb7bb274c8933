// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_points.hpp"

#include <catch2/catch.hpp>

#include "moving_ellipses.hpp"

using namespace pn;
using namespace pn::test;

namespace {

RationalPolynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

RealBall determinant(const FormInU<RealBall>& form, const RealBall& t) {
  const auto& c = form.coefficient;
  return c[0](t) * c[2](t) - c[1](t) * c[1](t);
}

/// A half-axis that is zero at t = 0, where the Smith type is (0, 2, 2): the ellipse is flat there.
MovingConic flat_at_start() { return upright(ellipse(poly({0, 0, 1}), poly({3, 1}))); }

}  // namespace

TEST_CASE("The determinant of the weight is the ellipticity up to a positive constant",
          "[conic_points]") {
  const std::vector<MovingConic> conics = {upright(ellipse(poly({2, 1, 3}), poly({5, -2, 1}))),
                                           flat_at_start(),
                                           // Hyperbolas for t > 1/2.
                                           upright(diagonal(-1L, 1L, poly({1, -2}))),
                                           // Real on a part only: s in place of t.
                                           upright(ellipse(poly({1, 3}), poly({3, -2})))};
  for (const MovingConic& conic : conics) {
    const ConicPoints points(conic);
    const RationalPolynomial ellipticity = points.ellipticity();
    const FormInU<RealBall> weight = points(192)[3];
    const RealBall start(Rational(1) / Rational(7), 192), other(Rational(2) / Rational(3), 192);
    const auto exact = [&](const Rational& s) { return RealBall(ellipticity(s), 192); };
    const RealBall scale = determinant(weight, start) / exact(Rational(1) / Rational(7));
    CHECK(scale.is_positive());
    CHECK((determinant(weight, other) / scale).overlaps(exact(Rational(2) / Rational(3))));
  }
}

TEST_CASE("An ellipse that is flat at one end is finite there", "[conic_points]") {
  CHECK(ConicPoints(flat_at_start()).ellipticity()(Rational(0)).sign() > 0);
}

TEST_CASE("The parameter runs from 0 to 1 where conics are real on a part only", "[conic_points]") {
  const ConicPoints points(upright(ellipse(poly({1, 3}), poly({3, -2}))));
  CHECK(points.t_at(0) == 0);
  CHECK(points.t_at(1) == 1);
  CHECK(points.t_at(0.3) < points.t_at(0.6));
}
