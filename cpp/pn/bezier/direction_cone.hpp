// SPDX-License-Identifier: LGPL-2.1-or-later
// Cones of directions: which parts of a surface cannot meet each other.
//
// THEOREM. Let x be Lipschitz on two rectangles of a plane that share a point, with sides parallel
// to the axes, and let x_u and x_v have directions in convex cones U and V. If no direction of U is
// parallel to one of V, then x is injective on their union.
//
// Proof: from p to q there is a path of two segments at most in the union, through a common point
// of the rectangles, along which u and v are monotone: the intervals of u have a common value
// between p_u and q_u, or p_u or q_u is one, and so have those of v. Along it x(q) - x(p) = a X +
// b Y with a = q_u - p_u, b = q_v - p_v and means X of x_u and Y of x_v with positive weights,
// which are in U and V since these are convex. X and Y are linearly independent, so a X + b Y = 0
// only for a = b = 0. QED. For a single rectangle this is the hodograph criterion of T. W.
// Sederberg and R. J. Meyers, Loop detection in surface patch intersections, CAGD 5, 1988.
//
// THEOREM 2 (ibid.). If x_u and x_v are at most alpha and beta from unit vectors a and b with the
// angle gamma, in independent cones, the direction of x_u x x_v is at most theta from a x b, where
//
//     sin^2 theta = (sin^2 alpha + 2 sin alpha sin beta |cos gamma| + sin^2 beta) / sin^2 gamma
//     < 1.
//
// Proof: the unit normal n is orthogonal to x_u, so |n.a| <= sin alpha, and |n.b| <= sin
// beta. Its component in the plane of a and b, with these two products, is as long as sin theta at
// most. For independent cones x_u x x_v is never zero, so that n does not change sides.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace pn {

/// The angle between two vectors, in [0, pi], to all digits also where it is small.
inline double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The angle between two lines or planes, in [0, pi / 2].
inline double unoriented_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

/// All directions at this angle or less from a unit vector; convex up to a right angle.
struct DirectionCone {
  Eigen::Vector3d axis;
  double half_angle;
};

/// A cone that contains both; of half-angle pi, which contains everything, where they are opposite.
inline DirectionCone joined(const DirectionCone& a, const DirectionCone& b) {
  const Eigen::Vector3d sum = a.axis + b.axis;
  const double length = sum.norm();
  if (!(length > 0)) return {a.axis, M_PI};
  const Eigen::Vector3d axis = sum / length;
  return {axis, std::max(angle_between(axis, a.axis) + a.half_angle,
                         angle_between(axis, b.axis) + b.half_angle)};
}

/// Both cones are convex, and no direction of one is parallel to one of the other.
inline bool are_independent(const DirectionCone& a, const DirectionCone& b) {
  const bool are_convex = std::max(a.half_angle, b.half_angle) < M_PI / 2;
  return are_convex && a.half_angle + b.half_angle < unoriented_angle(a.axis, b.axis);
}

/// The cone of theorem 2 around the cross products of directions of both; none where it says
/// nothing.
inline std::optional<DirectionCone> cross_cone(const DirectionCone& a, const DirectionCone& b) {
  if (!are_independent(a, b)) return std::nullopt;
  const Eigen::Vector3d normal = a.axis.cross(b.axis);
  const double p = std::sin(a.half_angle), q = std::sin(b.half_angle);
  const double sine =
      std::sqrt(p * p + 2 * p * q * std::abs(a.axis.dot(b.axis)) + q * q) / normal.norm();
  if (!(sine < 1)) return std::nullopt;
  return DirectionCone{normal.normalized(), std::asin(sine)};
}

}  // namespace pn
