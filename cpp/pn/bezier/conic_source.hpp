// SPDX-License-Identifier: LGPL-2.1-or-later
// Conic source: the surface of a moving conic as a source of sections.
//
// Its points are those of conic_points.hpp, its lines those of conic_lines.hpp. Unit normals are
// not rational in general, so there are no sections but the one at distance zero. The ends of arcs
// are edges of trimmed faces (band_trims.hpp).
#pragma once

#include <string>
#include <vector>

#include "pn/bezier/conic_lines.hpp"
#include "pn/bezier/section_source.hpp"
#include "pn/conics/moving_conic.hpp"

namespace pn {

class ConicSource : public SectionSource {
 public:
  /// Spans along t, each over [0, 1], each beginning with the conic with which the one before ends.
  /// Span number i is the surface over [i, i + 1]; it is closed when the last conic is the first.
  /// Frames of conics without a cut may be flat at single t.
  ///
  /// Throws GeometryError: kSingularConics, kNoRealPoints, kGap where spans do not meet,
  /// kRegionUnbounded where a conic or its part has points at infinity, kRegionEmpty where a cut
  /// does not meet its conic in two points, kDegreeTooHigh.
  explicit ConicSource(const std::vector<ConicSpan>& spans, std::vector<std::string> notes = {});

  std::array<int, 2> degree() const override;
  TrimmableNet net(Lines lines, long precision) const override;
  bool has_offsets() const override { return false; }
  OffsetRange regular_range() const override { return {0, 0, {}, {}}; }
  bool is_exact() const override { return true; }
  std::vector<std::string> notes() const override { return notes_; }

 private:
  ConicChain chain_;
  std::vector<std::string> notes_;
};

}  // namespace pn
