// SPDX-License-Identifier: LGPL-2.1-or-later
// Flat sheets: those of a translational family that are planes.
//
// With one normal n everywhere the sheet is m + r n in the parameters of the family itself:
// polynomial, of bidegree (2, 2), bounded by its parameter lines. Only n has a root, that of Delta
// at a corner.
#pragma once

#include "pn/bezier/skin_patch.hpp"
#include "pn/isotropic/translational_family.hpp"

namespace pn {

/// The patch of a flat sheet over the unit square. Delta > 0.
SkinPatch flat_patch(const TranslationalFamily& family, Sheet sheet);

}  // namespace pn
