// SPDX-License-Identifier: LGPL-2.1-or-later
// Shells of B-spline faces whose neighbours share their edges.
#pragma once

#include <TopoDS_Shell.hxx>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"
#include "pn/occt/shared_edges.hpp"

namespace pn {

/// A shell for each set of surfaces that hang together by edges, in the order of their first
/// surfaces.
///
/// There is one face for each surface, within its trims, joined wherever two sides coincide.
///
/// - Two sides, or pieces of sides, are one edge when they coincide in either direction
///   (boundary.hpp); the two may belong to one surface, which is then closed and has a seam.
/// - Edges that meet in a corner of a face, and ends of edges that are equal bit for bit, share a
///   vertex.
/// - A side that is a single point is a degenerate edge.
/// - Sides are exact; trims lie within 1e-9 mm of their surface, which `trim_deviation` measures
///   (curve_on_surface.hpp). Trims of two faces with the same points are one edge.
///
/// Faces point along S_u x S_v; where two neighbours disagree, the later one is reversed. A shell
/// is marked closed when no edge is free. An edge is marked as smooth as its faces are there.
/// Tolerances are OpenCASCADE's smallest, 1e-7.
///
/// Throws std::invalid_argument when there is no surface, when more than two faces meet at an edge,
/// or when a shell would be one-sided; as to_geometry does for a surface that is none and
/// boundary_loops for trims that bound nothing.
std::vector<TopoDS_Shell> make_shells(const std::vector<BSplineSurface>& surfaces);

/// The one shell of surfaces that hang together.
///
/// Throws std::invalid_argument when they do not, and as make_shells does.
TopoDS_Shell make_shell(const std::vector<BSplineSurface>& surfaces);

/// A surface of OpenCASCADE, its own and no other's, and the boundary of a face on it.
struct BoundedSurface {
  Handle(Geom_BSplineSurface) geometry;
  FaceBoundary boundary;
};

/// The shells, as above, of faces whose boundaries were collected by `edges`.
std::vector<TopoDS_Shell> make_shells(const SharedEdges& edges,
                                      const std::vector<BoundedSurface>& faces);

}  // namespace pn
