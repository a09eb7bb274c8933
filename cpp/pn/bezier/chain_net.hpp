// SPDX-License-Identifier: LGPL-2.1-or-later
// Chain nets: the control points of a chain of envelopes.
//
// Between its joints a chain becomes faces: C1 splines along it, and around it the columns of a
// circle or of an arc (circle_parameter.hpp). Arcs are divided until all weights are positive.
// Neighbours share their circles, bit for bit.
#pragma once

#include <vector>

#include "pn/bezier/parameter_lines.hpp"
#include "pn/bezier/section_net.hpp"

namespace pn {

/// Where a face of the net lies on the chain.
struct ChainPlace {
  int arcs;  ///< of the whole circle, of which the face has a part; 0 for an arc of the circle that
             ///< is a band u = (1 - s : s)
  std::size_t first_segment, last_segment;  ///< it lies over the segments [first, last)
};

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
