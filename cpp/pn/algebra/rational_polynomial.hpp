// SPDX-License-Identifier: LGPL-2.1-or-later
// The ring Q[t]: exact univariate polynomials.
//
// Contract: every operation is exact; degrees, common factors and signs are decided, not estimated.
#pragma once

#include <flint/fmpq_poly.h>

#include <vector>

#include "pn/algebra/rational.hpp"

namespace pn {

class RationalPolynomial {
 public:
  RationalPolynomial() { fmpq_poly_init(value_); }
  RationalPolynomial(const Rational& constant);
  RationalPolynomial(long constant) : RationalPolynomial(Rational(constant)) {}
  /// Coefficients in ascending order.
  explicit RationalPolynomial(const std::vector<Rational>& coefficients);
  RationalPolynomial(const RationalPolynomial& other) : RationalPolynomial() {
    fmpq_poly_set(value_, other.value_);
  }
  RationalPolynomial(RationalPolynomial&& other) noexcept : RationalPolynomial() {
    fmpq_poly_swap(value_, other.value_);
  }
  RationalPolynomial& operator=(RationalPolynomial other) noexcept {
    fmpq_poly_swap(value_, other.value_);
    return *this;
  }
  ~RationalPolynomial() { fmpq_poly_clear(value_); }

  /// -1 for the zero polynomial.
  int degree() const { return static_cast<int>(fmpq_poly_degree(value_)); }
  bool is_zero() const { return fmpq_poly_is_zero(value_) != 0; }
  Rational coefficient(int i) const;

  Rational operator()(const Rational& t) const;
  RationalPolynomial derivative() const;
  /// p(origin + length t).
  RationalPolynomial on_interval(const Rational& origin, const Rational& length) const;
  /// The polynomial divided by t - root as often as that is exact.
  RationalPolynomial without_root(const Rational& root) const;

  RationalPolynomial& operator+=(const RationalPolynomial& other);
  RationalPolynomial& operator-=(const RationalPolynomial& other);
  RationalPolynomial& operator*=(const RationalPolynomial& other);
  RationalPolynomial operator-() const;
  friend RationalPolynomial operator+(RationalPolynomial a, const RationalPolynomial& b) {
    return a += b;
  }
  friend RationalPolynomial operator-(RationalPolynomial a, const RationalPolynomial& b) {
    return a -= b;
  }
  friend RationalPolynomial operator*(RationalPolynomial a, const RationalPolynomial& b) {
    return a *= b;
  }
  friend bool operator==(const RationalPolynomial& a, const RationalPolynomial& b) {
    return fmpq_poly_equal(a.value_, b.value_) != 0;
  }
  friend bool operator!=(const RationalPolynomial& a, const RationalPolynomial& b) {
    return !(a == b);
  }

  /// FLINT's representation, for the algebra layer only.
  fmpq_poly_struct* flint() { return value_; }
  const fmpq_poly_struct* flint() const { return value_; }

 private:
  fmpq_poly_t value_;
};

/// Monic greatest common divisor; zero when both are zero.
RationalPolynomial gcd(const RationalPolynomial& a, const RationalPolynomial& b);

/// a x + b y = gcd, the monic greatest common divisor of a and b, which are not both zero.
struct BezoutIdentity {
  RationalPolynomial gcd, x, y;
};
BezoutIdentity extended_gcd(const RationalPolynomial& a, const RationalPolynomial& b);

/// a modulo b. Throws std::domain_error when b is zero.
RationalPolynomial remainder(const RationalPolynomial& a, const RationalPolynomial& b);

/// a / b when b divides a. Throws std::domain_error otherwise.
RationalPolynomial exact_quotient(const RationalPolynomial& a, const RationalPolynomial& b);

/// A monic squarefree factor and its multiplicity.
struct SquarefreeFactor {
  RationalPolynomial factor;
  int multiplicity;
};

/// p = constant * product of factor^multiplicity: the factors are coprime, squarefree, not
/// constant.
std::vector<SquarefreeFactor> squarefree_factorization(const RationalPolynomial& p);

/// The monic irreducible factors over Q of a squarefree polynomial, by degree.
std::vector<RationalPolynomial> irreducible_factors(const RationalPolynomial& squarefree);

/// The positive rational number by which the coefficients are coprime integers times it; zero for
/// the zero polynomial.
Rational content(const RationalPolynomial& p);

/// t^exponent.
RationalPolynomial power_of_t(int exponent);

/// Coefficients 0 .. degree in ascending order; degree >= p.degree().
std::vector<Rational> coefficients(const RationalPolynomial& p, int degree);

}  // namespace pn
