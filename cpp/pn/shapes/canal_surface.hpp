// SPDX-License-Identifier: LGPL-2.1-or-later
// Canal surfaces: the envelope of spheres of radius r(t) that move along a spine m(t).
//
// THEOREM. For rational m and r with |r'| < |m'| the canal surface x = m + r n and all its offsets
// x + d n = m + (r + d) n are rational, with the same unit normal n, n.m' + r' = 0. If D = |m'|^2 -
// r'^2 has no real root, at infinity neither, the bidegree is (k + 2 ceil((k-1)/2), 2) for
// polynomial m and r of degree k, (3k - 2, 2) for rational ones with the same denominator. Odd real
// roots of D outside the span double the degree of the parameter (odd_root_substitution.hpp). (M.
// Peternell, H. Pottmann, Computing rational parametrizations of canal surfaces, J. Symb. Comp. 23,
// 1997; the degrees are those of the spinor factorization.)
//
// Orientation: n points away from the spine; d > 0 makes the pipe thicker. The surface touches the
// sphere of parameter t along a circle. Straight spines with linear radius give cones and
// cylinders, circular spines with constant radius give tori, by the same construction.
//
// At a corner of the spine (or a kink of the radius law) the spheres stand still while their circle
// turns: the envelope there is the zone of the sphere between the two circles. Where the circles
// meet, the zone has two parts: the outer one closes the gap, the inner one overlaps with the pipe,
// as the envelope really does.
#pragma once

#include "pn/isotropic/envelope_chain.hpp"
#include "pn/shapes/sphere_spans.hpp"

namespace pn {

/// Throws GeometryError with the parameter interval and the place where the input admits no
/// envelope.
EnvelopeChain canal_surface(const Curve& spine, const Law& radius);
/// The same along spans that continue each other.
EnvelopeChain canal_surface(std::vector<SphereSpan> spans);

}  // namespace pn
