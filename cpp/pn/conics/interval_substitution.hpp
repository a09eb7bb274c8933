// SPDX-License-Identifier: LGPL-2.1-or-later
// Substitutions that leave only an interval of a family of conics.
//
// A parametrization over R(t) needs real points for all t. If they exist on an interval only, let
// r1 and r2 enclose it, with real points in between; then
//
//     t = (r1 p^2 + r2 q^2) / (p^2 + q^2)
//
// takes only values between r1 and r2, for linear p, q in s. (M. Peternell, dissertation TU Wien
// 1997, (1.27).) With (p : q) = (beta : 1) at s = 0 and (1 : beta) at s = 1 the ends of the
// interval are s = 0 and 1 exactly, and r1, r2 are rational and close in on it as beta grows. If
// the conics end at an end of the interval itself, r1 or r2 is that end: (1 : 0) or (0 : 1). Ends
// are rational, so an irrational zero of det C lies beyond them, and some rational r1, r2 lie
// before it; algebraic ones are never needed. All degrees in t are doubled.
#pragma once

#include "pn/conics/conic_family.hpp"

namespace pn {

/// t = numerator / denominator, both of this formal degree in s, taking s in [0, 1] to an interval.
struct IntervalSubstitution {
  RationalPolynomial numerator, denominator;
  int degree;

  /// p(t) denominator^formal_degree, of degree formal_degree * degree in s.
  RationalPolynomial operator()(const RationalPolynomial& p, int formal_degree) const;
};

/// For begin < end: linear where the conics of the whole line have real points, quadratic
/// otherwise. Throws GeometryError kNoRealPoints when they have none in a part of the interval.
IntervalSubstitution interval_substitution(const ConicFamily& family, const Rational& begin,
                                           const Rational& end);

/// The family over s.
ConicFamily substituted(const ConicFamily& family, const IntervalSubstitution& substitution);

}  // namespace pn
