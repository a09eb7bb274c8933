// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/spline_surface.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "error_code.hpp"
#include "pn/bezier/evaluation.hpp"

using namespace pn;
using test::code_of;

namespace {

/// Degree 2 with a knot at 1/2 along u, degree 1 along v.
SplineSurfaceData two_spans() {
  SplineSurfaceData data{{2, 1}, {{{0, 0.5, 2}, {3, 4}}}, {{{3, 1, 3}, {2, 2}}}, {}, {}};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 2; ++j) {
      data.poles.push_back({static_cast<double>(i), 3.0 * j, 0.25 * i * i - j});
      data.weights.push_back(1 + 0.5 * ((i + j) % 2));
    }
  }
  return data;
}

}  // namespace

TEST_CASE("The patches of a spline surface are its spans", "[spline_surface]") {
  const SplineSurfaceData data = two_spans();
  BSplineSurface surface;
  surface.u_degree = 2;
  surface.v_degree = 1;
  surface.u_knots = data.knots[0];
  surface.v_knots = data.knots[1];
  surface.u_multiplicities = data.multiplicities[0];
  surface.v_multiplicities = data.multiplicities[1];
  surface.poles = data.poles;
  surface.weights = data.weights;
  const std::vector<RationalPatch> patches = rational_patches(data);
  REQUIRE(patches.size() == 2);
  for (std::size_t span = 0; span < 2; ++span) {
    const double low = data.knots[0][span], high = data.knots[0][span + 1];
    for (const double u : {0.0, 0.25, 0.75, 1.0}) {
      for (const double v : {0.0, 0.5, 1.0}) {
        const auto expected = evaluate(surface, low + (high - low) * u, 3 + v);
        const Rational x = Rational::exactly(u), y = Rational::exactly(v);
        const double weight = patches[span].weight(x, y).to_double();
        for (std::size_t c = 0; c < 3; ++c) {
          CHECK(patches[span].point[c](x, y).to_double() / weight ==
                Approx(expected[c]).margin(1e-14));
        }
      }
    }
  }
}

TEST_CASE("Data that are no spline surface are refused", "[spline_surface]") {
  const auto refused = [](auto&& change) {
    SplineSurfaceData data = two_spans();
    change(data);
    return code_of([&] { rational_patches(data); });
  };
  CHECK(refused([](auto& data) { data.poles.pop_back(); }) == ErrorCode::kWrongShape);
  CHECK(refused([](auto& data) { data.weights.pop_back(); }) == ErrorCode::kWrongShape);
  CHECK(refused([](auto& data) { data.degree[1] = 0; }) == ErrorCode::kWrongShape);
  CHECK(refused([](auto& data) { data.knots[0][1] = 0; }) == ErrorCode::kBadKnots);
  CHECK(refused([](auto& data) { data.knots[1][1] = NAN; }) == ErrorCode::kNotFinite);
  CHECK(refused([](auto& data) { data.poles[1][1] = NAN; }) == ErrorCode::kNotFinite);
  CHECK(refused([](auto& data) { data.weights[1] = NAN; }) == ErrorCode::kNotFinite);
  CHECK(refused([](auto& data) { data.weights[3] = 0; }) == ErrorCode::kNonPositiveWeight);
  CHECK_FALSE(refused([](auto& data) { data.weights.clear(); }).has_value());
}
