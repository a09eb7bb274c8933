// SPDX-License-Identifier: LGPL-2.1-or-later
// The parameter of a conic: what u = (u0 : u1) means around it.
//
// THEOREM. Let X(u) be the homogeneous points of a conic and h(u) = |Z u|^2 a positive form, Z real
// and 2x2. With z = Z u and zeta = z0 + i z1
//
//     X / h = c + Re(p zeta^2) / |zeta|^2,      p = (A0 - A2) / 2 - i A1,      c = (A0 + A2) / 2,
//
// for X = A0 z0^2 + 2 A1 z0 z1 + A2 z1^2. Proof: X = c |zeta|^2 + (A0 - A2) / 2 Re(zeta^2) + A1
// Im(zeta^2).
//
// For an ellipse and its weight h = w the last coordinate of p is 0, c is the centre, Re p and Im p
// are conjugate half-diameters, and arg zeta is half the eccentric angle. For an arc and its form h
// (conic_points.hpp) the ends are orthogonal in z, so that it is half of the circle of zeta^2.
// Proof: [c, h] = 0, so q_c has the trace zero in z.
//
// Z is known up to a rotation, p therefore up to a phase. If X and h are the same in two
// parameters, p' is e^{i alpha} p or, where they go around in opposite directions, e^{i alpha}
// conj(p); then zeta' = e^{-i alpha / 2} zeta, or that of conj(zeta), is the same point. So a point
// has the parameters u and Z'^{-1} M Z u with an orthogonal matrix M, and X and h are the same
// there. The phase with which the Hermitian product of p and p' is positive is the one that turns a
// conic least into another: for circles that of their rotation-minimizing frame.
#pragma once

#include <array>
#include <cmath>

#include "pn/bezier/conic_points.hpp"
#include "pn/bezier/line_factor.hpp"

namespace pn {

/// Z and p of a conic.
template <class T>
struct ConicFrame {
  lines::Matrix<T> circle;           ///< Z
  std::array<T, 4> real, imaginary;  ///< parts of p
};

/// At t, where h is positive for all u.
template <class T>
ConicFrame<T> conic_frame(const ConicForms<T>& forms, const T& t) {
  using std::sqrt;
  const auto [h0, h1, h2] = definite_form(forms, t);
  const HomogeneousConic<T>& x = forms.point;
  const T a = sqrt(h0), b = h1 / a, d = sqrt(h2 - b * b);
  const T e0 = T(1.0) / a, e1 = -b / (a * d), e2 = T(1.0) / d;
  ConicFrame<T> frame{{{{a, b}, {T(0.0), d}}}, {}, {}};
  for (std::size_t c = 0; c < 4; ++c) {
    const T x0 = x[c].coefficient[0](t), x1 = x[c].coefficient[1](t), x2 = x[c].coefficient[2](t);
    const T a0 = x0 * e0 * e0, a1 = (x0 * e1 + x1 * e2) * e0;
    const T a2 = (x0 * e1 + (x1 + x1) * e2) * e1 + x2 * e2 * e2;
    frame.real[c] = (a0 - a2) / T(2.0);
    frame.imaginary[c] = -a1;
  }
  return frame;
}

namespace conic_parameter {

/// Of the conic run through in the opposite direction.
template <class T>
ConicFrame<T> reversed(ConicFrame<T> frame) {
  for (T& x : frame.imaginary) x = -x;
  return frame;
}

/// p' conj(p): real and imaginary part.
template <class T>
std::array<T, 2> hermitian_product(const ConicFrame<T>& to, const ConicFrame<T>& from) {
  std::array<T, 2> sum = {T(0.0), T(0.0)};
  for (std::size_t c = 0; c < 4; ++c) {
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

}  // namespace conic_parameter

/// M of the theorem, from z of one conic to z of another; up to its sign.
template <class T>
lines::Matrix<T> least_turn(const ConicFrame<T>& from, const ConicFrame<T>& to) {
  using lines::midpoint;
  const auto size = [](const std::array<T, 2>& z) {
    return std::hypot(midpoint(z[0]), midpoint(z[1]));
  };
  const std::array<T, 2> along = conic_parameter::hermitian_product(to, from),
                         against = conic_parameter::hermitian_product(
                             to, conic_parameter::reversed(from));
  const bool keeps_direction = size(along) >= size(against);
  const auto [c, s] = conic_parameter::half_turn(keeps_direction ? along : against);
  return keeps_direction ? lines::Matrix<T>{{{c, s}, {-s, c}}}
                         : lines::Matrix<T>{{{c, -s}, {-s, -c}}};
}

/// The two zeros u of q_c at t with h = 1, as columns; q_c is positive in the middle between them.
template <class T>
lines::Matrix<T> ends_of_arc(const ConicForms<T>& forms, const T& t) {
  using std::sqrt;
  const lines::Matrix<T> from_circle = lines::inverse(conic_frame(forms, t).circle);
  const auto& q = forms.cut.coefficient;
  const T q0 = q[0](t), q1 = q[1](t), q2 = q[2](t);
  const auto value = [&](std::size_t i, std::size_t j) {
    const T a0 = from_circle[0][i], a1 = from_circle[1][i];
    const T b0 = from_circle[0][j], b1 = from_circle[1][j];
    return q0 * a0 * b0 + q1 * (a0 * b1 + a1 * b0) + q2 * a1 * b1;
  };
  // In z it is a multiple of cos(2 x - 2 m) at the angle x: largest at m, zero an eighth of a turn
  // from it.
  const auto [c, s] = conic_parameter::half_turn<T>({value(0, 0), value(0, 1)});
  // The root of 2 at the precision of c and s.
  const T root = sqrt(c * c + s * s + c * c + s * s);
  const lines::Matrix<T> ends = {{{c + s, c - s}, {s - c, c + s}}};
  using lines::operator*;
  return lines::scaled(from_circle * ends, T(1.0) / root);
}

}  // namespace pn
