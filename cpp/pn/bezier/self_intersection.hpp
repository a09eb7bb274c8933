// SPDX-License-Identifier: LGPL-2.1-or-later
// Self-intersection: where a section crosses itself, however far apart along the surface.
//
// A section is the image of its faces, glued along their edges, that has a rational unit normal
// everywhere, also where it is singular; that of other surfaces is the one of their derivatives,
// where these are independent. So the planes of two sheets that cross are known, and
//
//     the section crosses itself at x(p) = x(q) when p and q are different points and the angle of
//     the tangent planes there is not zero.
//
// What is one point with several parameters has one normal: seams, shared edges, the poles of
// quadrics, the ends of the axis of a zone. Only a circle that shrinks to the tip of a cone has
// many normals in one point; where the surface ends there it is left out, where it goes on it
// crosses.
//
// METHOD. Pairs of pieces of the surface are halved until one of these is certain:
//
//   - their convex hulls are disjoint;
//   - they touch in the parameter plane, and their tangent cones show that the surface is injective
//     on their union (direction_cone.hpp);
//   - all their tangent planes are nearly parallel, by kLeastCrossing and kLeastFold
//     (normal_patch.hpp);
//   - Newton's method finds a point of both: this is the crossing, confirmed.
//
// No pair is given up before a side of a piece is shorter than kResolution of the surface, or too
// many pairs of two knot rectangles were looked at. The search ends early where hundreds of knot
// rectangles were found to cross.
//
// The parts beside a corner of a spine always overlap on its inner side, and the chain says so in
// its notes. Crossings of them in the ball around the corner that holds this overlap do not count:
// for straight pipes of radius r and a turn by the angle a it ends at r / cos(a / 2), where the
// ball is taken somewhat larger.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"

namespace pn {

/// Sheets that cross at a smaller angle [rad] count as touching. Two pipes of radius r whose axes
/// are 2 r - h apart cross at about 2 sqrt(h / r): they may overlap by 6e-5 r.
inline constexpr double kLeastCrossing = 1.0 / 64;
/// The same of sheets that face the same side there, as beside a fold of an offset that is just
/// beyond its regular range: it is found when the distance is 0.8 % too large.
inline constexpr double kLeastFold = 1.0 / 4;
/// Pieces narrower than this part of the surface are not divided any further. Differences of their
/// poles still have ten digits, and a tube of that width could not be made.
inline constexpr double kResolution = 0x1p-18;

/// A face of a section.
struct SectionFace {
  const BSplineSurface* surface;
  /// Over the same knots, with the same weights; null where unit normals are not rational.
  const BSplineSurface* normal;
  bool stands_still;  ///< a zone of a sphere at a corner, between its neighbours in order
};

struct FacePoint {
  std::size_t face;
  double u, v;
};

struct SelfIntersection {
  std::array<double, 3> point;      ///< [mm]
  std::array<FacePoint, 2> places;  ///< both parameters of it
  double angle;                     ///< of the tangent planes, at most a right angle
};

/// A crossing of a section with itself, if there is one: of those that are found the one at the
/// widest angle, which is where two parts are deepest in each other, nearly.
std::optional<SelfIntersection> self_intersection(const std::vector<SectionFace>& faces);

}  // namespace pn
