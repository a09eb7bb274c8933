// SPDX-License-Identifier: LGPL-2.1-or-later
// Spline skins: the sheets of a spline of quadratic families, as faces.
//
// The patches of every piece are those of its skin (skin.hpp). Where the spline is C1 they meet
// with the same normals (family_spline.hpp): neighbours have the same spheres and derivatives along
// their common edge, hence the same points at the same parameters, and each ends its edges also
// where the other one does.
#pragma once

#include <string>
#include <vector>

#include "pn/bezier/exact_patch.hpp"
#include "pn/isotropic/family_spline.hpp"
#include "pn/isotropic/sheet.hpp"

namespace pn {

/// Faces: those of one piece after the other.
class SplineSkin : public PatchSource {
 public:
  /// Delta > 0 on all pieces. Throws GeometryError, which names the designer's triangle, when no
  /// patches with positive weights are found.
  SplineSkin(const FamilySpline& spline, Sheet sheet, std::vector<std::string> notes);

  /// By the corollary of quadratic_family.hpp: inside the true one, and the same for both sheets.
  OffsetRange regular_range() const override;

 private:
  std::vector<FamilyPiece> pieces_;
};

}  // namespace pn
