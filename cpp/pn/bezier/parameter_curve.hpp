// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameter curves: splines in the parameter plane of a face that follow a path known exactly.
//
// A path is interpolated by a spline of degree 9 with simple knots at its Greville abscissae; its
// error falls with the tenth power of the span, and spans are halved until it is below a tolerance
// between the abscissae too. (C. de Boor, A Practical Guide to Splines, rev. ed. 2001, chapter
// XIII.) So a smooth path takes few poles, and no derivatives are asked for. The error is measured,
// not proved: it moves the edge of a face, never its surface.
#pragma once

#include <array>
#include <functional>

#include "pn/bezier/bspline_surface.hpp"

namespace pn {

/// A path in a parameter plane over [0, 1].
using ParameterPath = std::function<std::array<double, 2>(double)>;

/// The spline over [0, 1] that follows `path` to within `tolerance` in both coordinates, or as
/// nearly as doubles allow. Its ends are those of the path, bit for bit.
/// Throws GeometryError for a path with a value that is not finite.
ParameterCurve interpolated(const ParameterPath& path, double tolerance);

/// The segment from `start` to `end` over [0, 1].
ParameterCurve straight_line(const std::array<double, 2>& start, const std::array<double, 2>& end);

/// The point at a parameter in [0, 1].
std::array<double, 2> evaluate(const ParameterCurve& curve, double parameter);

}  // namespace pn
