// SPDX-License-Identifier: LGPL-2.1-or-later
// The rational isotropic hypersurface Gamma in Minkowski space R^{3,1}.
//
// THEOREM. Let f be a rational curve (or surface) in R^{3,1} and w a polynomial vector with <w, w>
// = 0, <w, df> = 0 and w4 > 0. Then Gamma = f + mu w meets every space x4 = d in a rational surface
// with a rational unit normal, and these surfaces are the offsets of each other:
//
//     n = (w1, w2, w3) / w4,      x_d = (f1, f2, f3) + (d - f4) n,      n.x_d = <f, w> / w4 + d.
//
// (M. Peternell, Rational two-parameter families of spheres and rational offset surfaces, Theorems
// 9 and 13.) Offsetting is choosing another section of the same hypersurface.
//
// Here w(t, u) stems from a spinor a = A(t) (u0, u1)^T: w = (2 Re(conj(a0) a1), 2 Im(conj(a0) a1),
// |a0|^2 - |a1|^2, |a0|^2 + |a1|^2), quadratic in u = (u0 : u1). What carries it, a curve of
// spheres, a family of rulings or a quadric, is the matter of sections.hpp.
//
// T is the real number type: RealBall, which encloses, or double, which estimates.
#pragma once

#include <array>
#include <complex>
#include <type_traits>
#include <variant>

#include "pn/algebra/ball.hpp"
#include "pn/isotropic/sections.hpp"
#include "pn/isotropic/spinor_factorization.hpp"

namespace pn {

template <class T>
using ComplexOf =
    std::conditional_t<std::is_same_v<T, RealBall>, ComplexBall, std::complex<double>>;

namespace spinor {

template <class T>
struct RealAndImaginary {
  Form<T> re, im;
};

inline double re(const std::complex<double>& z) { return z.real(); }
inline double im(const std::complex<double>& z) { return z.imag(); }
inline RealBall re(const ComplexBall& z) { return z.real(); }
inline RealBall im(const ComplexBall& z) { return z.imag(); }

template <class T>
RealAndImaginary<T> parts(const Form<ComplexOf<T>>& form, int degree) {
  RealAndImaginary<T> result{Form<T>::zero(degree), Form<T>::zero(degree)};
  for (int i = 0; i <= form.degree(); ++i) {
    result.re[i] = re(form[i]);
    result.im[i] = im(form[i]);
  }
  return result;
}

/// Re(conj(x) y) and Im(conj(x) y).
template <class T>
RealAndImaginary<T> conjugate_product(const RealAndImaginary<T>& x, const RealAndImaginary<T>& y) {
  return {x.re * y.re + x.im * y.im, x.re * y.im - x.im * y.re};
}

}  // namespace spinor

/// w for the spinors a = A (u0, u1)^T; the columns of A are taken at the degree of the larger one.
template <class T>
IsotropicVector<T> isotropic_vector(const SpinorMatrix<ComplexOf<T>>& a) {
  const int degree = std::max(a.degree[0], a.degree[1]);
  std::array<std::array<spinor::RealAndImaginary<T>, 2>, 2> entry;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) entry[i][j] = spinor::parts<T>(a.entry[i][j], degree);
  }
  IsotropicVector<T> w;
  for (FormInU<T>& component : w) component.coefficient.resize(3);
  const std::array<std::array<int, 2>, 3> columns = {{{0, 0}, {0, 1}, {1, 1}}};
  for (std::size_t q = 0; q < 3; ++q) {
    const auto [j, k] = columns[q];
    const Form<T> upper = entry[0][j].re * entry[0][k].re + entry[0][j].im * entry[0][k].im;
    const Form<T> lower = entry[1][j].re * entry[1][k].re + entry[1][j].im * entry[1][k].im;
    spinor::RealAndImaginary<T> mixed = spinor::conjugate_product(entry[0][j], entry[1][k]);
    if (j == k) {
      mixed = {mixed.re * T(2.0), mixed.im * T(2.0)};
    } else {
      const auto other = spinor::conjugate_product(entry[0][k], entry[1][j]);
      mixed = {mixed.re + other.re, mixed.im + other.im};
    }
    w[0].coefficient[q] = mixed.re;
    w[1].coefficient[q] = mixed.im;
    w[2].coefficient[q] = upper - lower;
    w[3].coefficient[q] = upper + lower;
  }
  return w;
}

/// The circles n.axis + level = 0 on the unit sphere; all forms in the local parameter on [0, 1].
template <class T>
struct CircleForms {
  std::array<Form<T>, 3> axis;
  Form<T> level;  ///< of the same formal degree as axis
};

template <class T>
using Carrier =
    std::variant<SphereCurveForms<T>, RulingForms<T>, QuadricForms<T>, DevelopableForms<T>>;

template <class T>
struct IsotropicHypersurface {
  Carrier<T> carrier;
  CircleForms<T> circles;
  SpinorMatrix<ComplexOf<T>> spinor;
};

/// Degrees in t and in u of the sections, with w from a spinor matrix of this larger column degree.
int section_degree(const Carrier<RealBall>& carrier, int spinor_degree);
int section_degree_around(const Carrier<RealBall>& carrier);

/// The forms in the parameter of which t = origin + length * parameter.
CircleForms<RealBall> on_interval(const CircleForms<RealBall>& circles, const RealBall& origin,
                                  const RealBall& length);
Carrier<RealBall> on_interval(const Carrier<RealBall>& carrier, const RealBall& origin,
                              const RealBall& length);

/// The midpoints of an enclosure.
Carrier<double> midpoint(const Carrier<RealBall>& carrier);
CircleForms<double> midpoint(const CircleForms<RealBall>& circles);
SpinorMatrix<std::complex<double>> midpoint(const SpinorMatrix<ComplexBall>& spinor);
IsotropicHypersurface<double> midpoint(const IsotropicHypersurface<RealBall>& gamma);

/// The sections of Gamma over f.
template <class T>
HomogeneousSections<T> sections(const Carrier<T>& f, const IsotropicVector<T>& w) {
  return std::visit([&](const auto& carrier) { return sections(carrier, w); }, f);
}

}  // namespace pn
