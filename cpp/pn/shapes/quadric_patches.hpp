// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrics as rational patches over Q: graphs and stereographic projections.
//
//     paraboloids             z as a polynomial in x and y
//     two-sheet hyperboloid   (2 a p, 2 b q, c (1 + r)) / (1 - r),  r = p^2 + q^2
//     ellipsoid               (2 a p, 2 b q, +-c (1 - r)) / (1 + r), r <= 1
//
// They cover the region of a quadric inside its bounds, which become polynomials of the patch. On
// them the limits of offsets are certified.
#pragma once

#include "pn/isotropic/rational_patch.hpp"
#include "pn/isotropic/sphere_curve.hpp"
#include "pn/shapes/quadric_region.hpp"

namespace pn {

using HalfAxes = std::array<Rational, 3>;

std::vector<RationalPatch> ellipsoid_patches(const HalfAxes& half, const QuadricBounds& bounds);

/// For |x| <= widths[0], |y| <= widths[1].
std::vector<RationalPatch> two_sheet_hyperboloid_patches(const HalfAxes& half,
                                                         const QuadricBounds& bounds,
                                                         const std::array<double, 2>& widths);

/// z = c (x^2/a^2 + sign y^2/b^2) for |x| <= widths[0], |y| <= widths[1]; the normal is on this
/// side of x_x cross x_y.
std::vector<RationalPatch> paraboloid_patches(const HalfAxes& half, int sign, int side,
                                              const QuadricBounds& bounds,
                                              const std::array<double, 2>& widths);

/// The cone of revolution x^2/a^2 + y^2/a^2 = z^2/c^2 between two heights of one sign.
std::vector<RationalPatch> cone_patches(const HalfAxes& half, const Interval& heights);

/// The rulings from one curve to another, with the normal on the side of x_t x x_v.
RationalPatch ruled_patch(const SphereCurve& first, const SphereCurve& second);

/// The patch where the bounds hold; of a sector, what half-planes say: nothing beyond a half turn.
RationalPatch bounded(RationalPatch patch, const QuadricBounds& bounds);

}  // namespace pn
