// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls: real and complex numbers known up to a proven error (midpoint and radius).
//
// Contract (F. Johansson, Arb: efficient arbitrary-precision midpoint-radius interval arithmetic,
// IEEE Trans. Comput. 66, 2017): the result of an operation contains the exact result for every
// choice of numbers in its operands. A ball carries the precision it is computed at, in bits; an
// operation works at the larger precision of its operands. Integers, doubles and default values are
// exact and carry the least precision.
//
// Balls of few bits are double words, those of more bits and beyond their range Arb's.
#pragma once

#include <arb.h>

#include <algorithm>
#include <complex>
#include <optional>
#include <utility>
#include <variant>

#include "pn/algebra/double_word_ball.hpp"
#include "pn/algebra/rational.hpp"

namespace pn {

/// A ball of any length and size: the owner of one of Arb's numbers.
class ArbBall {
 public:
  ArbBall() { arb_init(value_); }
  ArbBall(const ArbBall& other) : ArbBall() { arb_set(value_, other.value_); }
  ArbBall(ArbBall&& other) noexcept : ArbBall() { arb_swap(value_, other.value_); }
  ArbBall& operator=(ArbBall other) noexcept {
    arb_swap(value_, other.value_);
    return *this;
  }
  ~ArbBall() { arb_clear(value_); }

  arb_struct* get() { return value_; }
  const arb_struct* get() const { return value_; }

 private:
  arb_t value_;
};

class RealBall {
 public:
  /// An exact number needs no precision of its own; the floor keeps operations among them sensible.
  static constexpr long kFloor = 64;

  RealBall() = default;
  RealBall(long exact);
  RealBall(double exact);
  RealBall(int exact) : value_(DoubleWordBall{static_cast<double>(exact), 0, 0}) {}
  RealBall(const Rational& x, long precision);
  RealBall(ArbBall x, long precision);
  RealBall(const DoubleWordBall& words, long precision) : value_(words), precision_(precision) {}
  /// The ball of all numbers between two doubles, low <= high.
  static RealBall between(double low, double high, long precision);

  long precision() const { return precision_; }
  /// The same ball, to be computed with at this precision.
  RealBall at_precision(long bits) const;

  RealBall& operator+=(const RealBall& b) { return set<sum>(*this, b, arb_add); }
  RealBall& operator-=(const RealBall& b) { return set<difference>(*this, b, arb_sub); }
  RealBall& operator*=(const RealBall& b);
  RealBall& operator/=(const RealBall& b);
  /// *this += a b
  RealBall& add_product(const RealBall& a, const RealBall& b);
  RealBall operator-() const;
  friend RealBall operator+(const RealBall& a, const RealBall& b) {
    RealBall result;
    result.set<sum>(a, b, arb_add);
    return result;
  }
  friend RealBall operator-(const RealBall& a, const RealBall& b) {
    RealBall result;
    result.set<difference>(a, b, arb_sub);
    return result;
  }
  friend RealBall operator*(const RealBall& a, const RealBall& b);
  friend RealBall operator/(const RealBall& a, const RealBall& b);

  /// Every number of the ball is > 0 (< 0).
  bool is_positive() const;
  bool is_negative() const;
  bool contains_zero() const;
  /// The ball is the single number zero.
  bool is_zero() const { return words() ? words()->is_zero() : arb_is_zero(long_ball()) != 0; }
  bool is_finite() const { return words() || arb_is_finite(long_ball()) != 0; }
  bool contains(const Rational& x) const;
  bool overlaps(const RealBall& other) const;

  /// A double near the midpoint; says nothing about the radius.
  double midpoint() const;
  /// The midpoint itself, of a finite ball.
  Rational exact_midpoint() const;
  /// The ball of the midpoint alone.
  RealBall centre() const;
  /// A double that bounds how far the numbers of the ball are from the exact midpoint.
  double radius() const;
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

  /// The ball in double words, or nothing: one of a higher precision, or beyond their range.
  const DoubleWordBall* words() const { return std::get_if<DoubleWordBall>(&value_); }
  /// The ball as Arb has it.
  ArbBall arb() const;
  /// That without a copy, of a ball that has no double words.
  const arb_struct* long_ball() const { return std::get_if<ArbBall>(&value_)->get(); }

