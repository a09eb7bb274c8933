// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ruled_cases.hpp"

#include <cmath>

#include "clamped_cubic.hpp"
#include "pn/shapes/ruled_surface.hpp"

namespace pn::bench {

BezierRuled bilinear_patch() { return {{{0, 0, 0}, {10, 0, 0}}, {{0, 10, 0}, {10, 10, 8}}}; }

BezierRuled cubic_patch() {
  return {{{0, 0, 0}, {4, -1, 2}, {8, 1, -1}, {12, 0, 1}},
          {{0, 8, 2}, {4, 9, -1}, {8, 7, 2}, {12, 8, 0}}};
}

SplineRuled strip(int spans) {
  constexpr double kHalfWidth = 4;
  SplineRuled ruled{clamped_cubic<3>(spans), clamped_cubic<3>(spans)};
  for (int i = 0; i < spans + 3; ++i) {
    const double x = 4.0 * i, z = std::sin(0.7 * i), turn = 0.5 * std::sin(0.45 * i);
    const double y = kHalfWidth * std::cos(turn), rise = kHalfWidth * std::sin(turn);
    ruled.first.poles.push_back({x, -y, z - rise});
    ruled.second.poles.push_back({x, y, z + rise});
  }
  return ruled;
}

EnvelopeChain chain_of(const BezierRuled& ruled) {
  return ruled_surface(Curve::bezier(ruled.first), Curve::bezier(ruled.second));
}

EnvelopeChain chain_of(const SplineRuled& ruled) {
  return ruled_surface(Curve::bspline(ruled.first), Curve::bspline(ruled.second));
}

}  // namespace pn::bench
