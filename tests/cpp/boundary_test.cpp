// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/boundary.hpp"

#include <catch2/catch.hpp>

#include "surfaces_of_revolution.hpp"

using pn::boundary_loops;
using pn::BoundaryCurve;
using pn::coincide;
using pn::ParameterCurve;
using pn::reversed;
using pn::SidePiece;

namespace {

// The whole sides v = first, u = last, v = last, u = first.
std::array<SidePiece, 4> sides(const pn::BSplineSurface& surface) {
  const auto loops = boundary_loops(surface);
  REQUIRE(loops.size() == 1);
  REQUIRE(loops[0].size() == 4);
  std::array<SidePiece, 4> result;
  for (int i = 0; i < 4; ++i) result[i] = std::get<SidePiece>(loops[0][i]);
  return result;
}

BoundaryCurve end_circle() { return sides(pn::test::tube(2, 0, 3, 5))[1].curve; }

// The straight trim from a to b.
ParameterCurve line(std::array<double, 2> a, std::array<double, 2> b) {
  return {1, {0, 1}, {2, 2}, {a, b}};
}

// A tube, u in [0, 1] and v in [0, 4], bounded by one loop.
pn::BSplineSurface tube_within(const pn::TrimLoop& loop) {
  auto tube = pn::test::tube(2, 0, 3, 5);
  tube.trims = {loop};
  return tube;
}

// One quarter of the tube's end circle.
SidePiece quarter(const pn::BSplineSurface& tube, double first, double last) {
  return {sides(tube)[1].curve, first, last, {1, first}, {1, last}, true};
}

}  // namespace

TEST_CASE("The sides of a closed tube: one seam, two circles") {
  const auto [bottom, end, top, start] = sides(pn::test::tube(2, 0, 3, 5));
  CHECK(coincide(bottom.curve, top.curve));
  CHECK_FALSE(coincide(start.curve, end.curve));
  CHECK(bottom.end == end.start);
  CHECK(end.end == top.end);
  CHECK(top.start == start.end);
  CHECK(start.start == bottom.start);
  CHECK(bottom.rising);
  CHECK(end.rising);
  CHECK_FALSE(top.rising);
  CHECK_FALSE(start.rising);
}

TEST_CASE("Neighbours coincide along their common circle") {
  const auto tubes = pn::test::three_tubes();
  CHECK(coincide(sides(tubes[0])[1], sides(tubes[1])[3]));
  CHECK_FALSE(coincide(sides(tubes[0])[1], sides(tubes[2])[3]));
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
  const auto [bottom, end, top, start] = sides(half);
  CHECK(is_degenerate(start.curve));
  CHECK(is_degenerate(end.curve));
  CHECK_FALSE(is_degenerate(bottom.curve));
  CHECK_FALSE(is_degenerate(top.curve));
}

TEST_CASE("Four trims along the sides are the whole boundary") {
  const auto whole = sides(pn::test::tube(2, 0, 3, 5));
  const auto traced = sides(tube_within(
      {line({0, 0}, {1, 0}), line({1, 0}, {1, 4}), line({1, 4}, {0, 4}), line({0, 4}, {0, 0})}));
  for (int i = 0; i < 4; ++i) {
    CHECK(coincide(whole[i], traced[i]));
    CHECK(whole[i].start == traced[i].start);
    CHECK(whole[i].end == traced[i].end);
    CHECK(whole[i].rising == traced[i].rising);
  }
}

TEST_CASE("Pieces of one side coincide when their ends do") {
  const auto tube = pn::test::tube(2, 0, 3, 5);
  const SidePiece piece = quarter(tube, 1, 2);
  CHECK(coincide(piece, reversed(reversed(piece))));
  CHECK_FALSE(coincide(piece, reversed(piece)));
  CHECK_FALSE(coincide(piece, quarter(tube, 1, 2.5)));
  CHECK_FALSE(coincide(piece, quarter(tube, 1, 2 + 1e-13)));
  CHECK_FALSE(coincide(piece, sides(tube)[1]));
  CHECK(reversed(piece).start == piece.end);
  CHECK(reversed(piece).first == 2);
  CHECK(reversed(piece).last == 3);
}

