// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids between two surfaces.
#pragma once

#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"

namespace pn {

/// The solid between two closed shells, one inside the other: its material lies inside `outer` and
/// outside `inner`, which bounds a void. Its volume is that inside `outer` less that inside
/// `inner`.
///
/// The faces of the solid point away from the material, whichever way those of the shells do. That
/// the shells do not touch is not examined: two offsets of one surface between its singular
/// distances do not.
///
/// Throws std::invalid_argument when a shell is open, or when `inner` has a vertex that is not
/// inside `outer`.
TopoDS_Solid make_thick_solid(const TopoDS_Shell& inner, const TopoDS_Shell& outer);

/// The solid between two shells with as many free sides, each of `inner` with its counterpart at
/// the same place of `outer`: two offsets of one surface, or two pipes around one spine.
///
/// Closed shells make a solid with a void, as above. Open ones are joined by walls, one along every
/// free side: the ruled surface that joins points of equal parameter, exact, of degree 1 across.
/// Neighbouring walls share their rulings. The faces come in the order inner, outer, walls.
///
/// Throws std::invalid_argument when free sides that correspond differ in degree, knots or
/// multiplicities, when a face of open shells is trimmed, and as make_shell does.
TopoDS_Solid make_thick_solid(const std::vector<BSplineSurface>& inner,
                              const std::vector<BSplineSurface>& outer);

}  // namespace pn
