// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/translational_spheres.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "error_code.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Spheres = std::vector<std::array<double, 4>>;

const Spheres kAlongX = {{0, 0, 0, 1}, {5, 0, 1, 1.5}, {10, 0, 0, 1}},
              kAlongY = {{0, 0, 0, 1}, {0, 5, 1, 1}, {0, 10, 0, 1.5}};

TranslationalSpheres translation(const Spheres& c, const Spheres& d) {
  return translational_spheres(SphereSpline::bezier(c), SphereSpline::bezier(d));
}

std::optional<ErrorCode> refusal(const Spheres& c, const Spheres& d) {
  return code_of([&] { translation(c, d); });
}

}  // namespace

TEST_CASE("Spheres are added, span by span", "[translational_spheres]") {
  const SphereSpline c = SphereSpline::bspline(
      {2, {0, 1, 3}, {3, 1, 3}, {{0, 0, 0, 1}, {5, 0, 1, 1}, {10, 0, 0, 2}, {20, 0, 0, 1}}, {}});
  const TranslationalSpheres result = translational_spheres(c, SphereSpline::bezier(kAlongY));
  REQUIRE(result.spline.c.spans.size() == 2);
  REQUIRE(result.spline.d.spans.size() == 1);
  CHECK(result.spline.c.breaks == c.function().breaks);
  CHECK(result.notes.empty());
  const SphereParabola &first = result.spline.c.spans[0], &second = result.spline.c.spans[1];
  CHECK(first.start == MinkowskiVector<Rational>{0L, 0L, 0L, -1L});
  // C1 in the spline's parameter, and spans of the lengths 1 and 2.
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(first.slope(1L)[i] * Rational(2L) == second.first[i]);
  }
}

TEST_CASE("Curves of equal radii are said to be an offset of the mid-surface",
          "[translational_spheres]") {
  Spheres c = kAlongX, d = kAlongY;
  for (auto& sphere : c) sphere[3] = 1;
  for (auto& sphere : d) sphere[3] = 0.5;
  REQUIRE(translation(c, d).notes.size() == 1);
  CHECK(translation(c, d).notes[0].find("offsets of the mid-surface") != std::string::npos);
}

TEST_CASE("Curves of degree 3 that are quadratic are taken as such", "[translational_spheres]") {
  // The parabola (0, 0), (6, 6), (12, 0) with its degree raised.
  const Spheres raised = {{0, 0, 0, 1}, {4, 0, 4, 1}, {8, 0, 4, 1}, {12, 0, 0, 1}};
  CHECK_FALSE(refusal(raised, kAlongY));
  Spheres cubic = raised;
  cubic[1][2] = 5;
  CHECK(refusal(cubic, kAlongY) == ErrorCode::kNotRational);
  CHECK(refusal(kAlongY, cubic) == ErrorCode::kNotRational);
}

TEST_CASE("Curves of spheres without skins are refused with a reason", "[translational_spheres]") {
  for (const double bad : {double(NAN), double(INFINITY)}) {
    Spheres c = kAlongX;
    c[1][2] = bad;
    CHECK(refusal(c, kAlongY) == ErrorCode::kNotFinite);
  }
  CHECK(refusal(kAlongX, {{1, 2, 3, 1}, {1, 2, 3, 1}}) == ErrorCode::kZeroLength);
  CHECK(refusal(kAlongX, kAlongX) == ErrorCode::kZeroLength);
  // In one direction at one pair of parameters only.
  CHECK(refusal({{0, 0, 0, 1}, {5, 0, 0, 1}, {10, 5, 0, 1}},
                {{0, 0, 0, 1}, {0, 5, 0, 1}, {5, 10, 0, 1}}) == ErrorCode::kZeroLength);
  Spheres steep = kAlongX;
  steep[2][3] = 9;
  CHECK(refusal(steep, kAlongY) == ErrorCode::kRadiusTooSteep);
  CHECK(refusal(kAlongY, steep) == ErrorCode::kRadiusTooSteep);
}

TEST_CASE("Corners are refused, joints of one direction are not", "[translational_spheres]") {
  const auto refused = [](const std::array<double, 4>& last) {
    const BSplineData<4> data{2,
                              {0, 1, 2},
                              {3, 2, 3},
                              {{0, 0, 0, 1}, {5, 0, 1, 1}, {10, 0, 2, 1}, last, {30, 0, 1, 1}},
                              {}};
    return code_of(
        [&] { translational_spheres(SphereSpline::bspline(data), SphereSpline::bezier(kAlongY)); });
  };
  CHECK_FALSE(refused({20, 0, 4, 1}));
  CHECK(refused({20, 0, 4, 1.25}) == ErrorCode::kCornerTooSharp);
  CHECK(refused({20, 0, 3, 1}) == ErrorCode::kCornerTooSharp);
  CHECK(refused({5, 0, 1, 1}) == ErrorCode::kCornerTooSharp);  // back in itself
}
