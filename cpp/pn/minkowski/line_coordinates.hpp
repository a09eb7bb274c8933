// SPDX-License-Identifier: LGPL-2.1-or-later
// Lines and linear complexes of the space at infinity of R^{3,1}, by Pluecker coordinates.
//
// The directions of R^{3,1} are the points of a projective space, in which the isotropic ones form
// the quadric Omega: <x, x> = 0. A plane of R^{3,1} has a line there. Points are numbered x0..x3
// here, with <x, y> = x0 y0 + x1 y1 + x2 y2 - x3 y3. The line of p and q is
//
//     l = (l01, l02, l03; l23, l31, l12),     lik = pi qk - pk qi,
//
// and six numbers are a line exactly when they satisfy Klein's equation [l, l] = 0, where
//
//     [a, b] = a1 b4 + a2 b5 + a3 b6 + a4 b1 + a5 b2 + a6 b3.
//
// Any c other than 0 is a linear complex: the lines with [c, l] = 0. Those through a point x fill a
// pencil in its null plane N(c) x,
//
//     N(c) = ( 0    c4   c5   c6 )
//            (-c4   0    c3  -c2 )
//            (-c5  -c3   0    c1 )
//            (-c6   c2  -c1   0  ).
//
// A line is a special complex, of the lines that meet it: its null planes join it with the points,
// and N(l) x = 0 means that x lies on l. The polarity with respect to Omega maps
//
//     c -> (-c4, -c5, c6, c1, c2, -c3),     [polar a, polar b] = -[a, b],
//
// and two lines are polar when the planes of R^{3,1} are orthogonal. THEOREM. [l, polar l] is the
// Gram determinant of two vectors that span l, so the plane is space-like, light-like or time-like
// as its line misses, touches or meets Omega. (D. Gruber, Diplomarbeit, TU Wien 2008, (1.1)-(1.11),
// (1.19); H. Pottmann, J. Wallner, Computational Line Geometry, 2001.) The proof is the expansion
// of both sides.
//
// T is any commutative ring: Rational, polynomials, forms.
#pragma once

#include "pn/minkowski/minkowski_vector.hpp"

namespace pn {

/// A line, when [c, c] = 0, or a linear complex.
template <class T>
using LineCoordinates = std::array<T, 6>;

/// e0 x0 + e1 x1 + e2 x2 + e3 x3 = 0
template <class T>
using PlaneAtInfinity = std::array<T, 4>;

/// e.x: zero when the point lies in the plane.
template <class P, class X>
auto incidence(const PlaneAtInfinity<P>& plane, const MinkowskiVector<X>& x) {
  return x[0] * plane[0] + x[1] * plane[1] + x[2] * plane[2] + x[3] * plane[3];
}

/// The line through two points.
template <class P, class Q>
auto join(const MinkowskiVector<P>& p, const MinkowskiVector<Q>& q) {
  const auto minor = [&](std::size_t i, std::size_t k) { return p[i] * q[k] - p[k] * q[i]; };
  return std::array{minor(0, 1), minor(0, 2), minor(0, 3), minor(2, 3), minor(3, 1), minor(1, 2)};
}

/// The line in two planes.
template <class T>
LineCoordinates<T> meet(const PlaneAtInfinity<T>& e, const PlaneAtInfinity<T>& f) {
  const LineCoordinates<T> l = join(e, f);
  return {l[3], l[4], l[5], l[0], l[1], l[2]};
}

/// [a, b]
template <class A, class B>
auto klein(const LineCoordinates<A>& a, const LineCoordinates<B>& b) {
  return a[0] * b[3] + a[1] * b[4] + a[2] * b[5] + a[3] * b[0] + a[4] * b[1] + a[5] * b[2];
}

/// N(c) x
template <class X, class C>
PlaneAtInfinity<X> null_plane(const LineCoordinates<C>& c, const MinkowskiVector<X>& x) {
  return {x[1] * c[3] + x[2] * c[4] + x[3] * c[5], x[2] * c[2] - x[0] * c[3] - x[3] * c[1],
          x[3] * c[0] - x[0] * c[4] - x[1] * c[2], x[0] * -c[5] + x[1] * c[1] - x[2] * c[0]};
}

/// With respect to Omega.
template <class T>
LineCoordinates<T> polar(const LineCoordinates<T>& c) {
  return {-c[3], -c[4], c[5], c[0], c[1], -c[2]};
}

/// [a, polar b]: symmetric.
template <class T>
T omega(const LineCoordinates<T>& a, const LineCoordinates<T>& b) {
  return klein(a, polar(b));
}

/// Of the planes with this line at infinity.
inline CausalType causal_type(const LineCoordinates<Rational>& line) {
  return causal_type(omega(line, line));
}

/// Whether x lies on the line.
inline bool incident(const LineCoordinates<Rational>& line, const MinkowskiVector<Rational>& x) {
  for (const Rational& e : null_plane(line, x)) {
    if (!e.is_zero()) return false;
  }
  return true;
}

}  // namespace pn
