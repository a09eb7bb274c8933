// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves of spheres: one-parameter families in Minkowski space R^{3,1}, over Q.
//
// The curve is f(t) = (m(t), -r(t)) with m = centre / denominator and r = radius / denominator, for
// t in [0, 1]. With <x, y> = x1 y1 + x2 y2 + x3 y3 - x4 y4, a unit normal n of the envelope
// satisfies <f', (n, 1)> = n.m' + r' = 0: at each t a circle on the unit sphere, whose family (M,
// R) is f' without its common factor:
//
//     f' = content / denominator^2 (M, -R),    M, R coprime,    n.M + R = 0,    D = |M|^2 - R^2.
//
// The circle is real where D > 0. (M. Peternell, dissertation TU Wien 1997, section 2.5.)
#pragma once

#include <array>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

struct SphereCurve {
  std::array<RationalPolynomial, 3> centre;
  RationalPolynomial radius;
  RationalPolynomial denominator;

  /// The largest degree among numerators and denominator.
  int degree() const;
};

/// The circles n.axis + level = 0 on the unit sphere.
struct CircleFamily {
  std::array<RationalPolynomial, 3> axis;
  RationalPolynomial level;

  /// h: the largest degree among axis and level.
  int degree() const;
  /// D = |axis|^2 - level^2.
  RationalPolynomial discriminant() const;
  CircleFamily operator-() const { return {{-axis[0], -axis[1], -axis[2]}, -level}; }
};

struct TangentDirection {
  CircleFamily circles;        ///< coprime
  RationalPolynomial content;  ///< zero when the curve is a single sphere
};

TangentDirection tangent_direction(const SphereCurve& curve);

}  // namespace pn
