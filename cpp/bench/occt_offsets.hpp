// SPDX-License-Identifier: LGPL-2.1-or-later
// OpenCASCADE's own ways to an offset, with the settings that do best, from its own surfaces.
#pragma once

#include <TopoDS_Face.hxx>

#include "made_shape.hpp"
#include "offset_cases.hpp"

namespace pn::bench {

/// The face whose offset is asked for, its normal S_u x S_v on the side of positive distances.
///
/// Quadrics of revolution are made by OpenCASCADE and stretched, which makes B-splines of them; the
/// others are Bezier patches: biquadratic over a rectangle, rational biquadratic in stereographic
/// parameters, of degree 1 across rulings. Throws std::invalid_argument for a kind of quadric that
/// is not measured.
TopoDS_Face base_face(const OffsetBase& base);

/// Geom_OffsetSurface: the definition of an offset, not a surface with poles.
MadeShape offset_entity(const OffsetCase& offset);

/// GeomConvert_ApproxSurface of that entity, C1 and of degree 8 at most.
MadeShape approximated_offset(const OffsetCase& offset, Tolerance tolerance);

/// BRepOffsetAPI_MakeOffsetShape by join, which FreeCAD's offset calls. Throws std::runtime_error
/// with OpenCASCADE's reason where it fails.
MadeShape joined_offset(const OffsetCase& offset, Tolerance tolerance);

}  // namespace pn::bench
