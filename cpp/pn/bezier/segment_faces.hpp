// SPDX-License-Identifier: LGPL-2.1-or-later
// Segment faces: the control points of section segments.
//
// Between its joints a chain of segments becomes faces: C1 splines along it, and around it the
// columns of a circle or of an arc (circle_parameter.hpp). Arcs are divided until all weights are
// positive. Neighbours share their circles, bit for bit.
#pragma once

#include <cstddef>
#include <vector>

#include "pn/bezier/section_net.hpp"
#include "pn/bezier/section_segment.hpp"

namespace pn {

/// Where a face of a net lies on the chain.
struct ChainPlace {
  int arcs;  ///< of the whole circle, of which the face has a part; 0 for an arc of the circle that
             ///< is a band u = (1 - s : s)
  std::size_t first_segment, last_segment;  ///< it lies over the segments [first, last)
};

struct SegmentFace : FaceNet {
  ChainPlace place;
};

/// Into how many spans a segment may be cut along until all weights are positive; into more than
/// one only where every segment is a face of its own.
enum class SpansAlong { kOne, kMany };

struct SegmentChain {
  std::vector<const SectionSegment*> segments;
  bool closed;  ///< the last one ends where the first begins
  SpansAlong spans;
};

/// The faces with the fewest poles whose weights are positive. Throws Undecided when the precision
/// does not suffice, GeometryError (kWeightsNotPositive) when there are none.
std::vector<SegmentFace> segment_faces(const SegmentChain& chain, Lines lines, long precision);

}  // namespace pn
