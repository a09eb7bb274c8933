// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/flat_sheet.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"
#include "pn/algebra/precision.hpp"
#include "random_translational_families.hpp"

using namespace pn;
using namespace pn::test;
using Eigen::Vector3d;

namespace {

using Spheres = std::array<std::array<double, 4>, 3>;

/// Both sheets of a family that are flat are planes with unit normals, over its own parameters.
void check_flat(const TranslationalFamily& family, Sheet sheet) {
  REQUIRE(is_flat(family, sheet));
  const SkinPatch patch = flat_patch(family, sheet);
  const SurfaceSections<RealBall> x = patch.sections(kLeastPrecision);
  RealBall length;
  Vector3d n;
  for (std::size_t c = 0; c < 3; ++c) {
    const RealBall component = x.direction[c].at(RealBall(0.25), RealBall(0.5));
    length += component * component;
    n(static_cast<Eigen::Index>(c)) = component.midpoint();
  }
  CHECK(encloses_zero(length - RealBall(1), 1e-30));
  const FamilyInDoubles doubles(quadratic_family(family));
  const auto point = [&](const std::array<double, 2>& at) {
    Vector3d result;
    for (std::size_t c = 0; c < 3; ++c) {
      result(static_cast<Eigen::Index>(c)) =
          x.point[c].at(RealBall(at[0]), RealBall(at[1])).midpoint();
    }
    return result;
  };
  for (const auto& [u, v] : {std::array{0.0, 0.0}, {0.25, 0.75}, {1.0, 0.5}}) {
    CHECK((doubles.normal(sheet, u, v) - n).norm() < 1e-14);
    const Eigen::Vector4d sphere = doubles.at(u, v);
    const auto place = patch.place_of({u, v});
    CHECK((point(place) - (sphere.head<3>() - sphere(3) * n)).norm() < 1e-13);
    const double h = 1e-6;
    const Vector3d along = point({place[0] + h, place[1]}) - point(place),
                   around = point({place[0], place[1] + h}) - point(place);
    CHECK(along.cross(around).normalized().dot(n) > 1 - 1e-6);
  }
}

}  // namespace

TEST_CASE("Two lines give two planes", "[flat_sheet]") {
  const TranslationalFamily family = family_of({{{0, 0, 0, 1}, {2, 0, 1, 1.5}, {4, 0, 2, 2}}},
                                               {{{0, 0, 0, 1}, {0, 2, 0, 0.75}, {0, 4, 0, 0.5}}});
  check_flat(family, Sheet::kOuter);
  check_flat(family, Sheet::kInner);
}

TEST_CASE("Spheres that touch one plane have it for a sheet", "[flat_sheet]") {
  // r = z + 5
  const TranslationalFamily family = family_of({{{0, 0, 0, 3}, {2, 0, 1, 4}, {4, 0, 0, 3}}},
                                               {{{0, 0, 0, 2}, {0, 2, -1, 1}, {0, 4, 0, 2}}});
  check_flat(family, Sheet::kInner);
  CHECK_FALSE(is_flat(family, Sheet::kOuter));
}
