// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/chain_net.hpp"

namespace pn {
namespace {

SegmentChain segment_chain(const EnvelopeChain& chain, const std::vector<LinedSegment>& segments) {
  // Only the faces over regions are cut along, each being a segment.
  const bool is_region = std::holds_alternative<BoundedRegion>(chain.extent);
  SegmentChain result{{}, chain.closed, is_region ? SpansAlong::kMany : SpansAlong::kOne};
  for (const LinedSegment& segment : segments) result.segments.push_back(&segment);
  return result;
}

}  // namespace

ChainNet::ChainNet(const EnvelopeChain& chain, Lines lines, long precision)
    : SectionNet({}, precision), segments_(lined_segments(chain, lines, precision)) {
  for (SegmentFace& face : segment_faces(segment_chain(chain, segments_), lines, precision)) {
    places_.push_back(face.place);
    faces_.push_back(std::move(face));
  }
}

}  // namespace pn
