// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/sphere_curve.hpp"

#include <catch2/catch.hpp>

#include "circle_families.hpp"

using pn::RationalPolynomial;
using pn::SphereCurve;
using pn::test::polynomial;

namespace {

/// f' = content / denominator^2 (M, -R) with f = (centre, -radius) / denominator.
void check_direction(const SphereCurve& curve) {
  const auto [circles, content] = tangent_direction(curve);
  const auto numerator = [&](const RationalPolynomial& p) {
    return p.derivative() * curve.denominator - p * curve.denominator.derivative();
  };
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(numerator(curve.centre[i]) == content * circles.axis[i]);
  CHECK(numerator(curve.radius) == content * circles.level);
  if (content.is_zero()) return;
  const auto common =
      gcd(gcd(circles.axis[0], circles.axis[1]), gcd(circles.axis[2], circles.level));
  CHECK(common.degree() == 0);
}

}  // namespace

TEST_CASE("The tangent direction is the derivative without its common factor", "[sphere_curve]") {
  check_direction({{polynomial({1, 2, 3, 4}), polynomial({0, 1, 0, 5}), polynomial({2, -3, 1})},
                   polynomial({4, 1, 1}),
                   1L});
  check_direction({{polynomial({1, 2, 3}), polynomial({0, 1}), polynomial({2, -3, 1})},
                   polynomial({4, 1, 1}),
                   polynomial({2, 1, 3})});
  // A constant denominator that is not 1.
  check_direction(
      {{polynomial({1, 2, 3}), polynomial({0, 1}), polynomial({5})}, polynomial({4, 1, 1}), 3L});
}

TEST_CASE("Common factors of f' go into the content", "[sphere_curve]") {
  // m' and r' share (t - 1)(t^2 + 1).
  const SphereCurve curve{{polynomial({0, -12, 6, -4, 3}), polynomial({1, -24, 12, -8, 6}), 7L},
                          polynomial({5, -12, 6, -4, 3}),
                          1L};
  check_direction(curve);
  const auto [circles, content] = tangent_direction(curve);
  CHECK(circles.degree() == 0);
  CHECK(content.degree() == 3);
  CHECK(content(pn::Rational(1L)).is_zero());
}

TEST_CASE("A single sphere has no direction", "[sphere_curve]") {
  const SphereCurve sphere{{polynomial({2, 4}), polynomial({1, 2}), polynomial({3, 6})},
                           polynomial({5, 10}),
                           polynomial({1, 2})};
  check_direction(sphere);
  CHECK(tangent_direction(sphere).content.is_zero());
}

TEST_CASE("Degrees, discriminant and orientation of a circle family", "[sphere_curve]") {
  const pn::CircleFamily family{{polynomial({1, 2}), polynomial({0, 0, 1}), polynomial({3})},
                                polynomial({2, 1})};
  CHECK(family.degree() == 2);
  CHECK(family.discriminant() == polynomial({6, 0, 3, 0, 1}));
  CHECK((-family).discriminant() == family.discriminant());
  CHECK((-family).axis[1] == polynomial({0, 0, -1}));
  CHECK((-family).level == polynomial({-2, -1}));
  CHECK(SphereCurve{{polynomial({1, 2}), 1L, 0L}, polynomial({1, 2, 3, 4}), polynomial({1, 0, 1})}
            .degree() == 3);
}
