// SPDX-License-Identifier: LGPL-2.1-or-later
// The field Q: exact rational numbers.
//
// Contract: every operation is exact. An IEEE double is the rational number it stands for, so a
// designer's input enters without rounding.
#pragma once

#include <flint/fmpq.h>

#include <optional>

namespace pn {

class Rational {
 public:
  Rational() { fmpq_init(value_); }
  Rational(long integer) : Rational() { fmpq_set_si(value_, integer, 1); }
  Rational(const Rational& other) : Rational() { fmpq_set(value_, other.value_); }
  Rational(Rational&& other) noexcept : Rational() { fmpq_swap(value_, other.value_); }
  Rational& operator=(Rational other) noexcept {
    fmpq_swap(value_, other.value_);
    return *this;
  }
  ~Rational() { fmpq_clear(value_); }

  /// The rational number that a finite double is. Throws std::domain_error for NaN and infinity.
  static Rational exactly(double x);

  /// The nearest double.
  double to_double() const;
  int sign() const { return fmpq_sgn(value_); }
  bool is_zero() const { return fmpq_is_zero(value_) != 0; }

  Rational& operator+=(const Rational& other) {
    fmpq_add(value_, value_, other.value_);
    return *this;
  }
  Rational& operator-=(const Rational& other) {
    fmpq_sub(value_, value_, other.value_);
    return *this;
  }
  Rational& operator*=(const Rational& other) {
    fmpq_mul(value_, value_, other.value_);
    return *this;
  }
  /// Throws std::domain_error when `other` is zero.
  Rational& operator/=(const Rational& other);
  Rational operator-() const {
    Rational result;
    fmpq_neg(result.value_, value_);
    return result;
  }

  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend bool operator==(const Rational& a, const Rational& b) {
    return fmpq_equal(a.value_, b.value_) != 0;
  }
  friend bool operator!=(const Rational& a, const Rational& b) { return !(a == b); }
  friend bool operator<(const Rational& a, const Rational& b) {
    return fmpq_cmp(a.value_, b.value_) < 0;
  }
  friend bool operator>(const Rational& a, const Rational& b) { return b < a; }

  /// FLINT's representation, for the algebra layer only.
  fmpq* flint() { return value_; }
  const fmpq* flint() const { return value_; }

 private:
  fmpq_t value_;
};

/// The positive rational number of which a and b are coprime integer multiples; zero when both are.
Rational gcd(const Rational& a, const Rational& b);

/// The least positive integer n for which n a and n b are integers.
Rational common_denominator(const Rational& a, const Rational& b);

/// The root >= 0 of a rational square; nothing for other numbers.
std::optional<Rational> square_root(const Rational& x);

}  // namespace pn
