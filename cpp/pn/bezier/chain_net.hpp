// SPDX-License-Identifier: LGPL-2.1-or-later
// Chain nets: the control points of a chain of envelopes, faces along its segments.
#pragma once

#include <vector>

#include "pn/bezier/parameter_lines.hpp"
#include "pn/bezier/section_net.hpp"
#include "pn/bezier/segment_faces.hpp"

namespace pn {

class ChainNet : public SectionNet {
 public:
  /// Throws Undecided when the precision does not suffice, GeometryError when no positive weights
  /// or admissible degrees are found.
  ChainNet(const EnvelopeChain& chain, Lines lines, long precision);

  const std::vector<LinedSegment>& segments() const { return segments_; }
  /// Face by face.
  const std::vector<ChainPlace>& places() const { return places_; }

 private:
  std::vector<LinedSegment> segments_;
  std::vector<ChainPlace> places_;
};

}  // namespace pn
