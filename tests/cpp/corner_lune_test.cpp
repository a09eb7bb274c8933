// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/corner_lune.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/bezier/skin_patch.hpp"
#include "random_sphere_families.hpp"

using namespace pn;
using namespace pn::test;
using Eigen::Vector3d;

namespace {

struct PointAndNormal {
  Vector3d point, normal;
};

/// Of the section at distance zero.
PointAndNormal at_place(const SurfaceSections<RealBall>& x, const std::array<double, 2>& at) {
  const auto value = [&](const TensorPolynomial<RealBall>& f) {
    return f.at(RealBall(at[0]), RealBall(at[1])).midpoint();
  };
  PointAndNormal result;
  for (int i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    result.point(i) = value(x.point[c]) / value(x.weight);
    result.normal(i) = value(x.direction[c]) / value(x.weight);
  }
  return result;
}

}  // namespace

TEST_CASE("A lune is on the sphere of its corner, between the end circles of both strips",
          "[corner_lune]") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const QuadraticFamily family = family_of(RandomSphereFamily(seed).spheres());
    if (unreal_place(family)) continue;
    const FamilyInDoubles doubles(family);
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const ExactPatch lune = corner_lune(family, edge);
      REQUIRE(lune.boundary.size() == 2);
      CHECK(lune.boundary[0](1) == lune.boundary[1](0));
      CHECK(lune.boundary[1](1) == lune.boundary[0](0));
      const auto x = lune.sections(128);
      const auto [u, v] = on_edge((edge + 1) % 3, 0);
      const Eigen::Vector4d sphere = doubles.at(u, v);
      const NormalArc after = end_arc(family, (edge + 1) % 3, 0), before = end_arc(family, edge, 1);
      for (const double at : {0.0, 0.25, 0.5, 1.0}) {
        const PointAndNormal a = at_place(x, lune.boundary[0](at)),
                             b = at_place(x, lune.boundary[1](1 - at));
        CHECK((a.normal - after(at)).norm() < 1e-13);
        CHECK((b.normal - before(at)).norm() < 1e-13);
        CHECK((a.point - sphere.head<3>() + sphere(3) * a.normal).norm() < 1e-13 * sphere.norm());
      }
    }
  }
}
