// SPDX-License-Identifier: LGPL-2.1-or-later
// OpenCASCADE's own ways to a pipe, with the settings that do best.
#pragma once

#include "canal_cases.hpp"
#include "made_shape.hpp"

namespace pn::bench {

/// BRepOffsetAPI_MakePipeShell: a circle of constant radius along the spine, corrected Frenet
/// frame. The radius of `canal` is constant.
MadeShape swept_circle(const BezierCanal& canal, Tolerance tolerance);

/// BRepOffsetAPI_MakePipeShell: a circle that the radius law scales.
MadeShape swept_circle_with_law(const BezierCanal& canal, Tolerance tolerance);

/// GeomFill_Pipe by the radius. The radius of `canal` is constant.
MadeShape filled_pipe(const BezierCanal& canal, Tolerance tolerance);

/// GeomFill_Pipe through 21 circles in normal planes.
MadeShape filled_pipe_through_circles(const BezierCanal& canal, Tolerance tolerance);

/// BRepOffsetAPI_ThruSections: a loft through so many circles, those in which the spheres touch
/// their envelope. OpenCASCADE does not make them: the caller has to know the theory.
MadeShape loft_through_characteristic_circles(const BezierCanal& canal, int circles);

}  // namespace pn::bench
