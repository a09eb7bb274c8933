// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/circle_chart.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/algebra/precision.hpp"
#include "random_translational_families.hpp"

using namespace pn;
using namespace pn::test;
using Eigen::Vector3d;

namespace {

using Spheres = std::array<std::array<double, 4>, 3>;

const Spheres kArch = {{{0, 0, 0, 1}, {5, 0, 2, 1.25}, {10, 0, 0, 1}}},
              kAcross = {{{0, 0, 0, 1}, {0, 5, 1, 1}, {0, 10, -0.5, 1.5}}},
              kLine = {{{0, 0, 0, 1}, {5, 0, 1, 1}, {10, 0, 2, 1}}},
              // c'' is steeper in the radius than in the centre: the plane of c is time-like.
    kTimeLike = {{{0, 0, 0, 1}, {5, 0, 0.25, 2.5}, {10, 0, 0, 1}}},
              // Both derivatives have the direction of x.
    kUneven = {{{0, 0, 0, 1}, {4, 0, 0, 1}, {10, 0, 0, 1}}};

/// The point of the section at distance d.
Vector3d point(const SurfaceSections<RealBall>& x, double d, const std::array<double, 2>& place) {
  const auto value = [&](const TensorPolynomial<RealBall>& f) {
    return f.at(RealBall(place[0]), RealBall(place[1])).midpoint();
  };
  Vector3d result;
  for (int i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    result(i) = (value(x.point[c]) + d * value(x.direction[c])) / value(x.weight);
  }
  return result;
}

void check_patch(const TranslationalFamily& family, Sheet sheet, const SkinPatch& patch) {
  const SurfaceSections<RealBall> x = patch.sections(kLeastPrecision);
  const FamilyInDoubles doubles(quadratic_family(family));
  double size = 0;
  for (const double v : {0.0, 0.4, 1.0}) {
    for (const double u : {0.0, 0.3, 1.0}) {
      const auto place = patch.place_of({u, v});
      // Lines u = const are parameter lines, the first and the last the sides of the patch.
      if (u == 0 || u == 1) CHECK(place[0] == u);
      CHECK((place[1] > 0 && place[1] < 1));
      const Eigen::Vector4d sphere = doubles.at(u, v);
      size = std::max(size, sphere.norm());
      const Vector3d n = doubles.normal(sheet, u, v);
      for (const double d : {0.0, 0.75}) {
        const Vector3d expected = sphere.head<3>() + (d - sphere(3)) * n;
        CHECK((point(x, d, place) - expected).norm() < 1e-12 * size);
      }
      const double h = 1e-6;
      const Vector3d along = point(x, 0, {place[0] + h, place[1]}) - point(x, 0, place),
                     around = point(x, 0, {place[0], place[1] + h}) - point(x, 0, place);
      CHECK(along.cross(around).normalized().dot(n) > 0.99);
    }
  }
}

}  // namespace

TEST_CASE("Points of a patch are the sheet's points by its definition", "[circle_chart]") {
  for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
    for (const auto& c : {kArch, kLine, kUneven, kTimeLike}) {
      const TranslationalFamily family = family_of(c, kAcross);
      REQUIRE_FALSE(unreal_place(family));
      const auto patch = circle_patch(family, sheet);
      REQUIRE(patch);
      CHECK(patch->sheet == sheet);
      check_patch(family, sheet, *patch);
    }
  }
}

TEST_CASE("Circle charts have the degrees of the theorem", "[circle_chart]") {
  const auto degree = [](const Spheres& c) {
    return circle_patch(family_of(c, kAcross), Sheet::kOuter)->degree;
  };
  CHECK(degree(kArch) == std::array{8, 6});
  CHECK(degree(kTimeLike) == std::array{10, 6});
  CHECK(degree(kUneven) == std::array{2, 6});
  CHECK(degree(kLine) == std::array{1, 6});
}

TEST_CASE("There is no chart where d is a line", "[circle_chart]") {
  CHECK_FALSE(circle_patch(family_of(kAcross, kLine), Sheet::kOuter));
}

TEST_CASE("A chart without positive weights is none: across a line of inflection",
          "[circle_chart]") {
  // d'' is tangential to the outer sheet along u = 1/2, where c' has the direction of x: there is Q
  // = 0.
  const TranslationalFamily family = family_of({{{0, 0, 0, 1}, {5, 0, 2, 1}, {10, 0, 0, 1}}},
                                               {{{0, 0, 0, 1}, {1, 5, 0, 1}, {0, 10, 0, 1}}});
  REQUIRE_FALSE(unreal_place(family));
  for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
    CHECK_FALSE(circle_patch(family, sheet));
    const auto other = circle_patch(family.exchanged(), opposite(sheet));
    REQUIRE(other);
    check_patch(family.exchanged(), opposite(sheet), *other);
  }
}

TEST_CASE("Curves that are straight but for rounding are no harder", "[circle_chart]") {
  const double tiny = 1e-14;
  const Spheres rounded = {{{0, 0, 0, 1}, {5, 0, 1 + tiny, 1}, {10, 0, 2, 1}}},
                across = {{{0, 0, 0, 1}, {0, 5, tiny, 1.25}, {0, 10, 0, 1.5 + tiny}}};
  for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
    // Narrow arcs that do not drift have a chart; narrow ones on circles that turn have none, but
    // those that turn on narrow circles do.
    const TranslationalFamily plate = family_of(rounded, across), arch = family_of(kArch, across);
    const auto flat = circle_patch(plate, sheet);
    REQUIRE(flat);
    check_patch(plate, sheet, *flat);
    CHECK_FALSE(circle_patch(arch, sheet));
    const auto other = circle_patch(arch.exchanged(), opposite(sheet));
    REQUIRE(other);
    check_patch(arch.exchanged(), opposite(sheet), *other);
  }
}
