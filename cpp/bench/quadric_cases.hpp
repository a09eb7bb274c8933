// SPDX-License-Identifier: LGPL-2.1-or-later
// The quadrics whose offsets are measured, in millimetres.
#pragma once

#include "pn/shapes/quadric.hpp"

namespace pn::bench {

/// A quadric in standard position, and the bounds of the part that is wanted.
struct QuadricCase {
  QuadricKind kind;
  std::array<double, 3> half_axes;
  QuadricBounds bounds;
};

/// Cases Q1p and Q1m: all of the ellipsoid with the half-axes 3, 2, 1.
QuadricCase ellipsoid();

/// Case Q2: z = x^2/8 + y^2/2 over |x| <= 2, |y| <= 1. Its least radius of curvature is 1.
QuadricCase paraboloid();

/// The patch of Q3 in stereographic parameters reaches so far.
inline constexpr double kStereographicReach = 0.4;

/// Case Q3: the sheet z > 0 of z^2/4 - x^2/9 - y^2 = 1, cut by planes x, y = const that pass
/// through the middles of the sides of a square stereographic patch.
QuadricCase two_sheet_hyperboloid();

/// Case Q4: x^2/4 + y^2 - z^2/4 = 1 from z = -2 to z = 2, all the way around.
QuadricCase one_sheet_hyperboloid();

EnvelopeChain chain_of(const QuadricCase& quadric);

}  // namespace pn::bench
