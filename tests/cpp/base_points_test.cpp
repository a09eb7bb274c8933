// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/base_points.hpp"

#include <catch2/catch.hpp>

#include "enclosures.hpp"
#include "random_sphere_families.hpp"

using namespace pn;
using namespace pn::test;

TEST_CASE("At a base point the contact equations have rank one and w is isotropic",
          "[base_points]") {
  std::size_t seen = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const QuadraticFamily family = family_of(RandomSphereFamily(seed).spheres());
    const auto points = base_points(family, 256);
    CHECK(points.size() % 2 == 0);
    CHECK(points.size() <= 6);
    seen += points.size();
    for (const auto& w : points) {
      CHECK(w[3].is_positive());
      const auto product = [&](const MinkowskiVector<Rational>& x) {
        return w[0] * RealBall(x[0], 256) + w[1] * RealBall(x[1], 256) +
               w[2] * RealBall(x[2], 256) - w[3] * RealBall(x[3], 256);
      };
      const auto a = family.power();
      std::array<RealBall, 5> q;
      double size = w[3].magnitude_upper(), largest = 0;
      for (std::size_t i = 0; i < 5; ++i) {
        q[i] = product(a[i]);
        largest = std::max(largest, q[i].magnitude_upper());
      }
      CHECK(encloses_zero(w[0] * w[0] + w[1] * w[1] + w[2] * w[2] - w[3] * w[3],
                          1e-30 * size * size));
      const double scale = 1e-30 * largest * largest;
      CHECK(encloses_zero(q[0] * q[2] - q[1] * q[1], scale));
      CHECK(encloses_zero(q[0] * q[4] - q[1] * q[3], scale));
      CHECK(encloses_zero(q[1] * q[4] - q[2] * q[3], scale));
    }
  }
  CHECK(seen > 30);
}

TEST_CASE("Families without second derivatives have none", "[base_points]") {
  // A plane of spheres: all control points are affine.
  const QuadraticFamily plane = family_of(
      {{{2, 0, 0, 1}, {1, 1, 0, 1}, {0, 2, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 0, 1}}});
  CHECK(base_points(plane, 128).empty());
}
