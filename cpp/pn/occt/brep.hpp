// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes as text in OpenCASCADE's BREP format, which carries them between versions of OpenCASCADE.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>

namespace pn {

/// The shape as BREP text, with its triangulations if it has any. Every double of curves, surfaces
/// and vertices is kept.
std::string to_brep(const TopoDS_Shape& shape);

/// The shape in a BREP text. Throws std::invalid_argument when there is none.
TopoDS_Shape from_brep(const std::string& text);

}  // namespace pn
