// SPDX-License-Identifier: LGPL-2.1-or-later
// The fields Q(u, v), Q(u, v, s), Q(u, v, s, t): exact rational functions in lowest terms.
//
// Contract: every operation is exact. Numerator and denominator have no common factor, and the
// leading coefficient of the denominator is 1, so equal functions have equal representations.
#pragma once

#include "pn/algebra/multivariate_polynomial.hpp"

namespace pn {

template <std::size_t N>
class RationalFunction {
 public:
  using Polynomial = MultivariatePolynomial<N>;

  RationalFunction() : RationalFunction(Polynomial()) {}
  RationalFunction(long constant) : RationalFunction(Polynomial(constant)) {}
  RationalFunction(const Rational& constant) : RationalFunction(Polynomial(constant)) {}
  RationalFunction(Polynomial polynomial)
      : numerator_(std::move(polynomial)), denominator_(Polynomial(1L)) {}
  /// Throws std::domain_error when the denominator is zero.
  RationalFunction(Polynomial numerator, Polynomial denominator);

  const Polynomial& numerator() const { return numerator_; }
  const Polynomial& denominator() const { return denominator_; }
  bool is_zero() const { return numerator_.is_zero(); }

  /// Throws std::domain_error where the denominator vanishes.
  Rational at(const std::array<Rational, N>& values) const;
  template <class... Values>
  Rational operator()(const Values&... values) const {
    static_assert(sizeof...(Values) == N);
    return at({values...});
  }
  RationalFunction derivative(Variable variable) const;
  /// Functions, which may be of another field, in place of the variables. Throws std::domain_error
  /// when the denominator vanishes identically.
  template <std::size_t M>
  RationalFunction<M> composed(const std::array<RationalFunction<M>, N>& functions) const;

  RationalFunction& operator+=(const RationalFunction& other);
  RationalFunction& operator-=(const RationalFunction& other) { return *this += -other; }
  RationalFunction& operator*=(const RationalFunction& other);
  /// Throws std::domain_error when the other function is zero.
  RationalFunction& operator/=(const RationalFunction& other);
  RationalFunction operator-() const;
  friend RationalFunction operator+(RationalFunction a, const RationalFunction& b) {
    return std::move(a += b);
  }
  friend RationalFunction operator-(RationalFunction a, const RationalFunction& b) {
    return std::move(a -= b);
  }
  friend RationalFunction operator*(RationalFunction a, const RationalFunction& b) {
    return std::move(a *= b);
  }
  friend RationalFunction operator/(RationalFunction a, const RationalFunction& b) {
    return std::move(a /= b);
  }
  friend bool operator==(const RationalFunction& a, const RationalFunction& b) {
    return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_;
  }
  friend bool operator!=(const RationalFunction& a, const RationalFunction& b) { return !(a == b); }

 private:
  Polynomial numerator_, denominator_;
};

using BivariateFunction = RationalFunction<2>;

/// A function whose square is f, or nothing when f is no square over Q.
template <std::size_t N>
std::optional<RationalFunction<N>> square_root(const RationalFunction<N>& f);

}  // namespace pn
