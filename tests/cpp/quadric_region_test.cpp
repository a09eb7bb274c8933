// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric_region.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "error_code.hpp"

using namespace pn;
using Eigen::Vector3d;

namespace {

/// The unit sphere and its circles.
QuadricSections sphere() {
  return {[](std::size_t axis, double value) -> std::optional<BoundaryConic> {
            if (std::abs(value) >= 1) return std::nullopt;
            const double r = std::sqrt(1 - value * value);
            return BoundaryConic{
                [=](double t) {
                  Vector3d p;
                  p(static_cast<Eigen::Index>(axis)) = value;
                  p(static_cast<Eigen::Index>((axis + 1) % 3)) = r * std::cos(2 * M_PI * t);
                  p(static_cast<Eigen::Index>((axis + 2) % 3)) = r * std::sin(2 * M_PI * t);
                  return p;
                },
                true};
          },
          [](double angle) -> BoundaryConic {
            return {[=](double t) {
                      const double s = std::sin(M_PI * t);
                      return Vector3d(s * std::cos(angle), s * std::sin(angle), std::cos(M_PI * t));
                    },
                    false};
          }};
}

std::vector<BoundaryLoop> loops_of(const QuadricBounds& bounds,
                                   const std::vector<Vector3d>& stops = {}) {
  return boundary_loops(bounds, sphere(), 1, stops);
}

QuadricBounds box(const Interval& x, const Interval& y, const Interval& z) {
  return {{x, y, z}, std::nullopt};
}

QuadricBounds sector(double low, double high) {
  QuadricBounds bounds;
  bounds.angle = Interval{low, high};
  return bounds;
}

/// Closed, on the sphere, and inside the bounds but for rounding.
void check_loops(const std::vector<BoundaryLoop>& loops, const QuadricBounds& bounds) {
  QuadricBounds wider = bounds;
  for (Interval& interval : wider.box) interval = {interval.low - 1e-9, interval.high + 1e-9};
  for (const BoundaryLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      CHECK((loop[i](1) - loop[(i + 1) % loop.size()](0)).norm() < kSamePoint);
      for (const double s : {0.1, 0.5, 0.9}) {
        const Vector3d p = loop[i](s);
        CHECK(p.norm() == Approx(1));
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double x = p(static_cast<Eigen::Index>(axis));
          CHECK(x >= wider.box[axis].low);
          CHECK(x <= wider.box[axis].high);
        }
      }
    }
  }
}

std::optional<ErrorCode> refusal(const QuadricBounds& bounds) {
  return test::code_of([&] { require_bounds(bounds); });
}

}  // namespace

TEST_CASE("Bounds that miss the surface leave no loop", "[quadric_region]") {
  CHECK(loops_of({}).empty());
  CHECK(loops_of(box({-2, 2}, {}, {-3, 4})).empty());
}

TEST_CASE("One plane cuts one loop, two parallel ones cut two", "[quadric_region]") {
  const QuadricBounds cap = box({}, {}, {0.5, 2}), zone = box({}, {}, {-0.25, 0.5});
  CHECK(loops_of(cap).size() == 1);
  CHECK(loops_of(zone).size() == 2);
  check_loops(loops_of(cap), cap);
  check_loops(loops_of(zone), zone);
}

TEST_CASE("Planes that cut each other share a loop of arcs", "[quadric_region]") {
  const QuadricBounds corner = box({0.1, 2}, {0.2, 2}, {0.3, 2});
  const auto loops = loops_of(corner);
  REQUIRE(loops.size() == 1);
  CHECK(loops[0].size() == 3);
  check_loops(loops, corner);
}

TEST_CASE("A bar through the sphere cuts two loops of four arcs", "[quadric_region]") {
  const QuadricBounds bar = box({-0.25, 0.5}, {-0.5, 0.25}, {});
  const auto loops = loops_of(bar);
  REQUIRE(loops.size() == 2);
  CHECK(loops[0].size() == 4);
  CHECK(loops[1].size() == 4);
  check_loops(loops, bar);
}

TEST_CASE("A sector runs from pole to pole and back", "[quadric_region]") {
  for (const auto& [low, high] : {std::pair{0.25, 2.0}, {0.25, 5.0}, {-1.0, 0.5}}) {
    const auto loops = loops_of(sector(low, high));
    REQUIRE(loops.size() == 1);
    REQUIRE(loops[0].size() == 2);
    for (const auto& arc : loops[0]) {
      const Vector3d middle = arc(0.5);
      const double angle = std::atan2(middle.y(), middle.x());
      const double off = std::min(std::abs(std::remainder(angle - low, 2 * M_PI)),
                                  std::abs(std::remainder(angle - high, 2 * M_PI)));
      CHECK(off < 1e-9);
    }
    check_loops(loops, {});
  }
}

TEST_CASE("Arcs end at the stops that they pass through", "[quadric_region]") {
  const Vector3d stop(0, std::sqrt(0.75), 0.5), beside(0, 1, 0);
  const QuadricBounds cap = box({}, {}, {0.5, 2});
  CHECK(loops_of(cap, {beside})[0].size() == 1);
  const auto loops = loops_of(cap, {stop});
  REQUIRE(loops.size() == 1);
  const BoundaryLoop& loop = loops[0];
  const bool ends_there = std::any_of(loop.begin(), loop.end(), [&](const auto& arc) {
    return (arc(0) - stop).norm() < kSamePoint;
  });
  CHECK(ends_there);
}

TEST_CASE("A point is inside when all bounds hold", "[quadric_region]") {
  QuadricBounds bounds = box({0, 1}, {}, {-1, 0.5});
  CHECK(is_inside(bounds, {0.5, 20, 0}));
  CHECK_FALSE(is_inside(bounds, {0.5, 20, 0.75}));
  CHECK_FALSE(is_inside(bounds, {-0.5, 20, 0}));
  bounds.angle = Interval{0.5, 4};
  CHECK(is_inside(bounds, {0.5, 0.5, 0}));
  CHECK_FALSE(is_inside(bounds, {0.5, 0.1, 0}));
  CHECK_FALSE(is_inside(bounds, {0.5, -0.5, 0}));
  // The same sector a turn further.
  bounds.angle = Interval{0.5 + 2 * M_PI, 4 + 2 * M_PI};
  CHECK(is_inside(bounds, {0.5, 0.5, 0}));
}

TEST_CASE("Empty, inverted and undefined bounds are refused", "[quadric_region]") {
  CHECK(refusal(box({1, 1}, {}, {})) == ErrorCode::kBadBounds);
  CHECK(refusal(box({}, {2, 1}, {})) == ErrorCode::kBadBounds);
  CHECK(refusal(box({}, {}, {0, NAN})) == ErrorCode::kNotFinite);
  CHECK(refusal(sector(2, 1)) == ErrorCode::kBadBounds);
  CHECK(refusal(sector(0, HUGE_VAL)) == ErrorCode::kBadBounds);
  CHECK_NOTHROW(require_bounds(box({0, 1}, {-HUGE_VAL, 3}, {})));
}

TEST_CASE("Bounds that cross in one point on the surface cut a corner there", "[quadric_region]") {
  // The circles z = 0.6 and x = 0.8 touch in (0.8, 0, 0.6): the smaller one bounds by itself.
  const QuadricBounds touching = box({-2, 0.8}, {}, {0.6, 2});
  const auto loops = loops_of(touching);
  REQUIRE(loops.size() == 1);
  check_loops(loops, touching);
}
