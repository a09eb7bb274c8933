// SPDX-License-Identifier: LGPL-2.1-or-later
// Models of Laguerre geometry in which oriented planes are points: the Blaschke cylinder, the
// isotropic model and its dual.
//
// Let e0 + n.x = 0, |n| = 1, be an oriented plane; in R^{3,1} it is <w, x> = c with w = (n, 1) and
// c = -e0.
//
//   Blaschke cylinder    (n1, n2, n3, e0) on x1^2 + x2^2 + x3^2 = 1. The planes that touch a sphere
//                        are its section with e0 + n.m + r = 0.
//   isotropic model      y = (n1, n2, e0) / (1 - n3), the stereographic projection of the cylinder.
//                        A sphere becomes an isotropic sphere, the graph of
//                            y3 = -((r + m3) (y1^2 + y2^2) + 2 m1 y1 + 2 m2 y2 + r - m3) / 2.
//                        Planes with the normal (0, 0, 1) have no image.
//   dual isotropic model (e0 : n1 : n2 : n3 - 1), the plane that bisects the given one and x3 = 0.
//
// All maps are rational both ways, so surfaces with rational normals are the images of rational
// surfaces: every rational graph or plane family gives one. (M. Peternell, dissertation, TU Wien
// 1997, (3.10)-(3.17).)
//
// T is a field: Rational, rational functions.
#pragma once

#include "pn/minkowski/sphere.hpp"

namespace pn {

template <class T>
std::array<T, 4> blaschke_point(const OrientedPlane<T>& plane) {
  const MinkowskiVector<T>& w = plane.w;
  return {w[0] / w[3], w[1] / w[3], w[2] / w[3], -plane.c / w[3]};
}

/// Of a point on the cylinder.
template <class T>
OrientedPlane<T> plane_of_blaschke_point(const std::array<T, 4>& x) {
  return {{x[0], x[1], x[2], T(1L)}, -x[3]};
}

template <class T>
std::array<T, 3> isotropic_point(const OrientedPlane<T>& plane) {
  const MinkowskiVector<T>& w = plane.w;
  const T denominator = w[3] - w[2];
  return {w[0] / denominator, w[1] / denominator, -plane.c / denominator};
}

template <class T>
OrientedPlane<T> plane_of_isotropic_point(const std::array<T, 3>& y) {
  const T square = y[0] * y[0] + y[1] * y[1], one(1L), two(2L);
  return {{two * y[0], two * y[1], square - one, square + one}, -two * y[2]};
}

/// y3 = a (y1^2 + y2^2) + b1 y1 + b2 y2 + c
struct IsotropicSphere {
  Rational a, b1, b2, c;

  Rational operator()(const Rational& y1, const Rational& y2) const {
    return a * (y1 * y1 + y2 * y2) + b1 * y1 + b2 * y2 + c;
  }
};

inline IsotropicSphere isotropic_sphere(const Sphere& sphere) {
  const auto& [m, r] = sphere;
  const Rational half = Rational(1L) / Rational(2L);
  return {-half * (r + m[2]), -m[0], -m[1], half * (m[2] - r)};
}

inline Sphere sphere_of(const IsotropicSphere& s) {
  return {{-s.b1, -s.b2, s.c - s.a}, -s.a - s.c};
}

/// y0 + y1 x1 + y2 x2 + y3 x3 = 0; all but y0 are zero for the plane x3 = 0 and those parallel to
/// it.
template <class T>
std::array<T, 4> dual_isotropic_plane(const OrientedPlane<T>& plane) {
  const MinkowskiVector<T>& w = plane.w;
  return {-plane.c, w[0], w[1], w[2] - w[3]};
}

/// Of a plane with y3 != 0: its reflection of the plane x3 = 0, oriented.
template <class T>
OrientedPlane<T> plane_of_dual_isotropic_plane(const std::array<T, 4>& y) {
  const T square = y[1] * y[1] + y[2] * y[2], twice = T(2L) * y[3];
  return {{y[1], y[2], (y[3] * y[3] - square) / twice, -(y[3] * y[3] + square) / twice}, -y[0]};
}

}  // namespace pn
