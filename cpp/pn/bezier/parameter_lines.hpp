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

#include "pn/bezier/circle_parameter.hpp"
#include "pn/isotropic/envelope_chain.hpp"

namespace pn {

enum class Lines {
  kEven,          ///< smooth faces, even lines
  kLowestDegree,  ///< F constant where weights allow it: the algebra's degree, a face for every arc
};

/// Arcs around the circle: the least number, doubled up to the most until all weights are positive.
/// With four, the weights of an even circle vary by a factor of 1.02.
inline constexpr int kLeastArcs = 4;
inline constexpr int kMostArcs = 32;

/// The faces around the circle, over [0, 4]: a closed one of so many arcs for even lines, one for
/// every arc for lowest degree. `arcs` is 4 times a power of two; the forms have this degree in u.
std::vector<CircleColumns> circle_columns(Lines lines, int arcs, int form_degree);

/// What of each circle the faces over a segment take.
enum class Around {
  kCircle,        ///< all of it, by a closed face
  kHalves,        ///< all of it, by two faces
  kUnequalParts,  ///< all of it, by a face of three arcs of four and one of the fourth
  kLargerPart,    ///< the three arcs
  kArc,           ///< the arc u = (1 - s : s)
};

/// The larger of two unequal parts of the circle, of the least number of arcs.
inline constexpr int kArcsOfLargerPart = 3;

/// A piece of the envelope with its lines, over the interval [begin, end] of the designer's
/// parameter; of [0, 1] in a zone of a sphere, where the spine stands still.
struct LinedSegment {
  bool stands_still;
  double begin, end;
  Joint joint_before;
  Around around;
  Carrier<double>
      carrier;  ///< nearly; in the segment's own parameter on [0, 1], as all that follow
  HomogeneousSections<RealBall> sections;
  SpinorMatrix<std::complex<double>> lines;  ///< A F, nearly
};

/// The segments of the chain in order, computed at this precision. Throws Undecided when it does
/// not suffice, GeometryError when degree 25 leaves no room for the lines.
std::vector<LinedSegment> lined_segments(const EnvelopeChain& chain, Lines lines, long precision);

}  // namespace pn
