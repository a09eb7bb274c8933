// SPDX-License-Identifier: LGPL-2.1-or-later
// The cyclographic model: oriented spheres are points of R^{3,1}, oriented planes its isotropic
// hyperplanes.
//
// The sphere with centre m and signed radius r is the point (m, -r). Its normals point outwards
// when r > 0. The plane n.x = h, |n| = 1, is the hyperplane <w, x> = c with w = w4 (n, 1) isotropic
// and c = w4 h; it touches the spheres in it, each in m + r n. THEOREM. Two spheres are in oriented
// contact, that is, touch in a point with the same normal, exactly when their points a, b are
// joined by an isotropic line:
//
//     <a - b, a - b> = 0.
//
// Proof: contact is m + r n = m' + r' n, so |m - m'| = |r - r'|; conversely m' - m = (r - r') n
// gives n when r != r', and the spheres are the same when r = r'. QED (M. Peternell, dissertation,
// TU Wien 1997, sections 3.2 and 3.7.)
#pragma once

#include "pn/minkowski/minkowski_vector.hpp"

namespace pn {

struct Sphere {
  std::array<Rational, 3> centre;
  Rational radius;  ///< signed; zero is a point
};

inline MinkowskiVector<Rational> point_of(const Sphere& sphere) {
  return {sphere.centre[0], sphere.centre[1], sphere.centre[2], -sphere.radius};
}

inline Sphere sphere_of(const MinkowskiVector<Rational>& point) {
  return {{point[0], point[1], point[2]}, -point[3]};
}

/// <w, x> = c with w isotropic and w4 != 0; with k != 0, (k w, k c) is the same plane.
template <class T>
struct OrientedPlane {
  MinkowskiVector<T> w;
  T c;
};

inline bool in_contact(const Sphere& a, const Sphere& b) {
  const MinkowskiVector<Rational> join = translated(point_of(a), Rational(-1L), point_of(b));
  return minkowski(join, join).is_zero();
}

inline bool in_contact(const Sphere& sphere, const OrientedPlane<Rational>& plane) {
  return minkowski(plane.w, point_of(sphere)) == plane.c;
}

/// m + r n: where the sphere has the normal of w.
inline std::array<Rational, 3> contact_point(const Sphere& sphere,
                                             const MinkowskiVector<Rational>& w) {
  std::array<Rational, 3> point = sphere.centre;
  for (std::size_t i = 0; i < 3; ++i) point[i] += sphere.radius * w[i] / w[3];
  return point;
}

}  // namespace pn
