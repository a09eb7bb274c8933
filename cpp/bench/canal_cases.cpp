// SPDX-License-Identifier: LGPL-2.1-or-later
#include "canal_cases.hpp"

#include <cmath>

#include "clamped_cubic.hpp"
#include "pn/shapes/canal_surface.hpp"

namespace pn::bench {
namespace {

const std::vector<std::array<double, 3>> kBentSpine = {
    {0, 0, 0}, {15, 5, 0}, {20, 15, 5}, {20, 20, 0}};

}  // namespace

BezierCanal pipe() { return {kBentSpine, {2}}; }

BezierCanal horn() { return {kBentSpine, {2, 1.8, 2, 2.5}}; }

BezierCanal helical_horn(int degree) {
  BezierCanal canal;
  for (int i = 0; i <= degree; ++i) {
    const double turn = 1.6 * i / degree;
    canal.spine.push_back({20 * std::sin(turn), 20 - 20 * std::cos(turn), 5 * turn});
    canal.radius.push_back(2.5 - 0.6 * std::sin(turn + 0.8));
  }
  return canal;
}

SplineCanal spring(int spans) {
  constexpr double kTurn = 0.35;  // radians from pole to pole
  SplineCanal canal{clamped_cubic<3>(spans), clamped_cubic<1>(spans)};
  for (int i = 0; i < spans + 3; ++i) {
    const double angle = kTurn * i;
    const double coil = 30 + 2 * std::sin(0.9 * i);
    canal.spine.poles.push_back({coil * std::cos(angle), coil * std::sin(angle), 1.5 * i});
    canal.radius.poles.push_back({3 + 0.5 * std::sin(0.6 * i)});
  }
  return canal;
}

PNSurface surface_of(const BezierCanal& canal) {
  const Law radius =
      canal.radius.size() == 1 ? Law::constant(canal.radius.front()) : Law::bezier(canal.radius);
  return PNSurface(canal_surface(Curve::bezier(canal.spine), radius));
}

PNSurface surface_of(const SplineCanal& canal) {
  return PNSurface(canal_surface(Curve::bspline(canal.spine), Law::bspline(canal.radius)));
}

}  // namespace pn::bench
