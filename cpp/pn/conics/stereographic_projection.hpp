// SPDX-License-Identifier: LGPL-2.1-or-later
// Stereographic projection of quadrics in any dimension, and its dual.
//
// THEOREM. Let f be a point of the quadric x^T C x = 0 and q any other one. The line f q meets the
// quadric in f and in
//
//     x = (q^T C q) f - 2 (f^T C q) q.
//
// Proof: f^T C f = 0, so x^T C x = -4 (q^T C q) (f^T C q)^2 + 4 (f^T C q)^2 (q^T C q) = 0. QED
//
// Where q runs over a hyperplane without f, x runs over all points of the quadric but those of
// tangents at f: the inverse of the projection from f, quadratic in q. In the plane, for c0 x0^2 +
// c1 x1^2 + c2 x2^2 and q = (0, 1, u), it is
//
//     (c1 + c2 u^2) f - 2 (c1 f1 + c2 f2 u) q,
//
// and for +-1 on the diagonal, f = (1, 0, ..., 0, 1) and q = (1, u, 0), S = u^T C u,
//
//     (S - 1, -2 u, S + 1).
//
// Read with planes for points, and with C for the planes that touch a quadric, it gives the second
// tangent plane through the intersection of f and q. (M. Peternell, dissertation TU Wien 1997,
// (1.29), (1.32), (1.34).)
//
// T is any commutative ring: numbers, polynomials, balls.
#pragma once

#include <array>
#include <cstddef>

namespace pn {

/// C x: the polar of x. [i][j] is row i of column j.
template <class T, std::size_t N>
std::array<T, N> polar_of(const std::array<std::array<T, N>, N>& c, const std::array<T, N>& x) {
  std::array<T, N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) result[i] += c[i][j] * x[j];
  }
  return result;
}

/// x . y: of a point and a plane zero when they are incident.
template <class T, std::size_t N>
T contraction(const std::array<T, N>& x, const std::array<T, N>& y) {
  T sum{};
  for (std::size_t i = 0; i < N; ++i) sum += x[i] * y[i];
  return sum;
}

/// x^T C y: zero when x and y are conjugate.
template <class T, std::size_t N>
T polar_form(const std::array<std::array<T, N>, N>& c, const std::array<T, N>& x,
             const std::array<T, N>& y) {
  return contraction(x, polar_of(c, y));
}

/// The point x of the theorem, for a symmetric C and a point f of its quadric.
template <class T, std::size_t N>
std::array<T, N> stereographic_projection(const std::array<std::array<T, N>, N>& c,
                                          const std::array<T, N>& f, const std::array<T, N>& q) {
  const std::array<T, N> polar = polar_of(c, q);
  const T at_q = contraction(q, polar), half_slope = contraction(f, polar);
  std::array<T, N> x;
  for (std::size_t i = 0; i < N; ++i) {
    x[i] = at_q * f[i];
    x[i] -= (half_slope + half_slope) * q[i];
  }
  return x;
}

}  // namespace pn
