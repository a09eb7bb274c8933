// SPDX-License-Identifier: LGPL-2.1-or-later
// Conic lines: the factor F(t) that makes the lines of moving ellipses even and continuous.
//
// u -> F(t) u changes nothing but the lines u = const. F is constant or linear on each segment: at
// its right end a free choice, in short doubles from the seam of the surface (conic_seam.hpp); at
// its left end Z'^{-1} M Z F of the segment before (ellipse_parameter.hpp), with which the lines
// run on and the weights agree. The degree grows by twice that of F. A segment whose weights are
// too uneven is halved.
#pragma once

#include <memory>
#include <vector>

#include "pn/bezier/conic_points.hpp"
#include "pn/bezier/section_segment.hpp"

namespace pn {

/// Moving ellipses, each span over an interval [i, i + 1] of the surface's parameter.
struct EllipseChain {
  std::vector<std::shared_ptr<const ConicPoints>> spans;
  bool closed;  ///< the last ellipse is the first
};

/// The segments of the spans in order, computed at this precision. Throws Undecided when it does
/// not suffice, GeometryError when degree 25 leaves no room for the lines.
std::vector<SectionSegment> lined_segments(const EllipseChain& chain, Lines lines, long precision);

}  // namespace pn
