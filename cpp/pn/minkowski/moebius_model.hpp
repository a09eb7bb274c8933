// SPDX-License-Identifier: LGPL-2.1-or-later
// The quadric model of Moebius geometry: points, spheres and planes of space are points of P^4.
//
// With <x, y> = -x0 y0 + x1 y1 + x2 y2 + x3 y3 + x4 y4 let Q be the quadric <x, x> = 0 and N = (1,
// 0, 0, 0, 1) on it. The point y of space is the point (|y|^2 + 1, 2 y, |y|^2 - 1) of Q, its image
// under the stereographic projection from N. The transfer map mu takes a point p outside Q to all y
// in its polar hyperplane, <p, y> = 0:
//
//     (p0 - p4) |y|^2 - 2 (p1, p2, p3).y + p0 + p4 = 0.
//
// This is the sphere with centre (p1, p2, p3) / (p0 - p4) and squared radius <p, p> / (p0 - p4)^2;
// or, for p0 = p4, the plane (p1, p2, p3).y = p0. Inside Q the squared radius is negative. (M.
// Peternell, dissertation TU Wien 1997, section 2.4, (2.12), (2.13).)
//
// ORTHOGONALITY. Two spheres or planes meet at right angles exactly when <p, q> = 0: for spheres
// this is |m - m'|^2 = r^2 + r'^2. Moebius transformations are the collineations that keep Q; the
// one that keeps z and all points of its polar hyperplane is the inversion at mu(z).
//
// PENCILS. The form <, > has signature (4, 1). So on the line that joins p and q it is definite,
// degenerate or indefinite as the Gram determinant <p, p> <q, q> - <p, q>^2 is positive, zero or
// negative. The line then misses, touches or crosses Q: its spheres share a circle; touch in a
// point; have no common point and include two points as spheres of radius zero.
//
// T is a field for points of P^4 that are divided, and a ring, such as Q[t], otherwise.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "pn/algebra/rational.hpp"

namespace pn {

/// x0, ..., x4, homogeneous.
template <class T>
using MoebiusPoint = std::array<T, 5>;

/// <x, y>
template <class T>
T moebius_product(const MoebiusPoint<T>& x, const MoebiusPoint<T>& y) {
  return x[1] * y[1] + x[2] * y[2] + x[3] * y[3] + x[4] * y[4] - x[0] * y[0];
}

/// leading |y|^2 - 2 linear.y + constant = 0: a sphere, or with leading = 0 a plane.
template <class T>
struct SphereEquation {
  T leading;
  std::array<T, 3> linear;
  T constant;
};

template <class T>
SphereEquation<T> sphere_equation(const MoebiusPoint<T>& p) {
  return {p[0] - p[4], {p[1], p[2], p[3]}, p[0] + p[4]};
}

template <class T>
MoebiusPoint<T> moebius_point(const SphereEquation<T>& sphere) {
  const auto& [w, q, z] = sphere;
  return {z + w, q[0] + q[0], q[1] + q[1], q[2] + q[2], z - w};
}

/// The point of Q that is a point of space.
template <class T>
MoebiusPoint<T> moebius_point(const std::array<T, 3>& y) {
  return moebius_point(SphereEquation<T>{T(1L), y, y[0] * y[0] + y[1] * y[1] + y[2] * y[2]});
}

/// A sphere; its squared radius is negative for points inside Q, and zero on Q.
template <class T>
struct UnorientedSphere {
  std::array<T, 3> centre;
  T squared_radius;
};

template <class T>
MoebiusPoint<T> moebius_point(const UnorientedSphere<T>& sphere) {
  const auto& m = sphere.centre;
  return moebius_point(
      SphereEquation<T>{T(1L), m, m[0] * m[0] + m[1] * m[1] + m[2] * m[2] - sphere.squared_radius});
}

/// mu; nothing for a plane and for N.
template <class T>
std::optional<UnorientedSphere<T>> sphere_of(const MoebiusPoint<T>& p) {
  const T w = p[0] - p[4];
  if (w == T(0L)) return std::nullopt;
  return UnorientedSphere<T>{{p[1] / w, p[2] / w, p[3] / w}, moebius_product(p, p) / (w * w)};
}

enum class PencilKind {
  kThroughCircle,  ///< through a circle, or planes through a line
  kTouching,       ///< touching in a point, or parallel planes
  kWithPoints      ///< with two spheres of radius zero, and no common point
};

/// <p, p> <q, q> - <p, q>^2
template <class T>
T gram_determinant(const MoebiusPoint<T>& p, const MoebiusPoint<T>& q) {
  const T product = moebius_product(p, q);
  return moebius_product(p, p) * moebius_product(q, q) - product * product;
}

/// Of the line that joins two points.
inline PencilKind pencil_kind(const MoebiusPoint<Rational>& p, const MoebiusPoint<Rational>& q) {
  const int sign = gram_determinant(p, q).sign();
  if (sign == 0) return PencilKind::kTouching;
  return sign > 0 ? PencilKind::kThroughCircle : PencilKind::kWithPoints;
}

/// The image of x under the inversion at the sphere, or the reflection in the plane, mu(z); z is
/// not on Q.
template <class T>
MoebiusPoint<T> inverted(const MoebiusPoint<T>& x, const MoebiusPoint<T>& z) {
  const T square = moebius_product(z, z), product = moebius_product(x, z);
  MoebiusPoint<T> image;
  for (std::size_t i = 0; i < image.size(); ++i) {
    image[i] = square * x[i] - (product + product) * z[i];
  }
  return image;
}

}  // namespace pn
