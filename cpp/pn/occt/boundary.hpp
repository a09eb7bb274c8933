// SPDX-License-Identifier: LGPL-2.1-or-later
// The boundary curves of a B-spline surface, and when two of them are one edge.
//
// Faces that meet carry the same poles along their common edge, so that neighbours are found by
// comparing numbers, without a sewing tolerance. Weights may differ by a common factor and knots by
// an affine map: both leave the curve as it is.
#pragma once

#include <array>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"

namespace pn {

/// A clamped rational B-spline curve in space; the conventions are those of BSplineSurface.
struct BoundaryCurve {
  int degree = 0;
  std::vector<double> knots;
  std::vector<int> multiplicities;
  std::vector<std::array<double, 3>> poles;
  std::vector<double> weights;
};

/// The same points in the other direction, over the same interval.
BoundaryCurve reversed(BoundaryCurve curve);

/// True when all poles are the same point.
bool is_degenerate(const BoundaryCurve& curve);

/// True when both curves pass through the same points in the same direction, their parameters
/// differing by an affine map: equal degree, multiplicities and poles (bit for bit), knots and
/// weights equal as far as doubles can tell up to an affine map and a factor.
bool coincide(const BoundaryCurve& a, const BoundaryCurve& b);

/// One of the four sides of a surface: its curve, in the direction of rising parameter, and where
/// the curve starts and ends in the (u, v) plane.
struct Boundary {
  BoundaryCurve curve;
  std::array<double, 2> start;
  std::array<double, 2> end;
};

/// The sides v = first, u = last, v = last, u = first: counterclockwise in the (u, v) plane if the
/// last two are run against the direction of their curves.
std::array<Boundary, 4> boundaries(const BSplineSurface& surface);

}  // namespace pn
