// SPDX-License-Identifier: LGPL-2.1-or-later
// Solids from shells, open ends closed by planar faces.
#pragma once

#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

namespace pn {

/// The solid inside `shell`, with a planar face on every free boundary.
///
/// A cap uses the very edges of the boundary. A closed shell becomes a solid as it is. The faces of
/// the solid point outwards, whichever way those of the shell do.
///
/// Throws std::invalid_argument when a free boundary is not closed or leaves its plane by more than
/// OpenCASCADE's tolerance, 1e-7 mm.
TopoDS_Solid make_capped_solid(const TopoDS_Shell& shell);

}  // namespace pn
