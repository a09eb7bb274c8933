// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact patches: Bezier patches of sections, with what bounds them, and surfaces made of them.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pn/bezier/section_source.hpp"
#include "pn/isotropic/along_surface.hpp"

namespace pn {

struct ExactPatch {
  std::array<int, 2> degree;
  /// Its sections over [0, 1]^2, enclosed at this precision [bits].
  std::function<SurfaceSections<RealBall>(long)> sections;
  /// Pieces of one loop in [0, 1]^2, the patch on its left; none: the whole square.
  std::vector<ParameterPath> boundary;
};

/// The part of a path between two of its parameters, over [0, 1].
ParameterPath part_of(const ParameterPath& path, double from, double to);

/// A surface of exact patches, each a face. The first parameter of face number i runs over [i, i +
/// 1], the second over [0, 1].
class PatchSource : public SectionSource {
 public:
  std::array<int, 2> degree() const override;
  /// The same for all lines.
  TrimmableNet net(Lines lines, long precision) const override;
  bool is_exact() const override { return true; }
  std::vector<std::string> notes() const override { return notes_; }

  const std::vector<ExactPatch>& patches() const { return *patches_; }

 protected:
  PatchSource(std::vector<ExactPatch> patches, std::vector<std::string> notes);

 private:
  std::shared_ptr<const std::vector<ExactPatch>> patches_;  ///< shared with the nets
  std::vector<std::string> notes_;
};

}  // namespace pn
