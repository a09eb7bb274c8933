// SPDX-License-Identifier: LGPL-2.1-or-later
// How far a surface lies from the true envelope, measured by a route of its own.
#pragma once

#include "canal_cases.hpp"
#include "pn/bezier/bspline_surface.hpp"

namespace pn::bench {

/// The largest distance [mm] of points on `surface` to the canal surface, on a grid.
///
/// Next to the envelope, the signed distance of a point p to it is the least value of
/// |p - m(t)| - r(t). The canal surface is taken beyond its ends: a surface that stops short of
/// them or passes them is not blamed for that.
double deviation_from_envelope(const BSplineSurface& surface, const BezierCanal& canal);

}  // namespace pn::bench
