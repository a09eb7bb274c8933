// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/trim_edge.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "trimmed_surfaces.hpp"

using namespace pn;

TEST_CASE("An edge follows its path, a straight one is exact", "[trim_edge]") {
  const ParameterPath path = [](double at) {
    return std::array{std::cos(at), std::sin(at) * std::exp(at)};
  };
  const TrimEdge edge = edge_along(path, 1e-13);
  for (const double at : {0.0, 0.1, 0.37, 0.5, 0.93, 1.0}) {
    const auto exact = path(at), near = evaluate(edge.curve, at);
    CHECK(std::hypot(exact[0] - near[0], exact[1] - near[1]) < 1e-12);
  }
  CHECK(edge.curve.poles.front() == path(0));
  CHECK(edge.curve.poles.back() == path(1));
  const TrimEdge line = straight_edge({1, 2}, {3, 5});
  CHECK_FALSE(line.path);
  CHECK(evaluate(line.curve, 0.5) == std::array{2.0, 3.5});
}

TEST_CASE("The deviation is how far an edge is from its path on the surface", "[trim_edge]") {
  const BSplineSurface surface = test::paraboloid();
  const ParameterPath path = [](double at) { return std::array{at - 0.5, 0.25}; };
  TrimmedFace face{0, {{edge_along(path, 1e-13), straight_edge({0.5, 0.25}, {-0.5, 0.25})}}};
  CHECK(trim_deviation(surface, face) < 1e-12);
  REQUIRE(curves_of(face).size() == 1);
  CHECK(curves_of(face)[0].size() == 2);
  constexpr double kShift = 1e-6;
  for (auto& pole : face.loops[0][0].curve.poles) pole[1] += kShift;
  // Across, the paraboloid rises by 2 v = 1/2.
  CHECK(trim_deviation(surface, face) == Approx(kShift * std::hypot(1, 0.5)).epsilon(1e-4));
  CHECK(trim_deviation(surface, {0, {}}) == 0);
}
