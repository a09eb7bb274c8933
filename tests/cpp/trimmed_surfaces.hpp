// SPDX-License-Identifier: LGPL-2.1-or-later
// Trims for the tests: loops in the parameter plane, and surfaces to put them on.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "surfaces_of_revolution.hpp"

namespace pn::test {

inline ParameterCurve bezier(const std::vector<std::array<double, 2>>& poles) {
  const int degree = static_cast<int>(poles.size()) - 1;
  return {degree, {0, 1}, {degree + 1, degree + 1}, poles};
}

inline ParameterCurve straight(std::array<double, 2> a, std::array<double, 2> b) {
  return bezier({a, b});
}

/// The straight lines from corner to corner and back to the first.
inline TrimLoop polygon(const std::vector<std::array<double, 2>>& corners) {
  TrimLoop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.push_back(straight(corners[i], corners[(i + 1) % corners.size()]));
  }
  return loop;
}

/// Four cubic arcs around a centre, counterclockwise: nearly an ellipse.
inline TrimLoop oval(std::array<double, 2> centre, double a, double b) {
  constexpr double k = 0.55;
  const auto at = [&](double x, double y) {
    return std::array{centre[0] + a * x, centre[1] + b * y};
  };
  return {bezier({at(1, 0), at(1, k), at(k, 1), at(0, 1)}),
          bezier({at(0, 1), at(-k, 1), at(-1, k), at(-1, 0)}),
          bezier({at(-1, 0), at(-1, -k), at(-k, -1), at(0, -1)}),
          bezier({at(0, -1), at(k, -1), at(1, -k), at(1, 0)})};
}

/// The same loop of Bezier curves the other way round: the outside becomes the inside.
inline TrimLoop reversed(TrimLoop loop) {
  std::reverse(loop.begin(), loop.end());
  for (ParameterCurve& curve : loop) std::reverse(curve.poles.begin(), curve.poles.end());
  return loop;
}

inline BSplineSurface within(BSplineSurface surface, const std::vector<TrimLoop>& loops) {
  surface.trims = loops;
  return surface;
}

/// (u, v, u^2 + v^2) over the square [-1, 1]^2.
inline BSplineSurface paraboloid() {
  BSplineSurface surface{2, 2, {-1, 1}, {-1, 1}, {3, 3}, {3, 3}, {}, {}, {}};
  const std::array<double, 3> coordinate = {-1, 0, 1};
  const std::array<double, 3> square = {1, -1, 1};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      surface.poles.push_back({coordinate[i], coordinate[j], square[i] + square[j]});
      surface.weights.push_back(1);
    }
  }
  return surface;
}

/// Half of the axes' ellipsoid each, cut along two meridians.
inline std::vector<BSplineSurface> ellipsoid_halves(double a, double b, double c) {
  auto halves = sphere_halves();
  for (BSplineSurface& half : halves) {
    for (auto& [x, y, z] : half.poles) {
      x *= a;
      y *= b;
      z *= c;
    }
  }
  return halves;
}

/// The part of the halves with u <= last: it is bounded by a plane curve z = const.
inline std::vector<BSplineSurface> up_to(std::vector<BSplineSurface> halves, double last) {
  for (BSplineSurface& half : halves) {
    const double v0 = half.v_knots.front();
    const double v1 = half.v_knots.back();
    half.trims = {polygon({{0, v0}, {last, v0}, {last, v1}, {0, v1}})};
  }
  return halves;
}

/// Height on the unit sphere of the parameter u of `half_circle`.
inline double height(double u) {
  const PlaneCurve arc = half_circle();
  constexpr std::array<double, 5> kBinomial = {1, 4, 6, 4, 1};
  double z = 0, w = 0;
  for (int i = 0; i < 5; ++i) {
    const double b = kBinomial[i] * std::pow(u, i) * std::pow(1 - u, 4 - i) * arc.weights[i];
    z += b * arc.poles[i][1];
    w += b;
  }
  return z / w;
}

/// A tube of radius 2 from z = 0 with a wavy end: u = 1/2 at the seam, where v = 0 and v = 4.
inline ParameterCurve wave() {
  return {3,
          {0, 1, 2, 3, 4},
          {4, 1, 1, 1, 4},
          {{0.5, 0}, {0.6, 0.5}, {0.9, 1}, {0.2, 2}, {0.3, 3}, {0.5, 3.5}, {0.5, 4}}};
}
inline BSplineSurface wavy_tube() {
  return within(tube(2, 0, 2, 5), {{straight({0, 0}, {0.5, 0}), wave(), straight({0.5, 4}, {0, 4}),
                                    straight({0, 4}, {0, 0})}});
}

/// A tube of radius 2 and height 5 with a hole across its seam.
inline BSplineSurface tube_with_hole_across_seam() {
  return within(tube(2, 0, 2, 5),
                {{straight({0, 0}, {0.3, 0}), bezier({{0.3, 0}, {0.3, 0.4}, {0.7, 0.4}, {0.7, 0}}),
                  straight({0.7, 0}, {1, 0}), straight({1, 0}, {1, 4}), straight({1, 4}, {0.7, 4}),
                  bezier({{0.7, 4}, {0.7, 3.6}, {0.3, 3.6}, {0.3, 4}}), straight({0.3, 4}, {0, 4}),
                  straight({0, 4}, {0, 0})}});
}

/// Two tubes in a row, each within 1/2 <= v <= 5/2 and a curve: they share a piece of a circle. The
/// second runs its circles from v = 10 on at a third of the speed.
inline std::vector<BSplineSurface> trimmed_neighbours() {
  const auto first = within(
      tube(2, 0, 2, 5),
      {{straight({1, 0.5}, {1, 2.5}), straight({1, 2.5}, {0.5, 2.5}),
        bezier({{0.5, 2.5}, {0.1, 2}, {0.7, 1}, {0.4, 0.5}}), straight({0.4, 0.5}, {1, 0.5})}});
  BSplineSurface second = tube(2, 5, 3, 7);
  const auto at = [](double v) { return 10 + 3 * v; };
  for (double& knot : second.v_knots) knot = at(knot);
  second.trims = {{straight({0, at(2.5)}, {0, at(0.5)}), straight({0, at(0.5)}, {0.7, at(0.5)}),
                   bezier({{0.7, at(0.5)}, {0.3, at(1)}, {0.9, at(2)}, {0.8, at(2.5)}}),
                   straight({0.8, at(2.5)}, {0, at(2.5)})}};
  return {first, second};
}

}  // namespace pn::test
