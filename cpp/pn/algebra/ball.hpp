// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls: real and complex numbers known up to a proven error (midpoint and radius).
//
// Contract (F. Johansson, Arb: efficient arbitrary-precision midpoint-radius interval arithmetic,
// IEEE Trans. Comput. 66, 2017): the result of an operation contains the exact result for every
// choice of numbers in its operands. A ball carries the precision it is computed at, in bits; an
// operation works at the larger precision of its operands. Integers, doubles and default values are
// exact and carry the least precision.
#pragma once

#include <acb.h>
#include <arb.h>

#include <algorithm>
#include <complex>
#include <optional>
#include <vector>

#include "pn/algebra/rational.hpp"

namespace pn {

class RealBall {
 public:
  /// An exact number needs no precision of its own; the floor keeps operations among them sensible.
  static constexpr long kFloor = 64;

  RealBall() { arb_init(value_); }
  RealBall(long exact) : RealBall() { arb_set_si(value_, exact); }
  RealBall(double exact) : RealBall() { arb_set_d(value_, exact); }
  RealBall(int exact) : RealBall(static_cast<long>(exact)) {}
  RealBall(const Rational& x, long precision) : precision_(precision) {
    arb_init(value_);
    arb_set_fmpq(value_, x.flint(), precision);
  }
  /// The ball of all numbers between two doubles, low <= high.
  static RealBall between(double low, double high, long precision);

  RealBall(const RealBall& other) : precision_(other.precision_) {
    arb_init(value_);
    arb_set(value_, other.value_);
  }
  RealBall(RealBall&& other) noexcept : precision_(other.precision_) {
    arb_init(value_);
    arb_swap(value_, other.value_);
  }
  RealBall& operator=(const RealBall& other) {
    arb_set(value_, other.value_);
    precision_ = other.precision_;
    return *this;
  }
  RealBall& operator=(RealBall&& other) noexcept {
    arb_swap(value_, other.value_);
    precision_ = other.precision_;
    return *this;
  }
  ~RealBall() { arb_clear(value_); }

  long precision() const { return precision_; }
  /// The same ball, to be computed with at this precision.
  RealBall at_precision(long bits) const;

  RealBall& operator+=(const RealBall& b) {
    precision_ = std::max(precision_, b.precision_);
    arb_add(value_, value_, b.value_, precision_);
    return *this;
  }
  RealBall& operator-=(const RealBall& b) {
    precision_ = std::max(precision_, b.precision_);
    arb_sub(value_, value_, b.value_, precision_);
    return *this;
  }
  RealBall& operator*=(const RealBall& b) {
    precision_ = std::max(precision_, b.precision_);
    arb_mul(value_, value_, b.value_, precision_);
    return *this;
  }
  RealBall& operator/=(const RealBall& b) {
    precision_ = std::max(precision_, b.precision_);
    arb_div(value_, value_, b.value_, precision_);
    return *this;
  }
  /// *this += a b
  RealBall& add_product(const RealBall& a, const RealBall& b) {
    precision_ = std::max({precision_, a.precision_, b.precision_});
    arb_addmul(value_, a.value_, b.value_, precision_);
    return *this;
  }
  RealBall operator-() const {
    RealBall result;
    result.precision_ = precision_;
    arb_neg(result.value_, value_);
    return result;
  }
  friend RealBall operator+(const RealBall& a, const RealBall& b) {
    RealBall result;
    result.precision_ = std::max(a.precision_, b.precision_);
    arb_add(result.value_, a.value_, b.value_, result.precision_);
    return result;
  }
  friend RealBall operator-(const RealBall& a, const RealBall& b) {
    RealBall result;
    result.precision_ = std::max(a.precision_, b.precision_);
    arb_sub(result.value_, a.value_, b.value_, result.precision_);
    return result;
  }
  friend RealBall operator*(const RealBall& a, const RealBall& b) {
    RealBall result;
    result.precision_ = std::max(a.precision_, b.precision_);
    arb_mul(result.value_, a.value_, b.value_, result.precision_);
    return result;
  }
  friend RealBall operator/(const RealBall& a, const RealBall& b) {
    RealBall result;
    result.precision_ = std::max(a.precision_, b.precision_);
    arb_div(result.value_, a.value_, b.value_, result.precision_);
    return result;
  }

  /// Every number of the ball is > 0 (< 0).
  bool is_positive() const { return arb_is_positive(value_) != 0; }
  bool is_negative() const { return arb_is_negative(value_) != 0; }
  bool contains_zero() const { return arb_contains_zero(value_) != 0; }
  /// The ball is the single number zero.
  bool is_zero() const { return arb_is_zero(value_) != 0; }
  bool is_finite() const { return arb_is_finite(value_) != 0; }
  bool contains(const Rational& x) const { return arb_contains_fmpq(value_, x.flint()) != 0; }
  bool overlaps(const RealBall& other) const { return arb_overlaps(value_, other.value_) != 0; }

  /// A double near the midpoint; says nothing about the radius.
  double midpoint() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }
  /// Doubles that bound the numbers of the ball from below and above.
  double lower() const;
  double upper() const;
  /// A double that no |x| of the ball exceeds.
  double magnitude_upper() const;

  /// The double nearest to the midpoint when every number of the ball is within one unit in its
  /// last place of it; nothing when the ball is too wide for that.
  std::optional<double> rounded() const;
  /// A double that bounds how far the numbers of the ball are from the one nearest to the midpoint.
  double rounding_error() const;

  arb_struct* arb() { return value_; }
  const arb_struct* arb() const { return value_; }
  /// For results computed through arb(): the precision they carry from here on.
  void set_precision(long bits) { precision_ = bits; }

