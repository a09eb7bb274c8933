// SPDX-License-Identifier: LGPL-2.1-or-later
// Base points: the normals that a sheet of a quadratic family has along a whole line.
//
// THEOREM. The points of both sheets with e = 0, which are those of vanishing Gauss curvature, are
// in the (u, v)-plane at most six straight lines. Along each of them the normal is constant: the
// sheet touches a plane along a curve, as a torus does on top.
//
// Proof: with qi = <w, ai> the contact satisfies q1 u + q2 v + q4 = q2 u + q3 v + q5 = 0. Where e =
// q1 q3 - q2^2 = 0 these are consistent only if the 2 x 3 matrix of their coefficients has rank 1,
// and then a whole line of (u, v) has this w. Rank 1 means that for some (l : m)
//
//     <w, l a1 + m a2> = <w, l a2 + m a3> = <w, l a4 + m a5> = 0,
//
// so w is the cross product of three linear forms in (l : m), a cubic, and <w, w> = 0 is a sextic.
// QED. These six w are the common zeros of a, b, e in along_surface.hpp, the base points of the map
// from normals to parameters. (The double cover of the plane by the normals is a del Pezzo surface
// of degree two, the sphere blown up in six points.)
#pragma once

#include <vector>

#include "pn/algebra/ball.hpp"
#include "pn/isotropic/quadratic_family.hpp"

namespace pn {

/// The base points at real simple roots of the sextic, w with w4 > 0, enclosed with about this
/// precision in bits; their order does not depend on it. Throws Undecided when it does not suffice.
std::vector<MinkowskiVector<RealBall>> base_points(const QuadraticFamily& family, long precision);

}  // namespace pn
