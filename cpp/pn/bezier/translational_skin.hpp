// SPDX-License-Identifier: LGPL-2.1-or-later
// Translational skins: the sheets of a translational spline of spheres, as faces.
//
// A face for every pair of spans: in the circle chart of the one curve or of the other, whichever
// has the better weights (circle_chart.hpp), or in (u, v) itself where its sheets are separated
// (separated_patch.hpp). Where neither chart has weights that are even enough, a span is halved,
// the one that gains more by it, for all pairs with it: so neighbours share whole edges, in the
// designer's parameter. Where c' and d' have one direction on both sides of a joint the normals of
// both faces agree there, and the skin is G1: n depends on the directions of f_u and f_v only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pn/bezier/exact_patch.hpp"
#include "pn/bezier/skin_patch.hpp"
#include "pn/isotropic/translational_family.hpp"

namespace pn {

/// The patch of a sheet over the unit square with the best weights; nothing where no weights are
/// positive. Delta > 0.
std::optional<SkinPatch> best_patch(const TranslationalFamily& family, Sheet sheet);

class TranslationalSkin : public PatchSource {
 public:
  /// Delta > 0 on all families of the spline, and neither of its curves has a corner. Throws
  /// GeometryError when no patches with positive weights are found.
  TranslationalSkin(const TranslationalSpline& spline, Sheet sheet, std::vector<std::string> notes);

  /// By the corollary of quadratic_family.hpp: inside the true one, and the same for both sheets.
  OffsetRange regular_range() const override;

 private:
  TranslationalSpline spline_;
};

}  // namespace pn
