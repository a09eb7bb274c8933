// SPDX-License-Identifier: LGPL-2.1-or-later
// Skins: the sheets of a quadratic family of spheres over its triangle, as faces.
//
// A skin is one patch (skin_patch.hpp) where its weights allow, else one for each of the four
// triangles between the corners and the middles of the edges, and so on: each of them is a
// quadratic family again. Its faces are trimmed by the images of the edges, which are divided where
// the edges of neighbours end: every edge is that of one neighbour, in the same parameter or the
// opposite one.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "pn/bezier/exact_patch.hpp"
#include "pn/bezier/skin_patch.hpp"

namespace pn {

/// A patch over a part of the triangle.
struct PlacedPatch {
  SkinPatch patch;
  std::array<std::array<double, 2>, 3> corners;  ///< (u, v) of its corners w = 1, u = 1, v = 1
};

/// The patches of a sheet. Throws GeometryError when none with positive weights are found.
std::vector<PlacedPatch> skin_patches(const QuadraticFamily& family, Sheet sheet);

/// The parameters in (0, 1) at which patches end along an edge of the whole triangle, rising.
std::vector<double> ends_along(const std::vector<PlacedPatch>& patches, std::size_t edge);

/// The patches with their boundaries, in the same order. Edges end at corners of patches, and where
/// those of neighbours end: at `more` points (u, v) on the edges of the whole triangle.
std::vector<ExactPatch> exact_patches(const std::vector<PlacedPatch>& patches,
                                      const std::vector<std::array<double, 2>>& more = {});

/// The range of distances d with |r + d| <= R on the triangle for the regular radius R.
OffsetRange regular_range(const QuadraticFamily& family);

class Skin : public PatchSource {
 public:
  /// Delta > 0 on the triangle of the family. Throws GeometryError when no patches with positive
  /// weights are found.
  Skin(const QuadraticFamily& family, Sheet sheet, std::vector<std::string> notes);

  /// By the corollary of quadratic_family.hpp: inside the true one, and the same for both sheets.
  OffsetRange regular_range() const override;

 private:
  QuadraticFamily family_;
};

}  // namespace pn
