// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "error_code.hpp"
#include "pn/bezier/pn_surface.hpp"

using namespace pn;

namespace {

struct Example {
  QuadricKind kind;
  std::array<double, 3> half_axes;
  QuadricBounds bounds;
  std::array<int, 2> degree;
  /// Zero on the surface.
  double (*equation)(const std::array<double, 3>& p);
  /// Positive for normals of positive distances.
  double (*side)(const std::array<double, 3>& p, const std::array<double, 3>& n);
};

QuadricBounds box(const Interval& x, const Interval& y, const Interval& z) {
  return {{x, y, z}, std::nullopt};
}

using Point = std::array<double, 3>;

double outwards(const Point& p, const Point& n) { return p[0] * n[0] + p[1] * n[1] + p[2] * n[2]; }
double from_axis(const Point& p, const Point& n) { return p[0] * n[0] + p[1] * n[1]; }
double upwards(const Point&, const Point& n) { return n[2]; }
double downwards(const Point&, const Point& n) { return -n[2]; }

/// Every kind, with half-axes 3, 2, 1 where they may differ.
std::vector<Example> examples() {
  const QuadricBounds square = box({-1, 1.5}, {-1, 1}, {}), heights = box({}, {}, {1, 2});
  return {{QuadricKind::kEllipsoid,
           {3, 2, 1},
           {},
           {8, 4},
           [](const Point& p) { return p[0] * p[0] / 9 + p[1] * p[1] / 4 + p[2] * p[2] - 1; },
           outwards},
          {QuadricKind::kOneSheetHyperboloid,
           {3, 2, 1},
           heights,
           {4, 4},
           [](const Point& p) { return p[0] * p[0] / 9 + p[1] * p[1] / 4 - p[2] * p[2] - 1; },
           from_axis},
          {QuadricKind::kTwoSheetHyperboloid,
           {3, 2, 1},
           heights,
           {8, 4},
           [](const Point& p) { return p[2] * p[2] - p[0] * p[0] / 9 - p[1] * p[1] / 4 - 1; },
           downwards},
          {QuadricKind::kEllipticParaboloid,
           {3, 2, 1},
           square,
           {6, 4},
           [](const Point& p) { return p[2] - p[0] * p[0] / 9 - p[1] * p[1] / 4; },
           downwards},
          {QuadricKind::kHyperbolicParaboloid,
           {3, 2, 1},
           square,
           {5, 4},
           [](const Point& p) { return p[2] - p[0] * p[0] / 9 + p[1] * p[1] / 4; },
           upwards},
          {QuadricKind::kEllipticCylinder,
           {2, 2, 1},
           heights,
           {1, 2},
           [](const Point& p) { return p[0] * p[0] / 4 + p[1] * p[1] / 4 - 1; },
           from_axis},
          {QuadricKind::kEllipticCone,
           {2, 2, 1},
           heights,
           {1, 2},
           [](const Point& p) { return p[0] * p[0] / 4 + p[1] * p[1] / 4 - p[2] * p[2]; },
           from_axis},
          {QuadricKind::kParabolicCylinder,
           {3, 2, 1},
           square,
           {7, 1},
           [](const Point& p) { return p[2] - p[0] * p[0] / 9; },
           downwards}};
}

std::vector<SurfacePoint> samples(const PNSurface& surface) {
  std::vector<double> t, v;
  for (const BSplineSurface& face : surface.faces(Lines::kEven)) {
    for (const double along : {0.25, 0.5, 0.75}) {
      for (const double across : {0.3, 0.6}) {
        t.push_back(face.u_knots.front() * (1 - along) + face.u_knots.back() * along);
        v.push_back(face.v_knots.front() * (1 - across) + face.v_knots.back() * across);
      }
    }
  }
  return surface.evaluate(t, v);
}

std::optional<ErrorCode> refusal(QuadricKind kind, const std::array<double, 3>& half_axes,
                                 const QuadricBounds& bounds) {
  return test::code_of([&] { quadric(kind, half_axes, bounds); });
}

}  // namespace

TEST_CASE("Every kind satisfies its equation and has its side", "[quadric]") {
  for (const Example& example : examples()) {
    const PNSurface surface(quadric(example.kind, example.half_axes, example.bounds));
    CHECK(surface.degree() == example.degree);
    for (const auto& [point, normal] : samples(surface)) {
      CHECK(std::abs(example.equation(point)) < 1e-12);
      CHECK(example.side(point, normal) > 0);
      CHECK(outwards(normal, normal) == Approx(1));
    }
  }
}

TEST_CASE("Half-axes that count must be positive numbers", "[quadric]") {
  const QuadricBounds square = box({-1, 1}, {-1, 1}, {});
  CHECK(refusal(QuadricKind::kEllipsoid, {3, 0, 1}, {}) == ErrorCode::kBadAxis);
  CHECK(refusal(QuadricKind::kEllipsoid, {3, -2, 1}, {}) == ErrorCode::kBadAxis);
  CHECK(refusal(QuadricKind::kEllipsoid, {3, NAN, 1}, {}) == ErrorCode::kNotFinite);
  // Those that do not count may be anything.
  CHECK_FALSE(refusal(QuadricKind::kParabolicCylinder, {3, -1, 1}, square));
}

TEST_CASE("Developable quadrics are rational only of revolution", "[quadric]") {
  const QuadricBounds heights = box({}, {}, {1, 2});
  CHECK(refusal(QuadricKind::kEllipticCylinder, {3, 2, 1}, heights) == ErrorCode::kNotRational);
  CHECK(refusal(QuadricKind::kEllipticCone, {3, 2, 1}, heights) == ErrorCode::kNotRational);
}

TEST_CASE("Infinite surfaces need bounds, bounds need a surface", "[quadric]") {
  for (const QuadricKind kind :
       {QuadricKind::kOneSheetHyperboloid, QuadricKind::kTwoSheetHyperboloid,
        QuadricKind::kEllipticParaboloid, QuadricKind::kHyperbolicParaboloid}) {
    CHECK(refusal(kind, {3, 2, 1}, {}) == ErrorCode::kRegionUnbounded);
  }
  CHECK(refusal(QuadricKind::kEllipsoid, {3, 2, 1}, box({}, {}, {2, 3})) ==
        ErrorCode::kRegionEmpty);
  CHECK(refusal(QuadricKind::kEllipsoid, {3, 2, 1}, box({}, {}, {1, 0})) == ErrorCode::kBadBounds);
}
