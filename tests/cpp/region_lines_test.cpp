// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/region_lines.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/algebra/precision.hpp"
#include "pn/bezier/chain_net.hpp"
#include "pn/bezier/parameter_lines.hpp"
#include "pn/shapes/quadric.hpp"

using namespace pn;

namespace {

/// The link of a quadric's region, in doubles, and what the region takes of it.
struct Region {
  EnvelopeChain chain;
  IsotropicHypersurface<double> gamma =
      midpoint(chain.links.front().envelope.enclosure(kLeastPrecision));
  RegionCircles circles = region_circles(std::get<BoundedRegion>(chain.extent), gamma);
};

/// z^2/4 - x^2/9 - y^2 = 1 between two heights; its umbilics lie at z = 3.225.
Region hyperboloid(double low, double high) {
  QuadricBounds bounds;
  bounds.box[2] = {low, high};
  return {quadric(QuadricKind::kTwoSheetHyperboloid, {3, 1, 2}, bounds)};
}

}  // namespace

TEST_CASE("A closed surface takes all circles whole", "[region_lines]") {
  const Region whole{quadric(QuadricKind::kEllipsoid, {3, 2, 1}, {})};
  CHECK(whole.circles.is_closed);
  CHECK_FALSE(whole.circles.split);
  CHECK(whole.circles.low == 0);
  CHECK(whole.circles.high == 1);
}

TEST_CASE("A region beside the poles takes arcs of circles", "[region_lines]") {
  const Region cap = hyperboloid(2, 3);
  CHECK_FALSE(cap.circles.is_closed);
  CHECK_FALSE(cap.circles.split);
  CHECK(cap.circles.low > 0);
}

TEST_CASE("Circles are left before they reach infinity", "[region_lines]") {
  for (const double height : {3.3, 4.0, 8.0, 12.0}) {
    const Region cap = hyperboloid(2, height);
    CAPTURE(height);
    REQUIRE(cap.circles.is_closed);
    REQUIRE(cap.circles.split);
    CHECK(cap.circles.low == 0);
    const auto weight =
        sections(cap.gamma.carrier, isotropic_vector<double>(cap.gamma.spinor)).weight;
    for (int i = 0; i <= 40; ++i) {
      const double t = *cap.circles.split * i / 40;
      for (int k = 0; k < 60; ++k) {
        const double angle = M_PI * k / 60;
        CHECK(value(weight, t, std::cos(angle), std::sin(angle)) > 0);
      }
    }
  }
}

TEST_CASE("Arcs hold the boundary of the region on their circles", "[region_lines]") {
  for (const double height : {2.5, 3.0, 3.2, 3.5, 8.0}) {
    const Region cap = hyperboloid(2, height);
    REQUIRE_FALSE(cap.circles.boundary.empty());
    const ArcOf arcs[] = {constant_arc(cap.circles), tapering_arc(cap.circles),
                          following_arc(cap.circles), closely_following_arc(cap.circles)};
    for (const ArcOf& arc : arcs) {
      for (const BoundaryPlace& place : cap.circles.boundary) {
        const auto [low, high] = arc(place.t);
        CHECK(low <= place.angle + 1e-9);
        CHECK(place.angle <= high + 1e-9);
      }
    }
  }
}

TEST_CASE("Tapering arcs touch the boundary", "[region_lines]") {
  const Region cap = hyperboloid(2, 3);
  const ArcOf arc = tapering_arc(cap.circles);
  double below = HUGE_VAL, above = HUGE_VAL;
  for (const BoundaryPlace& place : cap.circles.boundary) {
    const auto [low, high] = arc(place.t);
    below = std::min(below, place.angle - low);
    above = std::min(above, high - place.angle);
  }
  CHECK(std::abs(below) < 1e-9);
  CHECK(std::abs(above) < 1e-9);
}

TEST_CASE("All angles of a boundary lie within half a turn", "[region_lines]") {
  for (const double height : {2.5, 3.3, 8.0}) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const BoundaryPlace& place : hyperboloid(2, height).circles.boundary) {
      low = std::min(low, place.angle);
      high = std::max(high, place.angle);
    }
    CHECK(high - low < M_PI);
  }
}

TEST_CASE("Lines over arcs go a margin beyond the boundary", "[region_lines]") {
  const Region cap = hyperboloid(2, 3);
  const RegionLines lines(cap.gamma, cap.circles, tapering_arc(cap.circles), 0.05);
  for (const BoundaryPlace& place : cap.circles.boundary) {
    const Eigen::Vector2d direction(std::cos(place.angle), std::sin(place.angle));
    const Eigen::Vector2d u = lines.at(0, place.t).inverse() * direction;
    CHECK(u(0) * u(1) > 0);
  }
}

TEST_CASE("The larger part holds what goes on beyond the split", "[region_lines]") {
  const Region cap = hyperboloid(2, 5);
  const RegionLines lines(cap.gamma, cap.circles, following_arc(cap.circles), 0.05);
  for (const BoundaryPlace& place : cap.circles.boundary) {
    const Eigen::Vector2d direction(std::cos(place.angle), std::sin(place.angle));
    const Eigen::Vector2d u = lines.at(0, place.t).inverse() * direction;
    CHECK(circle_parameter(u(0), u(1), kLeastArcs) < kArcsOfLargerPart);
  }
  // Up to the split the lines are constant.
  CHECK(lines.at(0, 0) == lines.at(0, *cap.circles.split / 2));
}

TEST_CASE("Faces follow the region with few poles", "[region_lines]") {
  const Region cap = hyperboloid(2, 3);
  const ChainNet net(cap.chain, Lines::kEven, 128);
  REQUIRE(net.faces().size() == 1);
  CHECK(net.faces()[0].frame.u_degree == 12);
  CHECK(net.faces()[0].frame.v_degree == 4);
  const ChainNet tall(hyperboloid(2, 5).chain, Lines::kEven, 128);
  REQUIRE(tall.faces().size() >= 3);
  CHECK(tall.segments()[0].around == Around::kUnequalParts);
  CHECK(tall.segments()[1].around == Around::kLargerPart);
}

TEST_CASE("Parallels need no trims", "[region_lines]") {
  QuadricBounds bounds;
  bounds.box[2] = {2.5, 4};
  const auto parallels = [&](std::array<double, 3> half) {
    const EnvelopeChain chain = quadric(QuadricKind::kTwoSheetHyperboloid, half, bounds);
    return is_bounded_by_parallels(std::get<BoundedRegion>(chain.extent));
  };
  CHECK(parallels({2, 2, 2}));
  CHECK_FALSE(parallels({3, 2, 2}));
}
