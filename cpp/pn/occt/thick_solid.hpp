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

/// The solids between two surfaces with as many free edges, each of `inner` with its counterpart at
/// the same place of `outer`: two offsets of one surface, or two pipes around one spine. There is
/// one solid for each part that hangs together.
///
/// Closed shells make a solid with a void, as above. Open ones are joined by walls, one along every
/// free edge: the ruled surface that joins points of equal parameter, of degree 1 across. Along
/// sides a wall is exact; along the same trims of two offsets both of its edges are fitted over the
/// same knots, to 1e-9 mm, and it is exact between them. Neighbouring walls share their rulings.
/// The faces of a solid come in the order inner, outer, walls.
///
/// Throws std::invalid_argument when free edges that correspond differ in degree, knots or
/// multiplicities, as those along different trims do, when one shell is closed and another open,
/// and as make_shells does.
std::vector<TopoDS_Solid> make_thick_solids(const std::vector<BSplineSurface>& inner,
                                            const std::vector<BSplineSurface>& outer);

/// The one solid between two offsets that hang together.
///
/// Throws std::invalid_argument when they do not, and as make_thick_solids does.
TopoDS_Solid make_thick_solid(const std::vector<BSplineSurface>& inner,
                              const std::vector<BSplineSurface>& outer);

}  // namespace pn