 private:
  friend class ComplexBall;
  arb_t value_;
  long precision_ = kFloor;
};

/// The non-negative square root; a ball that reaches below zero gives the roots of its other
/// numbers.
RealBall sqrt(const RealBall& x);
RealBall abs(const RealBall& x);
/// x 2^exponent, exactly.
RealBall scaled(const RealBall& x, long exponent);
/// The numbers times the power of two with which the largest midpoint is in [1/2, 1): homogeneous
/// coordinates that may be too large for doubles.
std::vector<RealBall> normalized(std::vector<RealBall> numbers);

class ComplexBall {
 public:
  ComplexBall() { acb_init(value_); }
  ComplexBall(const RealBall& real) : precision_(real.precision_) {
    acb_init(value_);
    arb_set(acb_realref(value_), real.value_);
  }
  ComplexBall(double exact) : ComplexBall(RealBall(exact)) {}
  ComplexBall(const RealBall& real, const RealBall& imaginary)
      : precision_(std::max(real.precision_, imaginary.precision_)) {
    acb_init(value_);
    arb_set(acb_realref(value_), real.value_);
    arb_set(acb_imagref(value_), imaginary.value_);
  }
  ComplexBall(const ComplexBall& other) : precision_(other.precision_) {
    acb_init(value_);
    acb_set(value_, other.value_);
  }
  ComplexBall(ComplexBall&& other) noexcept : precision_(other.precision_) {
    acb_init(value_);
    acb_swap(value_, other.value_);
  }
  ComplexBall& operator=(const ComplexBall& other) {
    acb_set(value_, other.value_);
    precision_ = other.precision_;
    return *this;
  }
  ComplexBall& operator=(ComplexBall&& other) noexcept {
    acb_swap(value_, other.value_);
    precision_ = other.precision_;
    return *this;
  }
  ~ComplexBall() { acb_clear(value_); }

  long precision() const { return precision_; }
  RealBall real() const;
  RealBall imag() const;

  ComplexBall& operator+=(const ComplexBall& b) {
    precision_ = std::max(precision_, b.precision_);
    acb_add(value_, value_, b.value_, precision_);
    return *this;
  }
  ComplexBall& operator-=(const ComplexBall& b) {
    precision_ = std::max(precision_, b.precision_);
    acb_sub(value_, value_, b.value_, precision_);
    return *this;
  }
  ComplexBall& operator*=(const ComplexBall& b) {
    precision_ = std::max(precision_, b.precision_);
    acb_mul(value_, value_, b.value_, precision_);
    return *this;
  }
  ComplexBall& operator/=(const ComplexBall& b) {
    precision_ = std::max(precision_, b.precision_);
    acb_div(value_, value_, b.value_, precision_);
    return *this;
  }
  /// *this += a b
  ComplexBall& add_product(const ComplexBall& a, const ComplexBall& b) {
    precision_ = std::max({precision_, a.precision_, b.precision_});
    acb_addmul(value_, a.value_, b.value_, precision_);
    return *this;
  }
  ComplexBall operator-() const {
    ComplexBall result;
    result.precision_ = precision_;
    acb_neg(result.value_, value_);
    return result;
  }
  friend ComplexBall operator+(ComplexBall a, const ComplexBall& b) { return std::move(a += b); }
  friend ComplexBall operator-(ComplexBall a, const ComplexBall& b) { return std::move(a -= b); }
  friend ComplexBall operator*(const ComplexBall& a, const ComplexBall& b) {
    ComplexBall result;
    result.precision_ = std::max(a.precision_, b.precision_);
    acb_mul(result.value_, a.value_, b.value_, result.precision_);
    return result;
  }
  friend ComplexBall operator/(const ComplexBall& a, const ComplexBall& b) {
    ComplexBall result;
    result.precision_ = std::max(a.precision_, b.precision_);
    acb_div(result.value_, a.value_, b.value_, result.precision_);
    return result;
  }
  friend ComplexBall conj(const ComplexBall& a) {
    ComplexBall result;
    result.precision_ = a.precision_;
    acb_conj(result.value_, a.value_);
    return result;
  }

  bool contains_zero() const { return acb_contains_zero(value_) != 0; }
  bool is_zero() const { return acb_is_zero(value_) != 0; }
  std::complex<double> midpoint() const {
    return {arf_get_d(arb_midref(acb_realref(value_)), ARF_RND_NEAR),
            arf_get_d(arb_midref(acb_imagref(value_)), ARF_RND_NEAR)};
  }

  acb_struct* acb() { return value_; }
  const acb_struct* acb() const { return value_; }
  /// For results computed through acb(): the precision they carry from here on.
  void set_precision(long bits) { precision_ = bits; }

 private:
  acb_t value_;
  long precision_ = RealBall::kFloor;
};

/// The principal square root.
ComplexBall sqrt(const ComplexBall& z);

/// a_0 b_0 + a_1 b_1 + ..., rounded seldom: several times as fast as term by term. (F. Johansson,
/// Faster arbitrary-precision dot product and matrix multiplication, ARITH 26, 2019.)
RealBall dot(const std::vector<RealBall>& a, const std::vector<RealBall>& b);

/// sum_k += a_0 b_k + a_1 b_(k-1) + ... + a_k b_0, rounded likewise: a product of polynomials, or
/// as many of its coefficients as the sum has. Neither factor is empty.
void add_product(std::vector<RealBall>& sum, const std::vector<RealBall>& a,
                 const std::vector<RealBall>& b);
void add_product(std::vector<ComplexBall>& sum, const std::vector<ComplexBall>& a,
                 const std::vector<ComplexBall>& b);

}  // namespace pn
