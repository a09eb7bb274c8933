// SPDX-License-Identifier: LGPL-2.1-or-later
// The isotropic hypersurface along a family of rulings: ruled surfaces, envelopes of cones of
// revolution.
//
// THEOREM. Let f = a(t) + v g(t) be a rational ruled surface in R^{3,1}, a = (p, -rho) / q and g =
// (M, -R) with coprime polynomials of degree h, D = |M|^2 - R^2 > 0 on [0, 1], that is not
// developable. Then Gamma along f is rational, w from the spinor factorization of (M, R) and v =
// -<w, a'> / <w, g'>. Let the point a be chosen on its line so that q has the least degree m, and
// let L = max(m + h, deg a ^ g q) be the degree of the line in Pluecker coordinates. Without odd
// real roots of D every section has the bidegree
//
//     (e + 4 d, 4),    e = 2 m + h - 2 if L = m + h, else m + L - 1,    d = ceil(h/2),
//
// less the number of real double roots of D, half of each: for R = 0, where D has no real root,
// polynomial directrices of degree k give (k + 4 d + h - 1, 4): 5, 7, 13, 15, 21, 23 for k = 1..6.
//
// Proof of the degree: with B = q a ^ g the point is f = (q (B' w + g' S) + q' g S) / (q^2 <w,
// g'>), S = -(B w)_i / g_i, a quotient of forms of these degrees: <w, g'>, a wronskian, loses its
// leading coefficient against <w, g> = 0, and where L = m + h the numerator does so too. QED
//
// With odd real roots the forms are those of the substituted parameter (odd_root_substitution.hpp)
// and e = 4 deg a + 2 h - 2 there. (M. Peternell, dissertation TU Wien 1997, Theorem 4.5 and
// Corollary 4.2; M. Peternell, Rational two-parameter families of spheres, 6.1.1.)
#pragma once

#include <Eigen/Dense>
#include <array>

#include "pn/isotropic/envelope.hpp"
#include "pn/isotropic/sphere_curve.hpp"

namespace pn {

/// The lines a + v g over Q: a = (centre, -radius) / denominator, g = (axis, -level) coprime.
struct Rulings {
  SphereCurve point;
  CircleFamily direction;
};

/// The family of lines through spheres of equal parameter, v = 0 and v = 1: g = content / (q0 q1)
/// direction.
struct JoinedRulings {
  Rulings rulings;
  RationalPolynomial content;  ///< zero when the curves are one
};

JoinedRulings joined(const SphereCurve& first, const SphereCurve& second);

/// The same lines with the point a of least denominator on each.
Rulings with_least_denominator(const Rulings& rulings);

/// Where a span lies: the length of its parameter, and whether neighbours meet its ends.
struct SpanPlace {
  Rational length;
  bool meets_before, meets_after;
};

/// Where torsal rulings of a span count, in its parameter on [0, 1]: beyond a free end too, by up
/// to a part of it. End tangents that are parallel but for the rounding of the poles put them
/// there.
struct TorsalRange {
  Rational low, high;
};

TorsalRange torsal_range(const SpanPlace& place);

/// The normal of a', g and g', freed of denominators: its coordinates are their minors.
struct RulingNormal {
  /// The greatest common divisor of the minors: zero when the family is developable.
  RationalPolynomial torsion;
  /// N: the minors without the first, second, third and fourth coordinate, divided by it.
  std::array<RationalPolynomial, 4> coprime;
};

RulingNormal ruling_normal(const Rulings& rulings);

/// The torsion times <N, N>: zero where a ruling may be torsal. For lines (R = 0) it is the torsion
/// but for a constant.
RationalPolynomial torsal_polynomial(const RulingNormal& normal);

/// The family in the local parameter, its slopes by the designer's. `directrices` bound the wanted
/// part of every ruling.
LocalForms local_forms(const Rulings& rulings, const std::array<SphereCurve, 2>& directrices,
                       const SpanPlace& place, long precision);

/// The degree of the theorem along the rulings of lines, without torsal ones.
int degree_of_lines(const Rulings& rulings);

/// Gamma along rulings that are not developable, with D > 0 on [0, 1]. Throws GeometryError when
/// every section exceeds the largest degree.
Envelope along_rulings(const Rulings& rulings, const std::array<SphereCurve, 2>& directrices,
                       const SpanPlace& place);

/// The unit normal at (1 - v) c0 + v c1 between the directrices, on the side of
/// ((1 - v) c0' + v c1') x g.
Eigen::Vector3d band_normal(const RulingForms<double>& rulings, double t, double v);

}  // namespace pn
