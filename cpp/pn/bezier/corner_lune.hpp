// SPDX-License-Identifier: LGPL-2.1-or-later
// Corner lunes: the part of the sphere at a corner of a quadratic family between the strips along
// its edges.
//
// Its two sides are the end circles of the strips, its two tips the points of the skins. The patch
// is a parallelogram of stereographic parameters around it (stereographic.hpp): exactly on the
// sphere, without a pole, of bidegree (2, 2). Its degree is raised until all weights are positive:
// that of a form that is positive on the parallelogram becomes so. The sides are circles there.
#pragma once

#include "pn/bezier/edge_strip.hpp"

namespace pn {

/// The lune at the end of an edge of the triangle, where the next one begins. Throws GeometryError
/// when the edges run nearly in one line.
ExactPatch corner_lune(const QuadraticFamily& family, std::size_t edge);

}  // namespace pn
