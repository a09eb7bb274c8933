// SPDX-License-Identifier: LGPL-2.1-or-later
// The ring Q[u, v]: exact polynomials in two variables.
//
// Contract: every operation is exact; degrees and common factors are decided, not estimated.
#pragma once

#include <flint/fmpq_mpoly.h>

#include <optional>
#include <vector>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

enum class Variable { kU, kV };

class BivariatePolynomial {
 public:
  BivariatePolynomial() { fmpq_mpoly_init(value_, ring()); }
  BivariatePolynomial(const Rational& constant);
  BivariatePolynomial(long constant) : BivariatePolynomial(Rational(constant)) {}
  /// coefficients[i][j] is that of u^i v^j.
  explicit BivariatePolynomial(const std::vector<std::vector<Rational>>& coefficients);
  /// p(u) or p(v).
  BivariatePolynomial(const RationalPolynomial& p, Variable variable);
  BivariatePolynomial(const BivariatePolynomial& other) : BivariatePolynomial() {
    fmpq_mpoly_set(value_, other.value_, ring());
  }
  BivariatePolynomial(BivariatePolynomial&& other) noexcept : BivariatePolynomial() {
    fmpq_mpoly_swap(value_, other.value_, ring());
  }
  BivariatePolynomial& operator=(BivariatePolynomial other) noexcept {
    fmpq_mpoly_swap(value_, other.value_, ring());
    return *this;
  }
  ~BivariatePolynomial() { fmpq_mpoly_clear(value_, ring()); }

  bool is_zero() const { return fmpq_mpoly_is_zero(value_, ring()) != 0; }
  /// -1 for the zero polynomial.
  int degree(Variable variable) const;
  /// That of u^i v^j.
  Rational coefficient(int i, int j) const;

  Rational operator()(const Rational& u, const Rational& v) const;
  BivariatePolynomial derivative(Variable variable) const;
  /// p(a, b): polynomials in place of u and v.
  BivariatePolynomial composed(const BivariatePolynomial& a, const BivariatePolynomial& b) const;

  BivariatePolynomial& operator+=(const BivariatePolynomial& other);
  BivariatePolynomial& operator-=(const BivariatePolynomial& other);
  BivariatePolynomial& operator*=(const BivariatePolynomial& other);
  BivariatePolynomial operator-() const;
  friend BivariatePolynomial operator+(BivariatePolynomial a, const BivariatePolynomial& b) {
    return a += b;
  }
  friend BivariatePolynomial operator-(BivariatePolynomial a, const BivariatePolynomial& b) {
    return a -= b;
  }
  friend BivariatePolynomial operator*(BivariatePolynomial a, const BivariatePolynomial& b) {
    return a *= b;
  }
  friend bool operator==(const BivariatePolynomial& a, const BivariatePolynomial& b) {
    return fmpq_mpoly_equal(a.value_, b.value_, ring()) != 0;
  }
  friend bool operator!=(const BivariatePolynomial& a, const BivariatePolynomial& b) {
    return !(a == b);
  }

  /// FLINT's representation, for the algebra layer only.
  static const fmpq_mpoly_ctx_struct* ring();
  fmpq_mpoly_struct* flint() { return value_; }
  const fmpq_mpoly_struct* flint() const { return value_; }

 private:
  fmpq_mpoly_t value_;
};

/// Greatest common divisor, with leading coefficient 1 in the lexicographic order; zero when both
/// are zero.
BivariatePolynomial gcd(const BivariatePolynomial& a, const BivariatePolynomial& b);

/// a / b, or nothing when b, which is not zero, does not divide a.
std::optional<BivariatePolynomial> quotient(const BivariatePolynomial& a,
                                            const BivariatePolynomial& b);

/// The coefficient of the first term in the lexicographic order; zero for the zero polynomial.
Rational leading_coefficient(const BivariatePolynomial& p);

/// A polynomial whose square is p, or nothing when p is no square over Q.
std::optional<BivariatePolynomial> square_root(const BivariatePolynomial& p);

}  // namespace pn
