// SPDX-License-Identifier: LGPL-2.1-or-later
// Corner lunes: the part of the sphere at a corner of a quadratic family between the strips along
// its edges.
//
// Its two sides are the end circles of the strips, its two tips the points of the skins. With the
// spinors a, b of the normals at the tips, the circles through both are a + c b, c on a ray from
// zero, so
//
//     z0(x) a + z1(x) l(y) b,     z0, z1 >= 0 quadratic, l quadratic around zero,
//
// covers the lune with bidegree (4, 4) and positive weights: y = 0 and y = 1 are its sides, x = 0
// and x = 1 its tips. All numbers are short or doubles: the patch is exactly on the sphere.
#pragma once

#include "pn/bezier/edge_strip.hpp"

namespace pn {

/// The lune at the end of an edge of the triangle, where the next one begins; its first parameter
/// runs from edge to edge, the second from the inner to the outer skin.
ExactPatch corner_lune(const QuadraticFamily& family, std::size_t edge);

}  // namespace pn
