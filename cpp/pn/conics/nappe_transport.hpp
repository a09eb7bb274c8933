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
// Decided over Q: on small intervals one vector is inside the cone, by Bernstein coefficients, and
// where two intervals meet the sign of v^T Q v' says whether both lie in the same nappe.
#pragma once

#include "pn/conics/rational_lattice.hpp"

namespace pn {

/// a mod 2, for the conic of a lattice without real zeros of its determinant and the degree m
/// that its steps at nonreal places lead to.
int parity_of_splitting(const RationalLattice& lattice, int m);

}  // namespace pn
