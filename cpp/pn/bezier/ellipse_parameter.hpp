// SPDX-License-Identifier: LGPL-2.1-or-later
// The parameter of an ellipse: what u = (u0 : u1) means around it.
//
// THEOREM. Let x = X(u) / w(u) be an ellipse, X and w quadratic in u and w = |Z u|^2, Z real and
// 2x2. With z = Z u and zeta = z0 + i z1
//
//     x = c + Re(p zeta^2) / |zeta|^2,      p = (A0 - A2) / 2 - i A1,      c = (A0 + A2) / 2,
//
// for X = A0 z0^2 + 2 A1 z0 z1 + A2 z1^2. So c is the centre, Re p and Im p are conjugate
// half-diameters, and arg zeta is half the eccentric angle. Proof: X = c |zeta|^2 + (A0 - A2) / 2
// Re(zeta^2) + A1 Im(zeta^2).
//
// Z is known up to a rotation, p therefore up to a phase. If two forms (X, w) give the same
// ellipse, p' is e^{i alpha} p or, where they go around in opposite directions, e^{i alpha}
// conj(p); then zeta' = e^{-i alpha / 2} zeta, or that of conj(zeta), is the same point. So a point
// has the parameters u and Z'^{-1} M Z u with an orthogonal matrix M, and both weights are the same
// there. The phase with which the Hermitian product of p and p' is positive is the one that turns
// an ellipse least into another: for circles that of their rotation-minimizing frame.
#pragma once

#include <array>
#include <cmath>

#include "pn/bezier/conic_points.hpp"
#include "pn/bezier/line_factor.hpp"

namespace pn {

/// Z and p of an ellipse.
template <class T>
struct EllipseFrame {
  lines::Matrix<T> circle;           ///< Z
  std::array<T, 3> real, imaginary;  ///< parts of p
};

/// At t, where the weight is positive for all u.
template <class T>
EllipseFrame<T> ellipse_frame(const HomogeneousConic<T>& x, const T& t) {
  using std::sqrt;
  const auto& w = x[3].coefficient;
  const T w0 = w[0](t), w1 = w[1](t), w2 = w[2](t);
  const T a = sqrt(w0), b = w1 / a, d = sqrt(w2 - b * b);
  const T e0 = T(1.0) / a, e1 = -b / (a * d), e2 = T(1.0) / d;
  EllipseFrame<T> frame{{{{a, b}, {T(0.0), d}}}, {}, {}};
  for (std::size_t c = 0; c < 3; ++c) {
    const T x0 = x[c].coefficient[0](t), x1 = x[c].coefficient[1](t), x2 = x[c].coefficient[2](t);
    const T a0 = x0 * e0 * e0, a1 = (x0 * e1 + x1 * e2) * e0;
    const T a2 = (x0 * e1 + (x1 + x1) * e2) * e1 + x2 * e2 * e2;
    frame.real[c] = (a0 - a2) / T(2.0);
    frame.imaginary[c] = -a1;
  }
  return frame;
}

namespace ellipse_parameter {

/// Of the ellipse run through in the opposite direction.
template <class T>
EllipseFrame<T> reversed(EllipseFrame<T> frame) {
  for (T& x : frame.imaginary) x = -x;
  return frame;
}

/// p' conj(p): real and imaginary part.
template <class T>
std::array<T, 2> hermitian_product(const EllipseFrame<T>& to, const EllipseFrame<T>& from) {
  std::array<T, 2> sum = {T(0.0), T(0.0)};
  for (std::size_t c = 0; c < 3; ++c) {
    sum[0] += to.real[c] * from.real[c] + to.imaginary[c] * from.imaginary[c];
    sum[1] += to.imaginary[c] * from.real[c] - to.real[c] * from.imaginary[c];
  }
  return sum;
}

/// The number of modulus 1 whose square has the direction of this one.
template <class T>
std::array<T, 2> half_turn(const std::array<T, 2>& number) {
  using lines::midpoint;
  using std::sqrt;
  const T length = sqrt(number[0] * number[0] + number[1] * number[1]);
  const T cosine = number[0] / length, sine = number[1] / length;
  if (midpoint(cosine) >= 0) {
    const T c = sqrt((T(1.0) + cosine) / T(2.0));
    return {c, sine / (c + c)};
  }
  const T s = sqrt((T(1.0) - cosine) / T(2.0));
  return {sine / (s + s), s};
}

}  // namespace ellipse_parameter

/// M of the theorem, from z of one ellipse to z of another; up to its sign.
template <class T>
lines::Matrix<T> least_turn(const EllipseFrame<T>& from, const EllipseFrame<T>& to) {
  using lines::midpoint;
  const auto size = [](const std::array<T, 2>& z) {
    return std::hypot(midpoint(z[0]), midpoint(z[1]));
  };
  const std::array<T, 2> along = ellipse_parameter::hermitian_product(to, from),
                         against = ellipse_parameter::hermitian_product(
                             to, ellipse_parameter::reversed(from));
  const bool keeps_direction = size(along) >= size(against);
  const auto [c, s] = ellipse_parameter::half_turn(keeps_direction ? along : against);
  return keeps_direction ? lines::Matrix<T>{{{c, s}, {-s, c}}}
                         : lines::Matrix<T>{{{c, -s}, {-s, -c}}};
}

}  // namespace pn
