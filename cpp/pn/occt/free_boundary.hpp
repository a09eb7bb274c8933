// SPDX-License-Identifier: LGPL-2.1-or-later
// The open ends of a shell, and the solid when they are closed.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <functional>

namespace pn {

/// Makes the face that closes a free boundary. The wire runs against the faces of the shell: the
/// cap lies to its left.
using MakeCap = std::function<TopoDS_Face(const TopoDS_Wire&)>;

/// A new shell of the faces of `shell` and a cap on every free boundary.
///
/// Throws std::invalid_argument when a free boundary is not closed.
TopoDS_Shell closed_by(const MakeCap& make_cap, const TopoDS_Shell& shell);

/// The solid inside a closed shell, its faces pointing outwards whichever way those of the shell
/// do.
TopoDS_Solid solid_inside(const TopoDS_Shell& shell);

}  // namespace pn
