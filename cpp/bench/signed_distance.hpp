// SPDX-License-Identifier: LGPL-2.1-or-later
// How far points lie from the true surfaces, in long double, by routes that share nothing with the
// library: a foot point on the moving sphere, on the rulings, on the implicit quadric.
#pragma once

#include <functional>

#include "canal_cases.hpp"
#include "offset_cases.hpp"
#include "surface_point.hpp"

namespace pn::bench {

/// The distance [mm] of a point near a surface, positive on the side that the library offsets to
/// with positive distances.
using SignedDistance = std::function<long double(const Point&)>;

/// The least value of |p - m(t)| - r(t).
///
/// The canal surface is taken beyond its ends: a surface that stops short of them or passes them is
/// not blamed for that.
SignedDistance distance_from(const BezierCanal& canal);

/// The distance to the nearest of the lines that join a(t) and b(t), positive on the side of
/// S_t x (b - a). Rulings and directrices are taken beyond their ends.
SignedDistance distance_from(const BezierRuled& ruled);

/// With F = 0 the whole quadric and grad F pointing to the positive side: lambda |grad F(f)|, where
/// p = f + lambda grad F(f) and F(f) = 0. In principal axes f is explicit in lambda, so this is one
/// equation. Throws std::runtime_error when no foot point is found.
SignedDistance distance_from(const QuadricCase& quadric);

SignedDistance distance_from(const OffsetBase& base);

}  // namespace pn::bench
