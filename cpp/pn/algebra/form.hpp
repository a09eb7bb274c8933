// SPDX-License-Identifier: LGPL-2.1-or-later
// Forms: homogeneous polynomials in (t : s), of a fixed formal degree.
//
// A form of formal degree n is sum_i a_i t^i s^(n-i). Its roots are n points of the projective
// line, so a polynomial whose leading coefficients vanish has roots at infinity instead of a lower
// degree. The zero form of formal degree -1 has no coefficients: it is what is left when a constant
// that is known to vanish is divided by a linear form.
//
// T is the coefficient type: double, std::complex<double>, RealBall, ComplexBall, Rational.
#pragma once

#include <cassert>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include "pn/algebra/ball_vector.hpp"

namespace pn {

inline void add_product(double& sum, double a, double b) { sum += a * b; }
inline void add_product(std::complex<double>& sum, const std::complex<double>& a,
                        const std::complex<double>& b) {
  // Written out because the library's product guards against infinities that cannot occur here.
  sum += std::complex<double>(a.real() * b.real() - a.imag() * b.imag(),
                              a.real() * b.imag() + a.imag() * b.real());
}
inline void add_product(RealBall& sum, const RealBall& a, const RealBall& b) {
  sum.add_product(a, b);
}
inline void add_product(ComplexBall& sum, const ComplexBall& a, const ComplexBall& b) {
  sum.add_product(a, b);
}
inline void add_product(Rational& sum, const Rational& a, const Rational& b) { sum += a * b; }

/// The same of polynomials by their coefficients; of balls in ball_vector.hpp.
template <class T>
void add_product(std::vector<T>& sum, const std::vector<T>& a, const std::vector<T>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) add_product(sum[i + j], a[i], b[j]);
  }
}

template <class T>
class Form {
 public:
  Form() = default;
  explicit Form(std::vector<T> coefficients) : coefficients_(std::move(coefficients)) {}
  static Form constant(const T& value) { return Form(std::vector<T>{value}); }
  static Form zero(int degree) {
    return Form(std::vector<T>(static_cast<std::size_t>(degree + 1)));
  }

  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  const std::vector<T>& coefficients() const { return coefficients_; }
  const T& operator[](int i) const { return coefficients_[static_cast<std::size_t>(i)]; }
  T& operator[](int i) { return coefficients_[static_cast<std::size_t>(i)]; }

  /// The value at t, with s = 1.
  T operator()(const T& t) const {
    T value{};
    for (std::size_t i = coefficients_.size(); i-- > 0;) {
      value *= t;
      value += coefficients_[i];
    }
    return value;
  }
  /// The derivative by t at t, with s = 1.
  T slope(const T& t) const {
    T value{}, slope{};
    for (std::size_t i = coefficients_.size(); i-- > 0;) {
      slope *= t;
      slope += value;
      value *= t;
      value += coefficients_[i];
    }
    return slope;
  }
  /// The coefficient of t^degree: the value at infinity (t : s) = (1 : 0).
  T at_infinity() const { return coefficients_.empty() ? T{} : coefficients_.back(); }

  /// The derivative by t, of formal degree one less.
  Form derivative() const {
    Form result = zero(std::max(degree() - 1, 0));
    for (int i = 1; i <= degree(); ++i) result[i - 1] = (*this)[i] * T(static_cast<double>(i));
    return result;
  }
  /// The form of the polynomial in the parameter of which t = origin + length * parameter.
  Form on_interval(const T& origin, const T& length) const {
    Form result = constant(at_infinity());
    const Form linear({origin, length});
    for (int i = degree() - 1; i >= 0; --i) {
      result = result * linear;
      result[0] += (*this)[i];
    }
    return result;
  }
  /// The same polynomial in t, written with a higher formal degree.
  Form elevated(int to_degree) const {
    Form result = *this;
    result.coefficients_.resize(static_cast<std::size_t>(to_degree) + 1);
    return result;
  }

  Form& operator+=(const Form& other) {
    if (other.coefficients_.empty()) return *this;
    if (coefficients_.empty()) return *this = other;
    assert(degree() == other.degree());
    for (std::size_t i = 0; i < coefficients_.size(); ++i)
      coefficients_[i] += other.coefficients_[i];
    return *this;
  }
  Form& operator-=(const Form& other) {
    if (other.coefficients_.empty()) return *this;
    if (coefficients_.empty()) return *this = other * T(-1.0);
    assert(degree() == other.degree());
    for (std::size_t i = 0; i < coefficients_.size(); ++i)
      coefficients_[i] -= other.coefficients_[i];
    return *this;
  }
  /// *this += a b; in the sum the smaller formal degree is raised.
  Form& add_product(const Form& a, const Form& b) {
    if (a.coefficients_.empty() || b.coefficients_.empty()) return *this;
    const std::size_t size = a.coefficients_.size() + b.coefficients_.size() - 1;
    if (coefficients_.size() < size) coefficients_.resize(size);
    pn::add_product(coefficients_, a.coefficients_, b.coefficients_);
    return *this;
  }
  friend Form operator+(Form a, const Form& b) { return std::move(a += b); }
  friend Form operator-(Form a, const Form& b) { return std::move(a -= b); }
  friend Form operator*(Form a, const T& factor) {
    for (T& coefficient : a.coefficients_) coefficient *= factor;
    return a;
  }
  friend Form operator*(const Form& a, const Form& b) {
    Form result;
    result.add_product(a, b);
    return result;
  }

 private:
  std::vector<T> coefficients_;
};

template <class T>
Form<T> conj(const Form<T>& form) {
  std::vector<T> result;
  result.reserve(form.coefficients().size());
  for (const T& coefficient : form.coefficients()) result.push_back(conj(coefficient));
  return Form<T>(std::move(result));
}

/// The midpoints of the coefficients, in doubles.
template <class Ball>
auto midpoint(const Form<Ball>& form) {
  std::vector<decltype(std::declval<Ball>().midpoint())> result;
  result.reserve(form.coefficients().size());
  for (const Ball& coefficient : form.coefficients()) result.push_back(coefficient.midpoint());
  return Form(std::move(result));
}

/// form / (t - root), for a root of the form. Synthetic division runs from the end at which it does
/// not amplify errors: from the top for |root| <= 1, from the bottom beyond.
template <class T>
Form<T> divided_by_root(const Form<T>& form, const T& root, bool beyond_unit_circle) {
  const int n = form.degree();
  if (n <= 0) return Form<T>();
  Form<T> quotient = Form<T>::zero(n - 1);
  if (beyond_unit_circle) {
    const T inverse = T(1.0) / root;
    quotient[0] = form[0] * inverse * T(-1.0);
    for (int i = 1; i < n; ++i) quotient[i] = (quotient[i - 1] - form[i]) * inverse;
  } else {
    quotient[n - 1] = form[n];
    for (int i = n - 1; i > 0; --i) {
      quotient[i - 1] = form[i];
      add_product(quotient[i - 1], root, quotient[i]);
    }
  }
  return quotient;
}

/// form / s, for a form that vanishes at infinity: the formal degree drops by one.
template <class T>
Form<T> divided_by_infinity(const Form<T>& form) {
  std::vector<T> coefficients = form.coefficients();
  if (!coefficients.empty()) coefficients.pop_back();
  return Form<T>(std::move(coefficients));
}

}  // namespace pn
