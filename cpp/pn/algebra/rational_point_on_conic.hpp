// SPDX-License-Identifier: LGPL-2.1-or-later
// Rational points of one conic over Q.
//
// THEOREM (A.-M. Legendre, Theorie des nombres, 1798). Let a, b, c be squarefree, coprime in pairs
// and not all of one sign. Then a x^2 + b y^2 + c z^2 = 0 has a rational point if and only if -b c,
// -c a, -a b are squares modulo a, b, c.
//
// Every conic becomes such a diagonal form over Q by Gram and Schmidt, squares taken out of the
// coefficients, and common primes of two of them put into the third one. (D. Simon, Solving
// quadratic equations using reduced unimodular quadratic forms, Math. Comp. 74, 2005.)
//
// POINTS. A point modulo a prime p of a lies on one of the lines y = +-r z, r^2 = -c / b: on a line
// for each prime in all points form a lattice of index |a b c|, and f / (a b c) is an integral form
// of determinant 1 on it. So f(v) is a multiple of a b c. In a basis reduced for |a| x^2 + |b| y^2
// + |c| z^2 either one of its vectors is a point, or the squares of their lengths lie between
// |a b c| and 8 |a b c| and all coefficients of f / (a b c) are at most 8. Only finitely many such
// forms exist, and small multiples of the vectors give a point.
#pragma once

#include <array>

#include "pn/algebra/rational.hpp"

namespace pn {

enum class RationalPoints {
  kExist,
  kNone,
  kUnknown,  ///< a coefficient has a factor too large to be factored quickly
};

struct PointOnConic {
  RationalPoints points;
  std::array<Rational, 3> point;  ///< coprime integers where points exist
};

/// Of x^T C x = 0 for a symmetric matrix that is not singular.
PointOnConic rational_point_on_conic(const std::array<std::array<Rational, 3>, 3>& conic);

}  // namespace pn
