// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangulations of whole B-spline faces, for drawing.
//
// FreeCAD has OpenCASCADE divide every face in the thread of its window, and the general algorithm
// for this takes a minute and millions of triangles for a pipe of 10 m by 1 mm. A face that is
// bounded by the four sides of its surface needs no search: the grid of its parameters is a
// triangulation, and grids of neighbours fit because they take the same steps between the same
// knots. OpenCASCADE keeps a triangulation that it finds on a face if it is fine enough, and makes
// its own otherwise.
#pragma once

#include <TopoDS_Shape.hxx>

namespace pn {

/// The same shape, of which every face on a whole B-spline surface has a triangulation, and its
/// edges polygons on it; other faces are left as they are.
///
/// Every knot span is divided into equal steps, nine where that makes no more than some ten
/// thousand nodes (a quarter of a circle turns by 10 degrees a step), else fewer, at least two; a
/// span of a straight direction is one step. The deflection that is stored is the largest distance
/// from the middle of a mesh of the grid to its surface, for OpenCASCADE to judge by.
TopoDS_Shape triangulated(const TopoDS_Shape& shape);

}  // namespace pn
