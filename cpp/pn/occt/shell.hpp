// SPDX-License-Identifier: LGPL-2.1-or-later
// A shell of B-spline faces whose neighbours share their edges.
#pragma once

#include <TopoDS_Shell.hxx>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"

namespace pn {

/// One face for each surface, joined wherever two sides coincide.
///
/// - Two sides are one edge when their curves coincide in either direction (boundary.hpp); the two
///   may belong to one surface, which is then closed and has a seam.
/// - Ends of sides that are equal bit for bit are one vertex.
/// - A side that is a single point is a degenerate edge.
///
/// Every face is bounded by the whole of its surface. Faces point along S_u x S_v; where two
/// neighbours disagree, the later one is reversed. The shell is marked closed when no edge is free.
/// An edge is marked as smooth as its faces are there. Tolerances are OpenCASCADE's smallest, 1e-7.
///
/// Throws std::invalid_argument when there is no surface, when the faces do not hang together by
/// edges, when more than two meet at an edge, or when the shell would be one-sided; as to_geometry
/// does for a surface that is none.
TopoDS_Shell make_shell(const std::vector<BSplineSurface>& surfaces);

}  // namespace pn
