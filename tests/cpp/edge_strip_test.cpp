// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/edge_strip.hpp"

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

TEST_CASE("A strip touches the spheres of its edge outside the triangle", "[edge_strip]") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const QuadraticFamily family = family_of(RandomSphereFamily(seed).spheres());
    if (unreal_place(family)) continue;
    const FamilyInDoubles doubles(family);
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const ExactPatch strip = edge_strip(family, edge, {}, {0.5});
      CHECK(strip.degree == std::array{4, 4});
      CHECK(strip.boundary.size() == 5);
      const auto x = strip.sections(128);
      for (const double t : {0.0, 0.3, 1.0}) {
        // Half way between the seams.
        const double low = strip.boundary[0](t)[1];
        const double high =
            t < 0.5 ? strip.boundary[3](1 - 2 * t)[1] : strip.boundary[2](2 - 2 * t)[1];
        CHECK((0 < low && low < high && high < 1));
        const PointAndNormal middle = at_place(x, {t, (low + high) / 2});
        const auto [u, v] = on_edge(edge, t);
        const Eigen::Vector4d sphere = doubles.at(u, v);
        const double size = sphere.norm();
        CHECK((middle.point - sphere.head<3>() + sphere(3) * middle.normal).norm() < 1e-12 * size);
        const auto start = on_edge(edge, 0), end = on_edge(edge, 1),
                   opposite = on_edge((edge + 2) % 3, 0);
        const auto slope = [&](double du, double dv) {
          const Eigen::Vector4d f = du * doubles.by_u(u, v) + dv * doubles.by_v(u, v);
          return middle.normal.dot(f.head<3>()) - f(3);
        };
        CHECK(std::abs(slope(end[0] - start[0], end[1] - start[1])) < 1e-11 * size);
        CHECK(slope(opposite[0] - u, opposite[1] - v) < 0);
      }
    }
  }
}

TEST_CASE("At its seams a strip has the points and normals of the skins", "[edge_strip]") {
  const QuadraticFamily family = family_of(RandomSphereFamily(1).spheres());
  const FamilyInDoubles doubles(family);
  const ExactPatch strip = edge_strip(family, 1, {}, {});
  const auto x = strip.sections(128);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(strip.boundary[k](1) == strip.boundary[(k + 1) % 4](0));
  }
  for (const double t : {0.0, 0.25, 0.8, 1.0}) {
    const auto [u, v] = on_edge(1, t);
    CHECK((at_place(x, strip.boundary[0](t)).normal - doubles.normal(Sheet::kInner, u, v)).norm() <
          1e-12);
    CHECK((at_place(x, strip.boundary[2](1 - t)).normal - doubles.normal(Sheet::kOuter, u, v))
              .norm() < 1e-12);
  }
}