TEST_CASE("Ends of pieces are compared up to the affine map of the knots") {
  const auto tube = pn::test::tube(2, 0, 3, 5);
  auto slow = tube;
  for (double& knot : slow.v_knots) knot = 1000.1 + knot / 3;
  const double first = 0.3;
  CHECK(coincide(quarter(tube, first, 2), quarter(slow, 1000.1 + first / 3, 1000.1 + 2. / 3)));
}

TEST_CASE("A straight trim inside the surface, or a curved one that ends on sides, is no side") {
  const ParameterCurve curved{2, {0, 1}, {3, 3}, {{1, 3}, {0.5, 2}, {1, 1}}};
  const auto loops = boundary_loops(
      tube_within({line({1, 1}, {1, 3}), line({1, 3}, {0.5, 2}), line({0.5, 2}, {1, 1})}));
  CHECK(std::holds_alternative<SidePiece>(loops[0][0]));
  CHECK(std::holds_alternative<ParameterCurve>(loops[0][1]));
  const auto bowed = boundary_loops(tube_within({line({1, 1}, {1, 3}), curved}));
  CHECK(std::holds_alternative<ParameterCurve>(bowed[0][1]));
}

TEST_CASE("A trim with corners is cut there, and its straight pieces may lie on sides") {
  // A polygon with one edge on the side u = 1.
  const ParameterCurve polygon{1, {0, 1, 2, 5}, {2, 1, 1, 2}, {{1, 1}, {1, 3}, {0.5, 2}, {1, 1}}};
  const auto loops = boundary_loops(tube_within({polygon}));
  REQUIRE(loops[0].size() == 3);
  CHECK(std::get<SidePiece>(loops[0][0]).first == 1);
  CHECK(std::get<SidePiece>(loops[0][0]).last == 3);
  // Two cubic pieces, the first of two spans.
  const ParameterCurve two{3,
                           {0, 1, 2, 3},
                           {4, 1, 3, 4},
                           {{0, 0}, {1, 0}, {1, 1}, {1, 2}, {1, 3}, {0, 3}, {-1, 2}, {0, 0}}};
  const auto pieces = boundary_loops(tube_within({two}))[0];
  REQUIRE(pieces.size() == 2);
  const auto& first = std::get<ParameterCurve>(pieces[0]);
  const auto& second = std::get<ParameterCurve>(pieces[1]);
  CHECK(first.knots == std::vector<double>{0, 1, 2});
  CHECK(first.multiplicities == std::vector{4, 1, 4});
  CHECK(first.poles == std::vector(two.poles.begin(), two.poles.begin() + 5));
  CHECK(second.knots == std::vector<double>{2, 3});
  CHECK(second.multiplicities == std::vector{4, 4});
  CHECK(second.poles == std::vector(two.poles.begin() + 4, two.poles.end()));
}

TEST_CASE("Trims that bound nothing are refused") {
  const ParameterCurve good{2, {0, 1}, {3, 3}, {{1, 3}, {0.5, 2}, {1, 1}}};
  ParameterCurve trim = good;
  SECTION("an open loop") { trim.poles.back()[1] = std::nextafter(1., 2); }
  SECTION("a pole too few") { trim.poles.pop_back(); }
  SECTION("not clamped") { trim.multiplicities.back() = 2; }
  SECTION("a gap") {
    trim = {2, {0, 1, 2}, {3, 3, 3}, {{1, 3}, {0.5, 2}, {0.5, 2}, {0.6, 2}, {0.5, 2}, {1, 1}}};
  }
  SECTION("a knot twice") { trim.knots = {1, 1}; }
  SECTION("degree 0") { trim = {0, {0, 1}, {1, 1}, {{1, 3}}}; }
  SECTION("a pole at infinity") { trim.poles[1][0] = INFINITY; }
  SECTION("a single point") { trim.poles = {{1, 3}, {1, 3}, {1, 3}}; }
  CHECK_NOTHROW(boundary_loops(tube_within({line({1, 1}, {1, 3}), good})));
  CHECK_THROWS_AS(boundary_loops(tube_within({line({1, 1}, {1, 3}), trim})), std::invalid_argument);
  CHECK_THROWS_AS(boundary_loops(tube_within({})), std::invalid_argument);
}
