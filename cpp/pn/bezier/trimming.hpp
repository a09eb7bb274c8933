// SPDX-License-Identifier: LGPL-2.1-or-later
// Trimming: the edges of a face in its parameter plane.
//
// The boundary of what is wanted is no parameter line of the surface, since its normals are not
// rational in t. It is known pointwise instead: a normal on the circle of t has the parameter u
// with n(A u) = n. The edges of a face are splines through such points (parameter_curve.hpp), the
// same for all distances, because all sections have the same parameters; how far they lie from the
// true boundary at a distance is measured on that section.
#pragma once

#include <vector>

#include "pn/bezier/parameter_curve.hpp"
#include "pn/bezier/section_net.hpp"

namespace pn {

/// A piece of a boundary: the curve of the face, and the path that it follows; no path where it
/// runs along a side of the parameter rectangle.
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

/// The faces of a chain on the net of it. A face of the net without any part of the region is left
/// out, one with several parts comes once for each.
std::vector<TrimmedFace> trimmed_faces(const EnvelopeChain& chain, const SectionNet& net);

/// The curves of a face's loops.
std::vector<TrimLoop> curves_of(const TrimmedFace& face);

/// The largest distance [mm] of a point of an edge from the true boundary of a section: measured.
double trim_deviation(const BSplineSurface& section, const TrimmedFace& face);

}  // namespace pn
