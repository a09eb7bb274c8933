// SPDX-License-Identifier: LGPL-2.1-or-later
// Conic lines: the factor F(t) that makes the lines of moving conics even and continuous.
//
// u -> F(t) u changes nothing but the lines u = const. F is constant or linear on each segment: at
// its right end a free choice, in short doubles from the seam of the surface (conic_seam.hpp); at
// its left end Z'^{-1} M Z F of the segment before (conic_parameter.hpp), with which the lines run
// on and the weights agree. The degree grows by twice that of F. A segment whose weights are too
// uneven is halved, and so is one of arcs that leave the band u = (1 - s : s): the ends of arcs are
// in general no rational curves, and a margin leaves them inside. Where [c, c] is a constant times
// a square they are rational; if they are linear in the family's u too, they are lines of F, and
// the band is the surface: what the forms leave of q_c there is zero to the working precision.
#pragma once

#include <memory>
#include <vector>

#include "pn/bezier/conic_points.hpp"
#include "pn/bezier/section_segment.hpp"

namespace pn {

/// Moving ellipses, or arcs of moving conics, each span over an interval [i, i + 1] of the
/// surface's parameter.
struct ConicChain {
  std::vector<std::shared_ptr<const ConicPoints>> spans;
  bool closed;  ///< the last conic is the first

  bool has_cuts() const { return spans.front()->has_cut(); }
};

struct ConicSegment : SectionSegment {
  /// Of arcs whose ends are inside the band, nearly: positive on them. Without coefficients where
  /// the band is the surface.
  FormInU<double> cut;
};

/// The segments of the spans in order, computed at this precision. Throws Undecided when it does
/// not suffice, GeometryError when degree 25 leaves no room for the lines, or when none hold the
/// arcs.
std::vector<ConicSegment> lined_segments(const ConicChain& chain, Lines lines, long precision);

}  // namespace pn
