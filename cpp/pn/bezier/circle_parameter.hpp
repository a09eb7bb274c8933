// SPDX-License-Identifier: LGPL-2.1-or-later
// The circle parameter: how u = (u0 : u1) runs around the circle of each normal.
//
// The normal is quadratic in (u0, u1) = p(s), so p and -p give the same point and a closed line of
// columns needs an antiperiodic curve, p(s + K) = -p(s). The quadratic B-spline with control points
// c_j = (cos j pi/K, sin j pi/K) is one: C1, so that p p^T is of degree 4 and C1, closed after K
// spans. As long as the weight is even on the circle, K = 4 keeps all weights within a factor of
// about 1.2.
//
// The control points are a free choice and are rounded to short doubles; the surface stays exact.
#pragma once

#include <array>
#include <vector>

#include "pn/algebra/rational.hpp"

namespace pn {

/// Columns of control points: column j of a form q00 u0^2 + 2 q01 u0 u1 + q11 u1^2 is
/// c0 q00 + c1 q01 + c2 q11 with its three coefficients.
struct CircleColumns {
  int degree;
  std::vector<double> knots;
  std::vector<int> multiplicities;
  std::vector<std::array<Rational, 3>> coefficients;
};

/// The whole circle as one closed C1 spline of degree 4 over [0, spans]; the last column equals the
/// first. spans >= 3.
CircleColumns whole_circle(int spans);

/// Arc number `index` of `arcs` equal ones: one Bezier piece of degree 2 over [index, index + 1].
CircleColumns circle_arc(int index, int arcs);

}  // namespace pn
