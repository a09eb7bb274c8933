// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/band_trims.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pn;

namespace {

/// Two segments over [0, 1] and [1, 3]; the sides are s = 1/5 + t^2 / 10 and 9/10 in the first, and
/// nearly as far where the second begins.
BandSides sides(bool closed) {
  const auto low = [](double t) { return 0.2 + 0.1 * t * t; };
  const auto low_after = [](double t) { return 0.3 + 1e-15 - 0.1 * std::sin(t); };
  const auto high = [](double) { return 0.9; };
  return band_sides({{{{0, 1, low}, {1, 3, low_after}}, {{0, 1, high}, {1, 3, high}}}}, closed);
}

}  // namespace

TEST_CASE("Edges of a band make a closed loop around it", "[band_trims]") {
  const TrimEdgeLoop loop = band_loop(sides(false), 0, 2);
  REQUIRE(loop.size() == 6);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    CHECK(loop[i].curve.poles.back() == loop[(i + 1) % loop.size()].curve.poles.front());
  }
  CHECK(loop[0].curve.poles.front() == std::array{0.0, 0.2});
  const auto [u, v] = evaluate(loop[0].curve, 0.5);
  CHECK(u == Approx(0.5));
  CHECK(v == Approx(0.225).epsilon(1e-12));
  // The region is on the left: along the first side, back along the second.
  CHECK(loop[4].curve.poles.front()[0] > loop[4].curve.poles.back()[0]);
}

TEST_CASE("Neighbouring faces of a band share their corners bit for bit", "[band_trims]") {
  const BandSides band = sides(false);
  const TrimEdgeLoop first = band_loop(band, 0, 1), second = band_loop(band, 1, 2);
  CHECK(first[0].curve.poles.back() == second[0].curve.poles.front());
  CHECK(first[2].curve.poles.front() == second[2].curve.poles.back());
}

TEST_CASE("A closed band ends where it begins", "[band_trims]") {
  const BandSides band = sides(true);
  CHECK((*band)[0].end(1)[1] == (*band)[0].start(0)[1]);
}
