// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/polar_chart.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/bezier/box_chart.hpp"
#include "random_sphere_families.hpp"

using namespace pn;
using namespace pn::test;
using Eigen::Vector3d;

namespace {

Vector3d point(const SurfaceSections<RealBall>& x, double d, const std::array<double, 2>& at) {
  const auto value = [&](const TensorPolynomial<RealBall>& f) {
    return f.at(RealBall(at[0]), RealBall(at[1])).midpoint();
  };
  Vector3d result;
  for (int i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    result(i) = (value(x.point[c]) + d * value(x.direction[c])) / value(x.weight);
  }
  return result;
}

}  // namespace

TEST_CASE("Where normals fold in the triangle, a chart around the base point covers the sheet",
          "[polar_chart]") {
  std::size_t folded = 0, covered = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const QuadraticFamily family = family_of(RandomSphereFamily(seed).spheres());
    if (unreal_place(family)) continue;
    const FamilyInDoubles doubles(family);
    for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
      const auto box = box_patch(family, sheet);
      if (box && box->weight_ratio > 0) continue;
      ++folded;
      for (const SkinPatch& patch : polar_patches(family, sheet)) {
        if (!(patch.weight_ratio > 0)) continue;
        if (patch.weight_ratio > 0.05) ++covered;
        CHECK(patch.degree == std::array{8, 10});
        const SurfaceSections<RealBall> x = patch.sections(128);
        for (const auto& [u, v] : {std::array{0.3, 0.3}, {0.1, 0.7}, {0.0, 0.0}, {0.6, 0.4}}) {
          const Eigen::Vector4d sphere = doubles.at(u, v);
          const double d = 0.125;
          const Vector3d expected =
              sphere.head<3>() + (d - sphere(3)) * doubles.normal(sheet, u, v);
          const auto at = patch.place_of({u, v});
          CHECK((at[0] > 0 && at[0] < 1 && at[1] > 0 && at[1] < 1));
          CHECK((point(x, d, at) - expected).norm() < 1e-10 * (1 + expected.norm()));
        }
      }
    }
  }
  CHECK(folded > 3);
  CHECK(4 * covered > folded);
}
