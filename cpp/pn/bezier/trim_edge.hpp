// SPDX-License-Identifier: LGPL-2.1-or-later
// Trim edges: the boundary of a face in its parameter plane, with what it follows.
//
// The boundary of what is wanted is seldom a parameter line of the surface, but it is known
// pointwise. Its edges are splines through such points (parameter_curve.hpp), the same for all
// distances, because all sections have the same parameters; how far they lie from the true
// boundary at a distance is measured on that section.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"
#include "pn/bezier/parameter_curve.hpp"

namespace pn {

/// A piece of a boundary: the curve of the face, and the path that it follows; no path where it
/// is exact.
struct TrimEdge {
  ParameterCurve curve;
  ParameterPath path;
};

using TrimEdgeLoop = std::vector<TrimEdge>;

/// One face of a net, as exported: its loops, the outer one first; none when it is whole.
struct TrimmedFace {
  std::size_t net_face;
  std::vector<TrimEdgeLoop> loops;
};

/// The edge that follows a path to within a tolerance in both parameters.
TrimEdge edge_along(const ParameterPath& path, double tolerance);

/// The straight edge.
TrimEdge straight_edge(const std::array<double, 2>& start, const std::array<double, 2>& end);

/// The curves of a face's loops.
std::vector<TrimLoop> curves_of(const TrimmedFace& face);

/// The largest distance [mm] of a point of an edge from the true boundary of a section: measured.
double trim_deviation(const BSplineSurface& section, const TrimmedFace& face);

}  // namespace pn