 private:
  using OnDoubleWords = std::optional<DoubleWordBall>(const DoubleWordBall&, const DoubleWordBall&);
  using OnArb = void(arb_t, const arb_t, const arb_t, slong);

  /// By the first function where operands and result are double words, else by the second.
  template <OnDoubleWords& short_result>
  RealBall& set(const RealBall& a, const RealBall& b, OnArb& long_result) {
    if (a.words() && b.words()) {
      if (const auto words = short_result(*a.words(), *b.words())) {
        precision_ = std::max(a.precision_, b.precision_);
        value_ = *words;
        return *this;
      }
    }
    return set_in_arb(a, b, long_result);
  }
  RealBall& add_product_in_arb(const RealBall& a, const RealBall& b);
  RealBall& set_in_arb(const RealBall& a, const RealBall& b, OnArb& function);

  /// The ball as one of Arb's from here on, to be computed in place.
  arb_struct* in_place();
  /// In double words again where they have the precision and the range.
  void shorten();

  std::variant<DoubleWordBall, ArbBall> value_;
  long precision_ = kFloor;
};

/// The non-negative square root; a ball that reaches below zero gives the roots of its other
/// numbers.
RealBall sqrt(const RealBall& x);
RealBall abs(const RealBall& x);
/// x 2^exponent, exactly.
RealBall scaled(const RealBall& x, long exponent);

class ComplexBall {
 public:
  ComplexBall() = default;
  ComplexBall(RealBall real) : ComplexBall(std::move(real), RealBall()) {}
  ComplexBall(double exact) : real_(exact) {}
  ComplexBall(std::complex<double> exact) : real_(exact.real()), imag_(exact.imag()) {}
  ComplexBall(RealBall real, RealBall imaginary)
      : real_(std::move(real)), imag_(std::move(imaginary)) {
    if (real_.precision() < imag_.precision()) real_ = real_.at_precision(imag_.precision());
    if (imag_.precision() < real_.precision()) imag_ = imag_.at_precision(real_.precision());
  }

  long precision() const { return real_.precision(); }
  const RealBall& real() const { return real_; }
  const RealBall& imag() const { return imag_; }

  ComplexBall& operator+=(const ComplexBall& b) {
    real_ += b.real_;
    imag_ += b.imag_;
    return *this;
  }
  ComplexBall& operator-=(const ComplexBall& b) {
    real_ -= b.real_;
    imag_ -= b.imag_;
    return *this;
  }
  ComplexBall& operator*=(const ComplexBall& b) { return *this = *this * b; }
  ComplexBall& operator/=(const ComplexBall& b) { return *this = *this / b; }
  /// *this += a b
  ComplexBall& add_product(const ComplexBall& a, const ComplexBall& b);
  ComplexBall operator-() const { return {-real_, -imag_}; }
  friend ComplexBall operator+(ComplexBall a, const ComplexBall& b) { return std::move(a += b); }
  friend ComplexBall operator-(ComplexBall a, const ComplexBall& b) { return std::move(a -= b); }
  friend ComplexBall operator*(const ComplexBall& a, const ComplexBall& b) {
    return ComplexBall().add_product(a, b);
  }
  friend ComplexBall operator/(const ComplexBall& a, const ComplexBall& b) {
    const RealBall inverse = RealBall(1) / (b.real_ * b.real_ + b.imag_ * b.imag_);
    return {(a.real_ * b.real_ + a.imag_ * b.imag_) * inverse,
            (a.imag_ * b.real_ - a.real_ * b.imag_) * inverse};
  }
  friend ComplexBall conj(const ComplexBall& a) { return {a.real_, -a.imag_}; }

  bool contains_zero() const { return real_.contains_zero() && imag_.contains_zero(); }
  bool is_zero() const { return real_.is_zero() && imag_.is_zero(); }
  std::complex<double> midpoint() const { return {real_.midpoint(), imag_.midpoint()}; }

 private:
  ComplexBall& add_product_in_parts(const ComplexBall& a, const ComplexBall& b);

  RealBall real_, imag_;  ///< of one precision
};

/// The principal square root.
ComplexBall sqrt(const ComplexBall& z);

}  // namespace pn
