// SPDX-License-Identifier: LGPL-2.1-or-later
// B-spline surfaces as plain data and as OpenCASCADE's geometry, the same doubles in both.
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"

namespace pn {

/// A new OpenCASCADE surface with the degrees, knots, poles and weights of `surface`.
///
/// OpenCASCADE keeps weights only where they differ: weights that are all equal become 1.
/// Throws std::invalid_argument when the arrays do not fit together or hold a number that is not
/// finite, OcctError when OpenCASCADE refuses the surface (a degree above 25, a weight that is not
/// positive).
Handle(Geom_BSplineSurface) to_geometry(const BSplineSurface& surface);

/// The surface as plain data.
///
/// A periodic surface, which STEP readers make of every closed one, comes back clamped: its first
/// row or column of poles is repeated at the end. Throws std::invalid_argument for a surface that
/// is neither clamped nor periodic.
BSplineSurface from_geometry(const Geom_BSplineSurface& geometry);

/// The surfaces under the faces of `shape`, whole even where a face is trimmed.
///
/// Throws std::invalid_argument when a face lies on another kind of surface.
std::vector<BSplineSurface> bspline_surfaces(const TopoDS_Shape& shape);

}  // namespace pn
