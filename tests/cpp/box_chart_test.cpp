// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/box_chart.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "random_sphere_families.hpp"

using namespace pn;
using namespace pn::test;
using Eigen::Vector3d;

namespace {

/// The point of the section at distance d.
Vector3d point(const SurfaceSections<RealBall>& x, double d, double p, double q) {
  const auto value = [&](const TensorPolynomial<RealBall>& f) {
    return f.at(RealBall(p), RealBall(q)).midpoint();
  };
  Vector3d result;
  for (int i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    result(i) = (value(x.point[c]) + d * value(x.direction[c])) / value(x.weight);
  }
  return result;
}

}  // namespace

TEST_CASE("The edges of a patch are the skin's points over those of the triangle", "[box_chart]") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const QuadraticFamily family = family_of(RandomSphereFamily(seed).spheres());
    const FamilyInDoubles doubles(family);
    for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
      const auto patch = box_patch(family, sheet);
      REQUIRE(patch);
      if (!(patch->weight_ratio > 0)) continue;
      const SurfaceSections<RealBall> x = patch->sections(128);
      const auto edges = boundary(*patch);
      double area = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& edge = edges[k];
        CHECK(edge(1) == edges[(k + 1) % 3](0));
        for (int i = 0; i < 8; ++i) {
          const auto a = edge(i / 8.0), b = edge((i + 1) / 8.0);
          area += (a[0] * b[1] - a[1] * b[0]) / 2;
        }
        for (const double at : {0.0, 0.3, 0.8}) {
          const auto [p, q] = edge(at);
          CHECK((p > 0 && p < 1 && q > 0 && q < 1));
          const std::array<std::array<double, 2>, 3> corner = {{{0, 0}, {1, 0}, {0, 1}}};
          const std::size_t edge_of = sheet == Sheet::kOuter ? k : 2 - k;
          const double s = sheet == Sheet::kOuter ? at : 1 - at;
          const auto &from = corner[edge_of], &to = corner[(edge_of + 1) % 3];
          const double u = from[0] + s * (to[0] - from[0]), v = from[1] + s * (to[1] - from[1]);
          const Eigen::Vector4d sphere = doubles.at(u, v);
          const double d = 0.25;
          const Vector3d expected =
              sphere.head<3>() + (d - sphere(3)) * doubles.normal(sheet, u, v);
          CHECK((point(x, d, p, q) - expected).norm() < 1e-11 * (1 + expected.norm()));
        }
      }
      CHECK(area > 0.2);
    }
  }
}
