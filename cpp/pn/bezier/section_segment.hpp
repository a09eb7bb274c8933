// SPDX-License-Identifier: LGPL-2.1-or-later
// Section segments: pieces of a surface, one after the other, as forms in u = (u0 : u1) and t.
//
// Whatever gives the forms, an isotropic hypersurface or a family of conics, and whoever chose the
// lines u = const, from here on there is one way: faces along the segments and around them
// (segment_faces.hpp).
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

/// The Bernstein coefficients of a form in t on [0, 1] and the columns around.
struct WeightRange {
  double least, largest;
};
WeightRange weight_range(const FormInU<double>& form, const std::vector<CircleColumns>& circle);

/// Weights that vary by more than this within a surface are evened out by halving segments: twice
/// the ratio 0.01 that the exported faces keep.
inline constexpr double kLeastWeightRatio = 0.02;
/// A segment is halved at most so often; then positive weights are taken as they are.
inline constexpr int kMostSegmentHalvings = 10;

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

/// Over the interval [begin, end] of the designer's parameter; of [0, 1] in a zone of a sphere,
/// where the spine stands still.
struct SectionSegment {
  bool stands_still;
  double begin, end;
  Joint joint_before;
  Around around;
  /// In the segment's own parameter on [0, 1]; without directions where there are no other sections
  /// than that at distance zero.
  HomogeneousSections<RealBall> sections;
};

}  // namespace pn
