// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter lines: the real factor F(t) that makes A F even, continuous and, where possible, C1.
//
// The joints are LEMMA 1 of line_factor.hpp. LEMMA 2 (weights): with F near G^{-1/2} Rot(theta), G
// = Re(A* A), the weight w4 is nearly constant, so on short segments its Bernstein coefficients are
// positive.
//
// F is a free choice at the right end of every segment, taken in short doubles from the even factor
// of the chain's seam, and determined at the left end by Lemma 1. It is a cubic (value and slope at
// both ends) where a slope is determined, otherwise a quadratic through its values at 0, 1/2 and 1;
// the degree of every section grows by twice the degree of F. A segment whose weights are too
// uneven is halved.
#pragma once

#include <vector>

#include "pn/bezier/section_segment.hpp"

namespace pn {

/// A piece of the envelope with its lines.
struct LinedSegment : SectionSegment {
  Carrier<double> carrier;  ///< nearly; in the segment's own parameter on [0, 1], as `lines`
  SpinorMatrix<std::complex<double>> lines;  ///< A F, nearly
};

/// The segments of the chain in order, computed at this precision. Throws Undecided when it does
/// not suffice, GeometryError when degree 25 leaves no room for the lines.
std::vector<LinedSegment> lined_segments(const EnvelopeChain& chain, Lines lines, long precision);

}  // namespace pn
