// SPDX-License-Identifier: LGPL-2.1-or-later
// Separated patches: a sheet with a rational normal, in the parameters of the family itself.
//
// Where both sheets have rational normals of their own (separated_sheets.hpp) they need no chart of
// normals: the triangle is half of the unit square, and its edges are straight lines in it, so they
// are rational curves in space. The weight is |N|^2 > 0 up to a factor.
#pragma once

#include <optional>

#include "pn/bezier/skin_patch.hpp"

namespace pn {

/// The patch of a sheet over its triangle; nothing when the sheets are not separated. Its weights
/// are positive on the triangle, but need not be so beyond it. Delta > 0.
std::optional<SkinPatch> separated_patch(const QuadraticFamily& family, Sheet sheet);

}  // namespace pn
