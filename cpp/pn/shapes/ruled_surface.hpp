// SPDX-License-Identifier: LGPL-2.1-or-later
// Ruled surfaces between two curves, and envelopes of cones between two families of spheres.
//
// THEOREM. The offsets of a rational ruled surface that is not developable are rational. Between
// polynomial curves of degree k they have the bidegree (k + 4 ceil(k/2) + k - 1, 4): 5, 7, 13, 15,
// 21, 23 along for k = 1..6. The same holds of every envelope of cones of revolution that join
// spheres of equal parameter, a line being the cone of two points. (M. Peternell, dissertation TU
// Wien 1997, Theorem 4.5, Corollary 4.2; degrees: along_rulings.hpp.)
//
// Of developable surfaces those are exact whose normal has a rational length (developable.hpp):
// planes, cylinders and cones of revolution, parabolic cylinders. Others are refused.
//
// Orientation: with c(t, v) = (1 - v) c0(t) + v c1(t) the normal is on the side of c_t x c_v; d > 0
// lies there. The result covers 0 <= v <= 1 and no more.
#pragma once

#include "pn/isotropic/envelope_chain.hpp"
#include "pn/shapes/curve.hpp"

namespace pn {

/// The surface whose rulings join points of equal parameter; the domain of the second curve is
/// mapped to that of the first. Throws GeometryError.
EnvelopeChain ruled_surface(const Curve& first, const Curve& second);

/// The same between two curves over one span on [0, 1], whose spheres are points.
EnvelopeChain ruled_surface(const SphereCurve& first, const SphereCurve& second);

/// The envelope of the cones of revolution that touch the spheres of equal parameter: the sheet
/// with the normal on the side of c_t x c_v. Where the cones have a curve of vertices that they
/// touch (the family is developable) this is the canal surface along that curve. Throws
/// GeometryError.
EnvelopeChain cone_envelope(const Curve& first_centres, const Law& first_radii,
                            const Curve& second_centres, const Law& second_radii);

}  // namespace pn
