// SPDX-License-Identifier: LGPL-2.1-or-later
// The circle parameter: how u = (u0 : u1) runs around the circle of each normal.
//
// The normal is quadratic in (u0, u1) = p(s), so p and -p give the same point and a closed line of
// columns needs an antiperiodic curve, p(s + K) = -p(s). The quadratic B-spline with control points
// c_j = (cos j pi/K, sin j pi/K) is one: C1, so that a form of degree n in p is of degree 2n and
// C1, closed after K spans for even n. As long as the weight is even on the circle, K = 4 keeps all
// weights of a form of degree 2 within a factor of about 1.2.
//
// A band between two lines u = const takes the straight p(s) = (1 - s, s) instead.
//
// The control points are a free choice and are rounded to short doubles; the surface stays exact.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "pn/algebra/rational.hpp"

namespace pn {

/// Columns of control points: column j of a form sum C(n, i) q_i u0^(n - i) u1^i is the sum of q_i
/// times its coefficients.
struct CircleColumns {
  int degree;
  std::vector<double> knots;
  std::vector<int> multiplicities;
  std::vector<std::vector<Rational>> coefficients;
};

/// The spans first, ..., last - 1 of the circle of `spans` >= 3 spans, for forms of this degree in
/// u: a C1 spline of twice that degree over [first, last]. The whole circle is closed, its last
/// column equals the first.
CircleColumns circle_part(int first, int last, int spans, int form_degree);

/// p(s), for s in [0, spans].
Eigen::Vector2d circle_point(double s, int spans);

/// The s in [0, spans) with p(s) parallel to (u0, u1), which is not zero.
double circle_parameter(double u0, double u1, int spans);

/// The same spline with so many equal spans in the place of each, and simple knots between them.
CircleColumns refined(const CircleColumns& columns, int spans);

/// Arc number `index` of `arcs` equal ones: one Bezier piece over [index, index + 1].
CircleColumns circle_arc(int index, int arcs, int form_degree);

/// The band u = (1 - s : s), s in [0, 1], with so many spans of equal length and simple knots
/// between them.
CircleColumns straight_band(int spans, int form_degree);

}  // namespace pn
