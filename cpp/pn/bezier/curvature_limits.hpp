// SPDX-License-Identifier: LGPL-2.1-or-later
// Curvature limits: the distances at which a rational surface has no singular offset.
//
// Let x(u, v) be an immersed surface with unit normal n, and k1, k2 its principal curvatures with
// the sign for which k > 0 where the surface bends towards n: the focal points are x + n / k. Let
// K = k1 k2 and 2 H = k1 + k2.
//
// THEOREM 1. No offset x + e n with 0 <= e <= d is singular at a point exactly when
//
//     1 - 2 H d + K d^2 > 0     and     H d < 1.
//
// Proof: x + e n has the derivatives (1 - e ki) x_i along the lines of curvature, so it is regular
// for all these e exactly when 1 - e k1 > 0 and 1 - e k2 > 0 for all of them, and since these are
// linear in e and 1 at e = 0, exactly when they are positive at d. Two real numbers are positive
// exactly when their product and their sum are. QED. (The product alone does not suffice: beyond
// the second of two focal points on one side it is positive again. There both factors are negative,
// and K d^2 = (1 + |1 - d k1|) (1 + |1 - d k2|) > 1.)
//
// THEOREM 2. Let x = X / w with w > 0, and let the polynomials
//
//     N = w X_u x X_v + w_u X_v x X + w_v X x X_u,    N0 = -X.(X_u x X_v)
//
// be the plane coordinates of the tangent plane, (N, N0) = c (N^, N^0) with common factor c > 0.
// With indices i, j for u, v let
//
//     l_ij = N^.X_ij + N^0 w_ij,    a_i = w X_i - w_i X,    S = N^.N^,
//     kappa = l_uu l_vv - l_uv^2,
//     eta = (a_u.a_u) l_vv - 2 (a_u.a_v) l_uv + (a_v.a_v) l_uu.
//
// Then for n = side (x_u x x_v) / |x_u x x_v|
//
//     K = w^4 kappa / (c^2 S^2),      2 H = side w eta / (c^2 S sqrt(S)).
//
// Proof: x_u x x_v = N / w^3. From w x_ij = X_ij - w_ij x - w_i x_j - w_j x_i, N.x_i = 0 and
// N.x = -N0 follows x_ij.N = c l_ij / w, so the second fundamental form is side l_ij / (w sqrt(S)).
// The first is a_i.a_j / w^4, with determinant c^2 S / w^6. QED.
//
// Degrees: for x of bidegree (p, q) those of S are (6 p - 4, 6 q - 4), those of w^4 kappa and c^2
// S^2 (12 p - 8, 12 q - 8); less by the common factors that kappa, eta and c^2 have, which cancel
// too. On a quadric N^ is of the degree of x. A polynomial ruled surface of bidegree (p, 1) has S
// of (4 p - 2, 2).
//
// COROLLARY. Let U = c^2 S^2, V = w^4 kappa, T = side w eta. For d > 0 no distance in [0, d] is
// singular at a point exactly when A > T' sqrt(S) and T' sqrt(S) < 2 U, where A = U + d^2 V and
// T' = d T. With B = A^2 - T'^2 S = U^2 + d^2 (2 U V - T^2 S) + d^4 V^2 this holds where
//
//     A > 0, B > 0, U - d^2 V > 0     or     A > 0, T < 0     or     T < 0, B < 0.
//
// Proof: the first says |T'| sqrt(S) < A < 2 U. In the second and third T' sqrt(S) is negative,
// hence less than 2 U, and A is positive or of the smaller magnitude. Conversely, every regular
// point is in the interior of one of the three sets: if T < 0 by the signs of A and, for A <= 0, of
// B = A^2 - T'^2 S; if T >= 0 then A > 0 and B > 0, and either K <= 0, or both 0 <= d ki < 1 and so
// K d^2 < 1. QED. For d < 0 the same holds with |d| and -T. A distance is certified by Bernstein
// coefficients: of B, of bidegree (24 p - 16, 24 q - 16) at most, of A, T and U - d^2 V.
#pragma once

#include <vector>

#include "pn/bezier/offset_limits.hpp"
#include "pn/isotropic/rational_patch.hpp"

namespace pn {

/// The certified range of distances: it lies inside the true one, and an end is infinite where
/// nothing limits it. The finite ends are within a few times `tolerance` [mm] of the true ones,
/// except where the curvature is largest along a whole line that is not a parameter line: there
/// they stay behind by as much as a proof of bounded length needs. The empty range {0, 0} where
/// x_u x x_v = 0 somewhere, or where nothing can be proved.
OffsetRange curvature_limits(const std::vector<RationalPatch>& patches, double tolerance);

}  // namespace pn
