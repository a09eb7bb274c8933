// SPDX-License-Identifier: LGPL-2.1-or-later
// Canal surfaces of which only the squared radius is rational.
//
// THEOREM. The envelope of the spheres with centre m(t) and squared radius r^2(t), both rational,
// is a rational surface where r^2 > 0 and |m'|^2 > r'^2, that is 4 r^2 |m'|^2 > ((r^2)')^2; for any
// rational curve in P^4, planes among the spheres included, where its tangents miss the quadric Q
// (characteristic_circle.hpp). Its offsets are rational as well if r is a rational function, and
// not in general. (M. Peternell, dissertation TU Wien 1997, Theorem 2.3.)
//
// Whether r^2 is a square over Q on all spans is decided exactly. If so the surface is an ordinary
// canal surface, of lower degree or the same, with exact offsets.
//
// A conic in P^4, k = 2, gives a surface of order four that passes twice through the absolute
// conic: a Darboux cyclide. Proof: with v(y) the point of Q, <c(t), v(y)> = a + b t + c t^2 has a
// double root, b^2 = 4 a c, at the points of the envelope, and a, b, c are polynomials in |y|^2 and
// y.
//
// Corners of the spine and kinks of r^2 are refused, unless r is rational: the circles of both
// sides must be the same.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "pn/conics/moving_conic.hpp"
#include "pn/minkowski/moebius_model.hpp"
#include "pn/shapes/canal_surface.hpp"

namespace pn {

/// A curve of spheres and planes over [0, 1].
using MoebiusCurve = MoebiusPoint<RationalPolynomial>;

/// With r rational the chain of envelopes of a canal surface; otherwise its circles, span by span.
using CanalSurfaceFromSquares = std::variant<EnvelopeChain, std::vector<ConicSpan>>;

/// squared_radius in mm^2. Throws GeometryError with the parameter interval and the place where the
/// input admits no envelope.
CanalSurfaceFromSquares moebius_canal_surface(const Curve& spine, const Law& squared_radius);
CanalSurfaceFromSquares moebius_canal_surface(const MoebiusCurve& curve);

}  // namespace pn
