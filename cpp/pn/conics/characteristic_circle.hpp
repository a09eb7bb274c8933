// SPDX-License-Identifier: LGPL-2.1-or-later
// The circle along which a sphere of a one-parameter family touches their envelope.
//
// THEOREM. Let c(t) be a rational curve of spheres in P^4 (moebius_model.hpp). Where its tangent
// line joins c to c' and misses the quadric Q, the sphere touches the envelope along the circle
// that all spheres of this pencil share, and the envelope is a rational surface. Centres and radii
// need not be rational functions: the squared radius is one. (M. Peternell, dissertation TU Wien
// 1997, Theorem 2.3.)
//
// The circle is the intersection of a sphere of the pencil and the plane in it, so it is a moving
// conic, with real points exactly where the Gram determinant of c and c' is positive. For a centre
// of degree k and a squared radius of degree 2 k, both polynomials, the envelope has degree 2 k - 1
// in t for odd k and 2 k for even k; for a common denominator of degree k, of centre and radius, it
// has degree 3 k - 2: no more than with a rational radius (rational_conic_family.hpp).
#pragma once

#include <vector>

#include "pn/conics/moving_conic.hpp"
#include "pn/minkowski/moebius_model.hpp"

namespace pn {

/// The spheres of the line in P^4 that joins two moving points.
struct MovingPencil {
  MoebiusPoint<RationalPolynomial> first, second;
};

/// The pencil of tangents: c and its derivative.
MovingPencil tangent_pencil(const MoebiusPoint<RationalPolynomial>& curve);

/// The coordinates p_i q_j - p_j q_i, i < j, of the line without common factors; all zero when the
/// two points are the same for all t.
std::vector<RationalPolynomial> line_coordinates(const MovingPencil& pencil);

/// The Gram determinant of these coordinates: positive exactly where the spheres share a circle,
/// also where the curve stands still for a moment.
RationalPolynomial circle_discriminant(const std::vector<RationalPolynomial>& line);

/// Where the discriminant is positive. Not all spheres of the pencil are planes.
MovingConic shared_circle(const MovingPencil& pencil);

}  // namespace pn
