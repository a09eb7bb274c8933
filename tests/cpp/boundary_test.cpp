// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/boundary.hpp"

#include <catch2/catch.hpp>

#include "surfaces_of_revolution.hpp"

using pn::boundaries;
using pn::BoundaryCurve;
using pn::coincide;
using pn::reversed;

namespace {

BoundaryCurve end_circle() { return boundaries(pn::test::tube(2, 0, 3, 5))[1].curve; }

}  // namespace

TEST_CASE("The sides of a closed tube: one seam, two circles") {
  const auto [bottom, end, top, start] = boundaries(pn::test::tube(2, 0, 3, 5));
  CHECK(coincide(bottom.curve, top.curve));
  CHECK_FALSE(coincide(start.curve, end.curve));
  CHECK(bottom.end == end.start);
  CHECK(end.end == top.end);
  CHECK(top.start == start.end);
  CHECK(start.start == bottom.start);
}

TEST_CASE("Neighbours coincide along their common circle") {
  const auto tubes = pn::test::three_tubes();
  CHECK(coincide(boundaries(tubes[0])[1].curve, boundaries(tubes[1])[3].curve));
  CHECK_FALSE(coincide(boundaries(tubes[0])[1].curve, boundaries(tubes[2])[3].curve));
}

TEST_CASE("Reversal is its own inverse, and another curve") {
  const BoundaryCurve curve = end_circle();
  CHECK_FALSE(coincide(curve, reversed(curve)));
  CHECK(coincide(curve, reversed(reversed(curve))));
  CHECK(reversed(curve).poles.front() == curve.poles.back());
}

TEST_CASE("A factor of the weights and an affine map of the knots leave the curve as it is") {
  const BoundaryCurve curve = end_circle();
  BoundaryCurve other = curve;
  for (double& weight : other.weights) weight *= 1.7;
  for (double& knot : other.knots) knot = 1000.1 + knot / 3;
  CHECK(coincide(curve, other));
  CHECK(coincide(reversed(curve), reversed(other)));
}

TEST_CASE("Everything else makes another curve") {
  const BoundaryCurve curve = end_circle();
  BoundaryCurve other = curve;
  SECTION("a pole moved by one ulp") { other.poles[3][0] = std::nextafter(other.poles[3][0], 100); }
  SECTION("one weight changed") { other.weights[3] *= 1 + 1e-13; }
  SECTION("one knot moved") { other.knots[1] += 1e-13; }
  SECTION("another degree") { other.degree = 5; }
  CHECK_FALSE(coincide(curve, other));
  CHECK_FALSE(coincide(other, curve));
}

TEST_CASE("A side is degenerate when it is one point") {
  const auto half = pn::test::sphere_halves()[0];
  const auto [bottom, end, top, start] = boundaries(half);
  CHECK(is_degenerate(start.curve));
  CHECK(is_degenerate(end.curve));
  CHECK_FALSE(is_degenerate(bottom.curve));
  CHECK_FALSE(is_degenerate(top.curve));
}
