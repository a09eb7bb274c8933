// SPDX-License-Identifier: LGPL-2.1-or-later
// Curves on a surface: p-curves and their images in space.
//
// The image S(c(t)) of a p-curve c(t) has the degree of c times that of S, far above what CAD
// systems take. So it is fitted, in the same parameter t: this and a trim itself are the only
// things in a shape that are not exact. How far a fit is off can be measured.
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"

namespace pn {

/// A new OpenCASCADE curve with the degree, knots and poles of `curve`.
Handle(Geom2d_BSplineCurve) to_geometry(const ParameterCurve& curve);

/// The images of a p-curve on several surfaces, all C1 and over the same knots, in the parameter of
/// the p-curve. The greatest distance that the fit admits is 1e-9 mm.
///
/// Throws OcctError when that cannot be reached with 1000 spans of degree 14.
std::vector<Handle(Geom_BSplineCurve)> curves_on_surfaces(
    const Handle(Geom2d_BSplineCurve) & p_curve,
    const std::vector<Handle(Geom_BSplineSurface)>& surfaces);

/// Greatest distance, in mm, between an edge of `shape` and the image of one of its p-curves at the
/// same parameter. Measured at many points of every knot span, not proved. Exact edges contribute
/// their rounding. Edges without p-curve, as those of planar caps, do not count.
double trim_deviation(const TopoDS_Shape& shape);

}  // namespace pn
