// SPDX-License-Identifier: LGPL-2.1-or-later
// Parity of a family of conics without singular ones.
//
// THEOREM. Let Q have signature (2, 1), up to its sign, for all t of the projective line, and let
// the lattice have the degree m - a, m, m + a once all nonreal zeros of det Q are removed. The
// vectors with y^T Q(t) y < 0 are a double cone; carry one of its nappes once around the line. It
// returns as itself if a is even and as the other nappe if a is odd.
//
// Proof: steps at nonreal places do not change the real bundle. For a = 0 the double cone is
// constant in O(-m)^3. For a > 0, Q is a hyperbolic plane in O(a - m) + O(-a - m) and a square, and
// the cone lies in the plane, whose lines are turned a times.
//
// THEOREM. Let Q have signature (2, 1) for all real t, let p and q be constant vectors, and
//     d1 = p.Qp,    d2 = (p.Qp)(q.Qq) - (p.Qq)^2,
//     v1 = p,       v2 = (p.Qp) q - (p.Qq) p,       v3 = Qp x Qq,
// where d1 and p.Qq have no common real zero. For every t one of the v is in the double cone or on
// its boundary: v1 where d1 <= 0, v2 where d1 >= 0 >= d2, v3 where d2 >= 0. From t = -oo to oo they
// are carried along in one nappe, up to the product of the signs of -p.Qq at the real zeros of d1
// and of v3.(|p|^2 q - (p.q) p) at those of d2.
//
// Proof (C. G. J. Jacobi's orthogonalization): the v are orthogonal for Q, v_k.Q v_k has the sign
// of the quotient of two consecutive minors 1, d1, d2, det Q, and one of these is negative. At a
// zero of d1, d2 = -(p.Qq)^2 < 0 and v2 = -(p.Qq) v1. So d1 > 0 at a zero of d2, where p and q span
// a plane that touches the cone along the line of both v2 and v3: v3 is v2 times its coefficient at
// q through d1, and that has the sign of the product named. A vector on the boundary that is not
// zero lies on one nappe only. At zeros of even multiplicity v remains, and both signs cancel. ∎
//
// So the parity is a product of signs at the real zeros of two polynomials, and of those of one
// vector that is in the cone at infinity, at both ends: exact, and without intervals that are
// halved until one vector is in the cone all along, which takes long where the cone is thin.
#pragma once

#include "pn/conics/rational_lattice.hpp"

namespace pn {

/// a mod 2, for the conic of a lattice without real zeros of its determinant and the degree m
/// that its steps at nonreal places lead to.
int parity_of_splitting(const RationalLattice& lattice, int m);

}  // namespace pn
