// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/sheet.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "random_sphere_families.hpp"

using namespace pn;
using namespace pn::test;
using Eigen::Vector3d;
using Eigen::Vector4d;

TEST_CASE("Both sheets touch the spheres, on their side of the mid-surface", "[sheet]") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const FamilyInDoubles family(family_of(RandomSphereFamily(seed).spheres()));
    for (const auto& [u, v] : {std::array{0.2, 0.3}, {1.0, 0.0}, {0.1, 0.9}}) {
      const Vector4d fu = family.by_u(u, v), fv = family.by_v(u, v);
      const Vector3d mu = fu.head<3>(), mv = fv.head<3>();
      for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
        const Vector3d n = family.normal(sheet, u, v);
        CHECK(n.norm() == Approx(1).epsilon(1e-14));
        // n.m_u + r_u = 0
        CHECK(std::abs(n.dot(mu) - fu(3)) < 1e-12 * mu.norm());
        CHECK(std::abs(n.dot(mv) - fv(3)) < 1e-12 * mv.norm());
        CHECK((n.dot(mu.cross(mv)) > 0) == (sheet == Sheet::kOuter));
      }
    }
  }
}

TEST_CASE("Derivatives are those of the points", "[sheet]") {
  const FamilyInDoubles family(family_of(RandomSphereFamily(3).spheres()));
  const double u = 0.3, v = 0.4, h = 0.25;  // differences of quadratic polynomials are exact
  const Vector4d by_u = (family.at(u + h, v) - family.at(u - h, v)) / (2 * h),
                 by_v = (family.at(u, v + h) - family.at(u, v - h)) / (2 * h);
  CHECK((by_u - family.by_u(u, v)).norm() < 1e-11 * by_u.norm());
  CHECK((by_v - family.by_v(u, v)).norm() < 1e-11 * by_v.norm());
}
