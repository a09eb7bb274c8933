// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric_patches.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pn;

namespace {

using Polynomial = BivariatePolynomial;

const HalfAxes kHalf = {Rational(3), Rational(2), Rational(5) / Rational(2)};

/// x_i / half-axis, squared.
Polynomial square(const RationalPatch& patch, std::size_t i) {
  const Polynomial ratio = patch.point[i] * Polynomial(Rational(1) / kHalf[i]);
  return ratio * ratio;
}

Eigen::Vector3d point(const RationalPatch& patch, double u, double v) {
  const Rational a = Rational::exactly(u), b = Rational::exactly(v);
  const Rational weight = patch.weight(a, b);
  return {(patch.point[0](a, b) / weight).to_double(), (patch.point[1](a, b) / weight).to_double(),
          (patch.point[2](a, b) / weight).to_double()};
}

bool is_in_region(const RationalPatch& patch, double u, double v) {
  for (const Polynomial& p : patch.region) {
    if (p(Rational::exactly(u), Rational::exactly(v)).sign() < 0) return false;
  }
  return true;
}

/// x_u x x_v on the side of the patch, by differences.
Eigen::Vector3d normal(const RationalPatch& patch, double u, double v) {
  constexpr double kStep = 1.0 / (1 << 16);
  const Eigen::Vector3d along = point(patch, u + kStep, v) - point(patch, u - kStep, v),
                        across = point(patch, u, v + kStep) - point(patch, u, v - kStep);
  return patch.side * along.cross(across);
}

QuadricBounds box(const Interval& x, const Interval& y, const Interval& z) {
  return {{x, y, z}, std::nullopt};
}

}  // namespace

TEST_CASE("Patches satisfy the equations of their quadrics over Q", "[quadric_patches]") {
  const QuadricBounds bounds = box({-1, 1}, {-1, 0.5}, {});
  for (const RationalPatch& patch : ellipsoid_patches(kHalf, bounds)) {
    CHECK(square(patch, 0) + square(patch, 1) + square(patch, 2) == patch.weight * patch.weight);
  }
  for (const RationalPatch& patch : two_sheet_hyperboloid_patches(kHalf, bounds, {1, 1})) {
    CHECK(square(patch, 2) - square(patch, 0) - square(patch, 1) == patch.weight * patch.weight);
  }
  for (const int sign : {1, -1}) {
    for (const RationalPatch& patch : paraboloid_patches(kHalf, sign, 1, bounds, {1, 1})) {
      CHECK(patch.point[2] ==
            Polynomial(kHalf[2]) * (square(patch, 0) + Polynomial(long{sign}) * square(patch, 1)));
    }
  }
  const HalfAxes round = {Rational(3), Rational(3), Rational(4)};
  for (const RationalPatch& patch : cone_patches(round, {1, 2})) {
    const Polynomial& x = patch.point[0];
    const Polynomial& y = patch.point[1];
    const Polynomial& z = patch.point[2];
    CHECK(Polynomial(16L) * (x * x + y * y) == Polynomial(9L) * z * z);
  }
}

TEST_CASE("The region of a patch is that of the bounds", "[quadric_patches]") {
  QuadricBounds bounds = box({-2.5, 2}, {-1, 1.75}, {-2.25, 2});
  for (const bool has_angle : {false, true}) {
    if (has_angle) bounds.angle = Interval{0.25, 2.5};
    for (const RationalPatch& patch : ellipsoid_patches(kHalf, bounds)) {
      int inside = 0;
      for (int i = 0; i <= 32; ++i) {
        for (int j = 0; j <= 32; ++j) {
          const double u = i / 32.0, v = j / 32.0;
          const double p = 2 * u - 1, q = 2 * v - 1;
          // A patch of the ellipsoid is one half of it.
          const bool expected = p * p + q * q <= 1 && is_inside(bounds, point(patch, u, v));
          CHECK(is_in_region(patch, u, v) == expected);
          inside += expected;
        }
      }
      CHECK(inside > 0);
    }
  }
}

TEST_CASE("A hyperboloid's patch reaches the corners of its region", "[quadric_patches]") {
  const auto patches = two_sheet_hyperboloid_patches(kHalf, {}, {4, 1});
  REQUIRE(patches.size() == 1);
  // z / c at the corner (4, 1), whose stereographic parameters are (x / a, y / b) / (1 + z / c).
  const double z = std::sqrt(1 + 16.0 / 9 + 1.0 / 4);
  const double p = 4.0 / 3 / (1 + z), q = 0.5 / (1 + z);
  const double reach = std::sqrt((z - 1) / (z + 1)) * std::sqrt(1 + 1e-9);
  const double u = (p / reach + 1) / 2, v = (q / reach + 1) / 2;
  CHECK(is_in_region(patches[0], u, v));
  const Eigen::Vector3d corner = point(patches[0], u, v);
  CHECK(corner.x() == Approx(4));
  CHECK(corner.y() == Approx(1));
}

TEST_CASE("Normals of patches are on the side of positive distances", "[quadric_patches]") {
  for (const double u : {0.25, 0.5, 0.75}) {
    for (const double v : {0.25, 0.5, 0.625}) {
      for (const RationalPatch& patch : ellipsoid_patches(kHalf, {})) {
        CHECK(normal(patch, u, v).dot(point(patch, u, v)) > 0);
      }
      // Away from the axis, so downwards.
      CHECK(normal(two_sheet_hyperboloid_patches(kHalf, {}, {1, 1})[0], u, v).z() < 0);
      CHECK(normal(paraboloid_patches(kHalf, 1, -1, {}, {1, 1})[0], u, v).z() < 0);
      CHECK(normal(paraboloid_patches(kHalf, -1, 1, {}, {1, 1})[0], u, v).z() > 0);
      for (const Interval& heights : {Interval{1, 2}, Interval{-2, -1}}) {
        for (const RationalPatch& patch : cone_patches({3L, 3L, 4L}, heights)) {
          const Eigen::Vector3d p = point(patch, u, v), n = normal(patch, u, v);
          CHECK(p.x() * n.x() + p.y() * n.y() > 0);
        }
      }
    }
  }
}

TEST_CASE("A ruled patch runs from one curve to the other", "[quadric_patches]") {
  const RationalPolynomial t({Rational(0), Rational(1)}), one(1L), zero(0L);
  const SphereCurve first{{t, zero, zero}, zero, one + t}, second{{t, one, t * t}, zero, one};
  const RationalPatch patch = ruled_patch(first, second);
  for (const double u : {0.0, 0.25, 1.0}) {
    CHECK((point(patch, u, 0) - Eigen::Vector3d(u / (1 + u), 0, 0)).norm() < 1e-15);
    CHECK((point(patch, u, 1) - Eigen::Vector3d(u, 1, u * u)).norm() < 1e-15);
    const Eigen::Vector3d middle = (point(patch, u, 0) + point(patch, u, 1)) / 2;
    CHECK((point(patch, u, 0.5) - middle).norm() < 1e-15);
  }
}
