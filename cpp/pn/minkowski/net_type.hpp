// SPDX-License-Identifier: LGPL-2.1-or-later
// The thirteen types of nets at infinity: kind of the net, and position of its axes to Omega.
//
// THEOREM. On the pencil a + k b of complexes of a net let K(c) = [c, c] and O(c) = [c, polar c],
// two quadratic forms. The roots of K are the axes: real for a hyperbolic, conjugate complex for an
// elliptic, one double root for a parabolic net; the net is singular when K vanishes. An axis
// misses Omega (P, passant), touches it (T) or meets it (S, secant) as O is positive, zero or
// negative there. For a parabolic net with a tangent axis a: the net's lines through the point of
// contact are tangents of Omega (T a) when O(a, b) = 0, else not (T b).
//
// Proof of the last: polar a goes through the point of contact p, in the tangent plane of p, and is
// not a. The lines of the net through p fill the pencil in the null plane of p, which contains a.
// It is the tangent plane exactly when polar a belongs to the net too: [a, polar a] = 0 holds, and
// [b, polar a] = O(a, b). QED
//
// In one type the axes are a secant and a passant that are polar: the polarity maps the pencil to
// itself. (D. Gruber, Diplomarbeit, TU Wien 2008, 3.3-3.5.) Everything is decided over Q, also when
// the axes are irrational: the sign of O at the two roots of K follows from its sum and product.
#pragma once

#include <string>
#include <vector>

#include "pn/minkowski/line_congruence.hpp"

namespace pn {

enum class NetKind { kHyperbolic, kElliptic, kParabolic, kSingular };
enum class AxisPosition { kPassant, kSecant, kTangent };

struct NetType {
  NetKind kind;
  /// Two, one of a parabolic net, none of a singular net; in the order secant, passant, tangent. Of
  /// an elliptic net secants, which are conjugate complex, or tangents.
  std::vector<AxisPosition> axes;
  /// Secant and passant are polar.
  bool polar_axes = false;
  /// The net's lines through the point of contact of a parabolic tangent axis are tangents.
  bool tangent_pencil = false;
};

/// Throws std::domain_error when the complexes are dependent.
NetType net_type(const LineNet& net);

/// As "hyperbolic S/P polar", "elliptic T/T", "parabolic T a", "singular".
std::string name(const NetType& type);

}  // namespace pn
