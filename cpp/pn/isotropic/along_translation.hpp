// SPDX-License-Identifier: LGPL-2.1-or-later
// Gamma along a translational family: circles of the one curve, contact with the other.
//
// THEOREM 1. Let f(u, v) = c(u) + d(v) in R^{3,1} with a curve of spheres c and a parabola
//
//     d(v) = d2 v^2/2 + d1 v + d0.
//
// For every u the normals w with <w, c'(u)> = 0 are a circle, and w = w(u, theta) stems from the
// spinor factorization of the family of circles of c (along_curve.hpp). On it <w, d'(v)> = 0 is
// linear in v:
//
//     v = -P / Q,     P = <w, d1>,     Q = <w, d2>,
//
// so for c = C / q the sections of Gamma = f + mu w are rational:
//
//     F = C Q^2 + q (d2 P^2/2 - d1 P Q + d0 Q^2),
//     x_d = (F_i w4 + (d q Q^2 - F4) w_i) / (q Q^2 w4),     n = (w1, w2, w3) / w4.
//
// The degree along is that of c and six times that of the spinor, the degree around 6. For a
// parabola c that is (8, 6), or (10, 6) when its plane is time-like, where
// odd_root_substitution.hpp doubles the degree of c; (2, 6) when c' has one direction, (1, 6) for a
// line c. (M. Peternell, Rational two-parameter families of spheres and rational offset surfaces,
// section 6.6.)
//
// THEOREM 2 (folds). Where Delta > 0 and Q does not vanish, (u, theta) -> (u, v) is regular. Proof:
// dv / dtheta = -<w_theta, d'> / Q, and w_theta is space-like and orthogonal to w and c'. So
// <w_theta, d'> = 0 only if d' is orthogonal to w and w_theta, and so a combination of w and c';
// then Delta = 0. QED
//
// THEOREM 3 (charts). Let Delta > 0 on a rectangle. On a sheet that is no plane the zeros of Q are
// lines u = const and those of <w, c''> are lines v = const, from side to side, and not both occur:
// either the family or the one with c and d exchanged has a chart without a fold. Proof: Where Q =
// 0, <w, d1> = 0 as well, so w is orthogonal to d'(v) for all v, and is the normal along the whole
// line u = const. The same holds of <w, c''> with v = const. Where two such lines cross, w is
// orthogonal to c1, c2, d1 and d2: the sheet is a plane (translational_family.hpp). QED
//
// T is the coefficient type: Rational, RealBall.
#pragma once

#include "pn/isotropic/along_surface.hpp"
#include "pn/isotropic/translational_family.hpp"

namespace pn {

/// The curve c = numerator / denominator, (m, -r), in the parameter of w.
template <class T>
struct TranslatedCurve {
  MinkowskiVector<TensorPolynomial<T>> numerator;
  TensorPolynomial<T> denominator;
};

/// The parabola d.
template <class T>
struct TranslatingParabola {
  MinkowskiVector<T> second, first, start;
};

/// The sections over w = w(u, theta) with <w, c'> = 0.
template <class T>
SurfaceSections<T> sections(const TranslatedCurve<T>& c, const TranslatingParabola<T>& d,
                            const IsotropicPolynomials<T>& w) {
  const TensorPolynomial<T> p = minkowski(w, d.first), q = minkowski(w, d.second);
  const TensorPolynomial<T> pp = p * p, pq = p * q, qq = q * q;
  const T half = T(1L) / T(2L);
  const auto component = [&](std::size_t i) {
    return c.numerator[i] * qq +
           c.denominator * (pp * (half * d.second[i]) - pq * d.first[i] + qq * d.start[i]);
  };
  const TensorPolynomial<T> f4 = component(3), weight = c.denominator * qq;
  SurfaceSections<T> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.point[i] = component(i) * w[3] - f4 * w[i];
    result.direction[i] = weight * w[i];
  }
  result.weight = weight * w[3];
  return result;
}

}  // namespace pn
