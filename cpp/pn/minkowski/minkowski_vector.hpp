// SPDX-License-Identifier: LGPL-2.1-or-later
// Vectors of Minkowski space R^{3,1}, and their causal type.
//
// <x, y> = x1 y1 + x2 y2 + x3 y3 - x4 y4. A vector is space-like, light-like (isotropic) or
// time-like as <x, x> is positive, zero or negative. A plane is of the type of its Gram
// determinant: space-like planes contain no isotropic direction, light-like planes one, time-like
// planes two. A space-like plane of spheres has a real envelope, a pair of planes; a light-like one
// has a single plane; a time-like one has none. (M. Peternell, B. Odehnal, M. L. Sampoli, On
// quadratic two-parameter families of spheres and their envelopes, CAGD 25, 2008, section 2.)
#pragma once

#include <array>

#include "pn/algebra/rational.hpp"

namespace pn {

/// x1, x2, x3, x4; the direction is also the point x of the space at infinity.
template <class T>
using MinkowskiVector = std::array<T, 4>;

template <class X, class Y>
auto minkowski(const MinkowskiVector<X>& x, const MinkowskiVector<Y>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] - x[3] * y[3];
}

/// x + k y
template <class T>
MinkowskiVector<T> translated(MinkowskiVector<T> x, const T& k, const MinkowskiVector<T>& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += k * y[i];
  return x;
}

enum class CausalType { kSpaceLike, kLightLike, kTimeLike };

/// Of a vector with this <x, x>, or of a plane with this Gram determinant.
inline CausalType causal_type(const Rational& square) {
  if (square.is_zero()) return CausalType::kLightLike;
  return square.sign() > 0 ? CausalType::kSpaceLike : CausalType::kTimeLike;
}

/// The Gram determinant of x and y.
template <class T>
T gram_determinant(const MinkowskiVector<T>& x, const MinkowskiVector<T>& y) {
  return minkowski(x, x) * minkowski(y, y) - minkowski(x, y) * minkowski(x, y);
}

}  // namespace pn
