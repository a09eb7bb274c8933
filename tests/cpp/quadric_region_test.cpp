// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric_region.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "error_code.hpp"

using namespace pn;
using Eigen::Vector3d;

namespace {

/// The unit sphere.
TracedQuadric sphere(const std::vector<Vector3d>& stops = {}) {
  const Interval unit = {-1, 1};
  return {{{1, 1, 1}, 0, -1, false}, {unit, unit, unit}, {unit, unit, unit}, stops};
}

/// z = x^2 - y^2 above the square of side 2.
TracedQuadric saddle() {
  const Interval unit = {-1, 1};
  return {{{1, -1, 0}, -0.5, 0, false}, Box(), {unit, unit, unit}, {}};
}

std::vector<RegionLoop> loops_of(const QuadricBounds& bounds,
                                 const std::vector<Vector3d>& stops = {}) {
  const TracedQuadric quadric = sphere(stops);
  return region_loops(effective_bounds(bounds, quadric), quadric);
}

QuadricBounds sector(double low, double high) {
  QuadricBounds bounds;
  bounds.angle = Interval{low, high};
  return bounds;
}

QuadricBounds box(const Interval& x, const Interval& y, const Interval& z) {
  return {{x, y, z}, std::nullopt};
}

/// Closed, on the sphere, and inside the bounds but for rounding.
void check_loops(const std::vector<RegionLoop>& loops, const QuadricBounds& bounds) {
  QuadricBounds wider = bounds;
  for (Interval& interval : wider.box) interval = {interval.low - 1e-9, interval.high + 1e-9};
  for (const RegionLoop& loop : loops) {
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

TEST_CASE("Bounds that hold everywhere, or nowhere, leave no loop", "[quadric_region]") {
  CHECK(loops_of({}).empty());
  CHECK(loops_of(box({-2, 2}, {}, {-3, 4})).empty());
  // Some of them touch the sphere.
  CHECK(are_none(effective_bounds(box({-1, 1}, {-1 - 1e-15, 1}, {-1, 1 - 1e-12}), sphere())));
  CHECK(are_none(effective_bounds(sector(0.5, 0.5 + 2 * M_PI), sphere())));
  for (const QuadricBounds& bounds : {box({1, 2}, {}, {}), box({}, {}, {-3, -1 + 1e-12})}) {
    CHECK(test::code_of([&] { effective_bounds(bounds, sphere()); }) == ErrorCode::kRegionEmpty);
  }
  // Each of these cuts the sphere, but not where the other one holds.
  CHECK(loops_of(box({0.9, 2}, {}, {0.9, 2})).empty());
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
  const RegionLoop& loop = loops[0];
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

TEST_CASE("Bounds that coincide bound once", "[quadric_region]") {
  QuadricBounds half = sector(-M_PI / 2, M_PI / 2);
  half.box[0] = {0, 2};
  const auto loops = loops_of(half);
  REQUIRE(loops.size() == 1);
  CHECK(loops[0].size() == 2);
  half.box[0] = {-2, 0};
  CHECK(loops_of(half).empty());
}

TEST_CASE("A region that touches itself is refused", "[quadric_region]") {
  // What two touching caps leave of the sphere is one region; of the saddle, z >= 0 is two wedges.
  CHECK(loops_of(box({-2, 0.8}, {}, {-2, 0.6})).size() == 2);
  const QuadricBounds above = box({-1, 1}, {-1, 1}, {0, 2});
  CHECK(test::code_of([&] { region_loops(above, saddle()); }) == ErrorCode::kRegionUnsupported);
}

TEST_CASE("A region too thin to be seen is refused", "[quadric_region]") {
  for (const QuadricBounds& bounds :
       {box({0.5, 0.5 + 1e-9}, {}, {}), box({}, {1 - 1e-9, 2}, {}), sector(1, 1 + 1e-9)}) {
    CHECK(test::code_of([&] { effective_bounds(bounds, sphere()); }) ==
          ErrorCode::kRegionUnsupported);
  }
  CHECK_FALSE(loops_of(box({0.5, 0.5 + 1e-5}, {}, {})).empty());
}

TEST_CASE("Heights of a saddle cut hyperbolas", "[quadric_region]") {
  const QuadricBounds low = box({-1, 1}, {-1, 1}, {-2, 0.25}),
                      band = box({-1, 1}, {-1, 1}, {-0.5, 0.25});
  // Between the branches; and the four corners that both pairs of branches leave.
  const auto loops = region_loops(low, saddle());
  REQUIRE(loops.size() == 1);
  CHECK(loops[0].size() == 8);
  REQUIRE(region_loops(band, saddle()).size() == 1);
  for (const auto& arc : loops[0]) {
    const Vector3d p = arc(0.5);
    CHECK(p.z() == Approx(p.x() * p.x() - p.y() * p.y()));
  }
}

TEST_CASE("Arcs run slowly where they pass a stop", "[quadric_region]") {
  const Vector3d stop = Vector3d(1e-4, 1, 0.5).normalized() * std::sqrt(1.0);
  const double height = stop.z() - 1e-4;
  const auto loops = loops_of(box({}, {}, {height, 2}), {stop});
  REQUIRE(loops.size() == 1);
  REQUIRE(loops[0].size() == 1);
  int near = 0;
  for (int i = 0; i < 100; ++i) {
    if ((loops[0][0](i / 100.0) - stop).norm() < 0.01) ++near;
  }
  CHECK(near > 20);
}
