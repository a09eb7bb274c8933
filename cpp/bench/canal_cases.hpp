// SPDX-License-Identifier: LGPL-2.1-or-later
// The canal surfaces that are measured, in millimetres.
#pragma once

#include <array>
#include <vector>

#include "pn/bezier/pn_surface.hpp"
#include "pn/shapes/curve.hpp"

namespace pn::bench {

/// A Bezier spine with a Bezier radius law, both over [0, 1].
struct BezierCanal {
  std::vector<std::array<double, 3>> spine;
  std::vector<double> radius;
};

/// Case C1: a cubic spine, bent in space, with the radius 2. Its least radius of curvature is 6.09.
BezierCanal pipe();

/// Case C2: the same spine with a cubic radius that narrows to 1.92 and flares to 2.5;
/// max |r'| / |m'| = 0.0707.
BezierCanal horn();

/// Spine and radius of this degree: a quarter of a helix that narrows and flares. The radius
/// changes so slowly that D has no real root, and the degrees of the surface are the least
/// possible.
BezierCanal helical_horn(int degree);

/// A cubic B-spline spine of so many spans, a wavy helix, and a cubic B-spline radius over the same
/// knots; both C2.
struct SplineCanal {
  BSplineData<3> spine;
  BSplineData<1> radius;
};
SplineCanal spring(int spans);

/// From the numbers to a surface whose poles are still to be asked for.
PNSurface surface_of(const BezierCanal& canal);
PNSurface surface_of(const SplineCanal& canal);

}  // namespace pn::bench
