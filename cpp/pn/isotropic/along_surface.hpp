// SPDX-License-Identifier: LGPL-2.1-or-later
// Gamma along a quadratic family of spheres: the contact of every direction, without any root.
//
// THEOREM. Let f(u, v) = a1 u^2/2 + a2 u v + a3 v^2/2 + a4 u + a5 v + a6 in R^{3,1} and w an
// isotropic vector, <w, w> = 0. With qi = <w, ai> the equations <w, f_u> = <w, f_v> = 0 are linear
// in (u, v), and their solution is
//
//     e = q1 q3 - q2^2,     u = (q2 q5 - q3 q4) / e,     v = (q2 q4 - q1 q5) / e.
//
// So for w = w(s, t) the sections of Gamma = f + mu w are rational in s and t: with F = e^2 f(u, v)
//
//     x_d = (F_i w4 + (d e^2 - F4) w_i) / (e^2 w4),     n = (w1, w2, w3) / w4.
//
// (M. Peternell, Rational two-parameter families of spheres and rational offset surfaces, sections
// 2.3 and 5.) For w of total degree 2 those of e, a, b are 4, of F 8 and of x_d 10.
//
// The weights e^2 w4 are positive where e does not vanish, and the map from (s, t) to (u, v) is
// regular there: its Jacobian is +-4 sqrt(Delta) / e for stereographic parameters.
//
// T is the coefficient type: Rational, RealBall.
#pragma once

#include <array>
#include <stdexcept>

#include "pn/algebra/tensor_polynomial.hpp"
#include "pn/isotropic/quadratic_family.hpp"

namespace pn {

/// w1, ..., w4 with <w, w> = 0 and w4 > 0.
template <class T>
using IsotropicPolynomials = MinkowskiVector<TensorPolynomial<T>>;

/// A spinor (a0, a1) by its real and imaginary parts.
template <class T>
struct SpinorPolynomials {
  std::array<TensorPolynomial<T>, 2> re, im;
};

/// w = (2 Re(conj(a0) a1), 2 Im(conj(a0) a1), |a0|^2 - |a1|^2, |a0|^2 + |a1|^2)
template <class T>
IsotropicPolynomials<T> isotropic_polynomials(const SpinorPolynomials<T>& a) {
  const auto square = [&](std::size_t i) { return a.re[i] * a.re[i] + a.im[i] * a.im[i]; };
  const TensorPolynomial<T> upper = square(0), lower = square(1);
  return {(a.re[0] * a.re[1] + a.im[0] * a.im[1]) * T(2L),
          (a.re[0] * a.im[1] - a.im[0] * a.re[1]) * T(2L), upper - lower, upper + lower};
}

/// (u, v) = (a, b) / e
template <class T>
struct Contact {
  TensorPolynomial<T> a, b, e;
};

template <class T>
using PowerForm = std::array<MinkowskiVector<T>, 6>;  ///< a1, ..., a6

/// <w, x>
template <class T>
TensorPolynomial<T> minkowski(const IsotropicPolynomials<T>& w, const MinkowskiVector<T>& x) {
  return w[0] * x[0] + w[1] * x[1] + w[2] * x[2] - w[3] * x[3];
}

template <class T>
Contact<T> contact_of(const PowerForm<T>& f, const IsotropicPolynomials<T>& w) {
  std::array<TensorPolynomial<T>, 5> q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = minkowski(w, f[i]);
  return {q[1] * q[4] - q[2] * q[3], q[1] * q[3] - q[0] * q[4], q[0] * q[2] - q[1] * q[1]};
}

/// x_d = (point + d direction) / weight, with direction = n weight.
template <class T>
struct SurfaceSections {
  std::array<TensorPolynomial<T>, 3> point, direction;
  TensorPolynomial<T> weight;
};

/// The sections of f + mu w over its contact, which may have been freed of a common factor.
template <class T>
SurfaceSections<T> sections(const PowerForm<T>& f, const IsotropicPolynomials<T>& w,
                            const Contact<T>& contact) {
  const auto& [a, b, e] = contact;
  const T half = T(1L) / T(2L);
  const TensorPolynomial<T> aa = a * a, ab = a * b, bb = b * b, ae = a * e, be = b * e, ee = e * e;
  const auto component = [&](std::size_t c) {
    return aa * (half * f[0][c]) + ab * f[1][c] + bb * (half * f[2][c]) + ae * f[3][c] +
           be * f[4][c] + ee * f[5][c];
  };
  const TensorPolynomial<T> f4 = component(3);
  SurfaceSections<T> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.point[i] = component(i) * w[3] - f4 * w[i];
    result.direction[i] = ee * w[i];
  }
  result.weight = ee * w[3];
  return result;
}

/// f times a positive number that makes a1, ..., a6 even integers: its sections are those of f
/// times the same number, and nothing on the way to them needs a denominator.
struct IntegerPowerForm {
  PowerForm<Rational> form;
  Rational factor;
};
IntegerPowerForm integer_power_form(const QuadraticFamily& family);

/// The sections of the family itself.
SurfaceSections<Rational> scaled_sections(const IntegerPowerForm& f,
                                          const IsotropicPolynomials<Rational>& w,
                                          const Contact<Rational>& contact);

/// The sections over a contact with this e, without the common factor of all polynomials. The
/// factor is e^2 or a part of it, which may change its sign; the weight stays positive in the
/// middle of the unit square of s and t.
SurfaceSections<Rational> without_common_factor(SurfaceSections<Rational> sections,
                                                const TensorPolynomial<Rational>& e);

/// The same sections, enclosed at this precision [bits].
SurfaceSections<RealBall> in_balls(const SurfaceSections<Rational>& exact, long bits);

/// Polynomials over Q times one number that makes their coefficients integers: for projective use.
template <std::size_t Count>
std::array<TensorPolynomial<Rational>, Count> with_integers(
    std::array<TensorPolynomial<Rational>, Count> polynomials) {
  Rational factor(1L);
  for (const auto& p : polynomials) {
    for (const Rational& c : p.coefficients())
      factor = common_denominator(Rational(1L) / factor, c);
  }
  for (auto& p : polynomials) p *= factor;
  return polynomials;
}

}  // namespace pn
