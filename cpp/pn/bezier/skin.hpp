// SPDX-License-Identifier: LGPL-2.1-or-later
// Skins: the sheets of a quadratic family of spheres over its triangle, as faces.
//
// A skin is one patch (skin_patch.hpp) where its weights allow, else one for each of the four
// triangles between the corners and the middles of the edges, and so on: each of them is a
// quadratic family again. Its faces are trimmed by the images of the edges.
#pragma once

#include <string>
#include <vector>

#include "pn/bezier/section_source.hpp"
#include "pn/bezier/skin_patch.hpp"

namespace pn {

class Skin : public SectionSource {
 public:
  /// Delta > 0 on the triangle of the family. Throws GeometryError when no patches with positive
  /// weights are found.
  Skin(const QuadraticFamily& family, Sheet sheet, std::vector<std::string> notes);

  std::array<int, 2> degree() const override;
  /// The same for all lines.
  TrimmableNet net(Lines lines, long precision) const override;
  /// By the corollary of quadratic_family.hpp: inside the true one, and the same for both sheets.
  OffsetRange regular_range() const override;
  bool is_exact() const override { return true; }
  std::vector<std::string> notes() const override { return notes_; }

  const std::vector<SkinPatch>& patches() const { return *patches_; }

 private:
  QuadraticFamily family_;
  std::vector<std::string> notes_;
  std::shared_ptr<const std::vector<SkinPatch>> patches_;  ///< shared with the nets
};

}  // namespace pn
