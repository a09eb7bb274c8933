// SPDX-License-Identifier: LGPL-2.1-or-later
// Skins of special families of spheres: what every skin promises, by whatever chart it is reached.
#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/shapes/sphere_family.hpp"
#include "special_sphere_families.hpp"

using namespace pn;
using namespace pn::test;
using Eigen::Vector3d;
using Parameters = std::array<double, 2>;

namespace {

/// In [mm], for plates of 100 mm in doubles.
constexpr double kNear = 1e-10;

/// The section at distance d, and its unit normal.
struct SectionPoint {
  Vector3d point, normal;

  SectionPoint(const SurfaceSections<RealBall>& x, double d, const Parameters& place) {
    const auto value = [&](const TensorPolynomial<RealBall>& f) {
      return f.at(RealBall(place[0]), RealBall(place[1]));
    };
    const RealBall weight = value(x.weight);
    CHECK(weight.is_positive());
    RealBall length;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<Eigen::Index>(c);
      const RealBall n = value(x.direction[c]) / weight;
      length += n * n;
      normal(i) = n.midpoint();
      point(i) = (value(x.point[c]) / weight).midpoint() + d * normal(i);
    }
    CHECK(encloses_zero(length - RealBall(1), 1e-20));
  }
};

/// The patch lies on the envelope over its part of the triangle, seen from outside.
void check_patch(const QuadraticFamily& family, const PlacedPatch& placed, Sheet sheet) {
  const auto& [patch, corners] = placed;
  const SurfaceSections<RealBall> x = patch.sections(kLeastPrecision);
  const FamilyInDoubles whole(family);
  // The patch's own triangle has its corners at (0, 0), (1, 0), (0, 1).
  for (const auto& [a, b] : {Parameters{0, 0},
                             {1, 0},
                             {0, 1},
                             {0.5, 0},
                             {0, 0.25},
                             {0.25, 0.75},
                             {0.3, 0.3},
                             {0.1, 0.6}}) {
    Parameters uv;
    for (std::size_t c = 0; c < 2; ++c) {
      uv[c] =
          corners[0][c] + a * (corners[1][c] - corners[0][c]) + b * (corners[2][c] - corners[0][c]);
    }
    const Parameters place = patch.place_of({a, b});
    CHECK((place[0] >= 0 && place[0] <= 1 && place[1] >= 0 && place[1] <= 1));
    const double d = 0.5;
    const SectionPoint found(x, d, place);
    const Vector3d n = whole.normal(sheet, uv[0], uv[1]);
    const Eigen::Vector4d sphere = whole.at(uv[0], uv[1]);
    CHECK((found.normal - n).norm() < 1e-11);
    CHECK((found.point - (sphere.head<3>() + (d - sphere(3)) * n)).norm() < kNear);
  }
  const double h = 1e-5;
  const Parameters middle = patch.place_of({1.0 / 3, 1.0 / 3});
  const SectionPoint here(x, 0, middle);
  const Vector3d by_p = SectionPoint(x, 0, {middle[0] + h, middle[1]}).point - here.point,
                 by_q = SectionPoint(x, 0, {middle[0], middle[1] + h}).point - here.point;
  CHECK(by_p.cross(by_q).dot(here.normal) > 0);
}

std::array<int, 2> checked_degree(const ControlSpheres& spheres, Sheet sheet) {
  const QuadraticFamily family = sphere_family(spheres).family;
  const auto patches = skin_patches(family, sheet);
  CHECK(patches.size() == 1);
  for (const PlacedPatch& placed : patches) check_patch(family, placed, sheet);
  return patches.front().patch.degree;
}

constexpr std::array<Sheet, 2> kSheets = {Sheet::kOuter, Sheet::kInner};

}  // namespace

TEST_CASE("Separated skins are patches in the family's own parameters", "[special_skins]") {
  for (const auto& [name, spheres] : separated_spheres()) {
    INFO(name);
    if (name == "spheres through one line") continue;
    for (const Sheet sheet : kSheets) {
      const auto degree = checked_degree(spheres, sheet);
      CHECK(degree[0] <= 6);
      CHECK(degree[1] <= 6);
    }
  }
}

TEST_CASE("Developable skins are ruled patches", "[special_skins]") {
  for (const auto& [name, spheres] : developable_spheres()) {
    INFO(name);
    for (const Sheet sheet : kSheets) {
      const auto degree = checked_degree(spheres, sheet);
      CHECK(std::min(degree[0], degree[1]) == 1);
      CHECK(std::max(degree[0], degree[1]) <= 6);
    }
  }
}

TEST_CASE("A base point may lie anywhere, and be a multiple root", "[special_skins]") {
  for (const auto& [name, spheres] : spheres_with_parabolic_line()) {
    INFO(name);
    for (const Sheet sheet : kSheets) checked_degree(spheres, sheet);
  }
}
