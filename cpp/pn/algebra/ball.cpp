// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/ball.hpp"

#include <acb.h>

#include <cmath>
#include <limits>

namespace pn {
namespace {

constexpr long kWordPrecision = DoubleWordBall::kPrecision;

/// One of Arb's floating-point numbers.
class ArbFloat {
 public:
  ArbFloat() { arf_init(value_); }
  ArbFloat(const ArbFloat&) = delete;
  ArbFloat& operator=(const ArbFloat&) = delete;
  ~ArbFloat() { arf_clear(value_); }
  arf_struct* get() { return value_; }

 private:
  arf_t value_;
};

std::optional<DoubleWordBall> in_double_words(const arb_struct* x) {
  const double high = arf_get_d(arb_midref(x), ARF_RND_NEAR);
  if (!double_word::is_in_range(high) || !arb_is_finite(x)) return std::nullopt;
  ArbFloat rest, part;
  arf_set_d(part.get(), high);
  arf_sub(rest.get(), arb_midref(x), part.get(), ARF_PREC_EXACT, ARF_RND_DOWN);
  const double low = arf_get_d(rest.get(), ARF_RND_NEAR);
  arf_set_d(part.get(), low);
  arf_sub(rest.get(), rest.get(), part.get(), ARF_PREC_EXACT, ARF_RND_DOWN);
  arf_abs(rest.get(), rest.get());
  ArbFloat radius;
  arf_set_mag(radius.get(), arb_radref(x));
  arf_add(radius.get(), radius.get(), rest.get(), ARF_PREC_EXACT, ARF_RND_UP);
  return double_word::in_range({high, low, arf_get_d(radius.get(), ARF_RND_UP)});
}

ArbBall in_arb(const DoubleWordBall& x) {
  ArbBall result;
  arf_set_d(arb_midref(result.get()), x.high);
  if (x.low != 0) {
    ArbFloat low;
    arf_set_d(low.get(), x.low);
    arf_add(arb_midref(result.get()), arb_midref(result.get()), low.get(), ARF_PREC_EXACT,
            ARF_RND_DOWN);
  }
  mag_set_d(arb_radref(result.get()), x.radius);
  return result;
}

/// The double of an integer of at most 53 bits.
std::optional<double> short_integer(const fmpz_t x) {
  constexpr slong kMantissaBits = 53;
  if (COEFF_IS_MPZ(*x) || fmpz_bits(x) > kMantissaBits) return std::nullopt;
  return static_cast<double>(*x);
}

std::optional<DoubleWordBall> in_double_words(const Rational& x) {
  const auto numerator = short_integer(fmpq_numref(x.flint()));
  const auto denominator = short_integer(fmpq_denref(x.flint()));
  if (!numerator || !denominator) return std::nullopt;
  return quotient({*numerator, 0, 0}, {*denominator, 0, 0});
}

/// Half a unit in the last place of a double, x not zero, is 2^ to this power.
int half_unit_bits(double x) {
  constexpr int kMantissaBits = 53;
  return std::ilogb(x) - kMantissaBits;
}

double half_unit(double x) { return x == 0 ? 0 : std::ldexp(1.0, half_unit_bits(x)); }

/// The double at or beyond a bound that one of Arb's functions gives for a ball.
template <class Bound>
double rounded_bound(Bound bound_of, const arb_struct* x, long precision, arf_rnd_t direction) {
  ArbFloat bound;
  bound_of(bound.get(), x, precision);
  return arf_get_d(bound.get(), direction);
}

}  // namespace

RealBall::RealBall(ArbBall x, long precision) : value_(std::move(x)), precision_(precision) {
  shorten();
}

RealBall::RealBall(const Rational& x, long precision) : precision_(precision) {
  const auto words = precision <= kWordPrecision ? in_double_words(x) : std::nullopt;
  if (words) {
    value_ = *words;
  } else {
    arb_set_fmpq(in_place(), x.flint(), precision);
    shorten();
  }
}

RealBall::RealBall(long exact) {
  arb_set_si(in_place(), exact);
  shorten();
}

RealBall::RealBall(double exact) {
  if (double_word::is_in_range(exact)) {
    value_ = DoubleWordBall{exact, 0, 0};
  } else {
    arb_set_d(in_place(), exact);
  }
}

RealBall RealBall::between(double low, double high, long precision) {
  ArbBall ball;
  ArbFloat a, b;
  arf_set_d(a.get(), low);
  arf_set_d(b.get(), high);
  arb_set_interval_arf(ball.get(), a.get(), b.get(), precision);
  return RealBall(std::move(ball), precision);
}

ArbBall RealBall::arb() const { return words() ? in_arb(*words()) : std::get<ArbBall>(value_); }

arb_struct* RealBall::in_place() {
  if (const DoubleWordBall* short_ball = words()) value_ = in_arb(*short_ball);
  return std::get_if<ArbBall>(&value_)->get();
}

void RealBall::shorten() {
  if (words() || precision_ > kWordPrecision) return;
  if (const auto short_ball = in_double_words(long_ball())) value_ = *short_ball;
}

namespace {

/// A ball as Arb has it, lent where it is one of Arb's already.
class ArbOperand {
 public:
  explicit ArbOperand(const RealBall& x)
      : own_(x.words() ? in_arb(*x.words()) : ArbBall()),
        ball_(x.words() ? own_.get() : x.long_ball()) {}
  ArbOperand(const ArbOperand&) = delete;
  ArbOperand& operator=(const ArbOperand&) = delete;
  const arb_struct* get() const { return ball_; }

 private:
  ArbBall own_;
  const arb_struct* ball_;
};

}  // namespace

RealBall& RealBall::set_in_arb(const RealBall& a, const RealBall& b, OnArb& function) {
  const long precision = std::max(a.precision_, b.precision_);
  const ArbOperand x(a), y(b);
  arb_struct* result = words() ? value_.emplace<ArbBall>().get() : in_place();
  function(result, x.get(), y.get(), precision);
  precision_ = precision;
  shorten();
  return *this;
}

RealBall RealBall::at_precision(long bits) const {
  RealBall result = *this;
  result.precision_ = bits;
  if (bits > kWordPrecision) result.in_place();
  return result;
}

PN_WITH_FUSED_MULTIPLY_ADD
RealBall& RealBall::operator*=(const RealBall& b) { return set<product>(*this, b, arb_mul); }

PN_WITH_FUSED_MULTIPLY_ADD
RealBall& RealBall::operator/=(const RealBall& b) { return set<quotient>(*this, b, arb_div); }

PN_WITH_FUSED_MULTIPLY_ADD
RealBall operator*(const RealBall& a, const RealBall& b) {
  RealBall result;
  result.set<product>(a, b, arb_mul);
  return result;
}

PN_WITH_FUSED_MULTIPLY_ADD
RealBall operator/(const RealBall& a, const RealBall& b) {
  RealBall result;
  result.set<quotient>(a, b, arb_div);
  return result;
}

PN_WITH_FUSED_MULTIPLY_ADD
RealBall& RealBall::add_product(const RealBall& a, const RealBall& b) {
  if (words() && a.words() && b.words()) {
    DoubleWordSum sum(*words());
    sum.add_product(*a.words(), *b.words());
    if (const auto result = sum.result()) {
      precision_ = std::max({precision_, a.precision_, b.precision_});
      value_ = *result;
      return *this;
    }
  }
  return add_product_in_arb(a, b);
}

RealBall& RealBall::add_product_in_arb(const RealBall& a, const RealBall& b) {
  const ArbOperand x(a), y(b);
  precision_ = std::max({precision_, a.precision_, b.precision_});
  arb_addmul(in_place(), x.get(), y.get(), precision_);
  shorten();
  return *this;
}

RealBall RealBall::operator-() const {
  if (words()) return RealBall(-*words(), precision_);
  RealBall result = *this;
  arb_neg(result.in_place(), long_ball());
  return result;
}

bool RealBall::is_positive() const {
  return words() ? words()->is_positive() : arb_is_positive(long_ball()) != 0;
}

bool RealBall::is_negative() const {
  return words() ? words()->is_negative() : arb_is_negative(long_ball()) != 0;
}

bool RealBall::contains_zero() const {
  return words() ? !words()->is_positive() && !words()->is_negative()
                 : arb_contains_zero(long_ball()) != 0;
}

bool RealBall::contains(const Rational& x) const {
  return arb_contains_fmpq(ArbOperand(*this).get(), x.flint()) != 0;
}

bool RealBall::overlaps(const RealBall& other) const {
  return arb_overlaps(ArbOperand(*this).get(), ArbOperand(other).get()) != 0;
}

double RealBall::midpoint() const {
  return words() ? words()->high : arf_get_d(arb_midref(long_ball()), ARF_RND_NEAR);
}

Rational RealBall::exact_midpoint() const {
  Rational result;
  arf_get_fmpq(result.flint(), arb_midref(ArbOperand(*this).get()));
  return result;
}

RealBall RealBall::centre() const {
  if (words()) return RealBall(DoubleWordBall{words()->high, words()->low, 0}, precision_);
  RealBall result = *this;
  mag_zero(arb_radref(result.in_place()));
  return result;
}

double RealBall::radius() const {
  return words() ? words()->radius : mag_get_d(arb_radref(long_ball()));
}

double RealBall::lower() const {
  if (words()) return words()->lower();
  return rounded_bound(arb_get_lbound_arf, long_ball(), precision_, ARF_RND_FLOOR);
}

double RealBall::upper() const {
  if (words()) return words()->upper();
  return rounded_bound(arb_get_ubound_arf, long_ball(), precision_, ARF_RND_CEIL);
}

double RealBall::magnitude_upper() const {
  if (words()) return std::max(-words()->lower(), words()->upper());
  return rounded_bound(arb_get_abs_ubound_arf, long_ball(), precision_, ARF_RND_CEIL);
}

std::optional<double> RealBall::rounded() const {
  // At most half of half a unit in the last place: the common case.
  constexpr double kCertainlyNarrow = 0x1p-54;
  if (words() && words()->radius <= std::abs(words()->high) * kCertainlyNarrow) {
    return words()->high;
  }
  const double nearest = midpoint();
  if (!std::isfinite(nearest)) return std::nullopt;
  if (radius() == 0) return nearest;
  if (nearest == 0) return std::nullopt;
  // The midpoint is at most half a unit in the last place away, so the radius may be the other
  // half.
  const bool narrow = words()
                          ? words()->radius <= half_unit(nearest)
                          : mag_cmp_2exp_si(arb_radref(long_ball()), half_unit_bits(nearest)) <= 0;
  return narrow ? std::optional<double>(nearest) : std::nullopt;
}

double RealBall::rounding_error() const {
  const double nearest = midpoint(), least = std::numeric_limits<double>::denorm_min();
  const double to_midpoint = words() ? std::abs(words()->low) : half_unit(nearest);
  // The radius has fewer bits than a double, which can only be too small to hold it. The two units
  // more are for that and for the sum.
  return std::nextafter(to_midpoint + radius() + least, std::numeric_limits<double>::infinity());
}

PN_WITH_FUSED_MULTIPLY_ADD
RealBall sqrt(const RealBall& x) {
  if (x.words()) {
    if (const auto words = root(*x.words())) return RealBall(*words, x.precision());
  }
  ArbBall result;
  arb_sqrtpos(result.get(), ArbOperand(x).get(), x.precision());
  return RealBall(std::move(result), x.precision());
}

RealBall abs(const RealBall& x) { return x.midpoint() < 0 ? -x : x; }

RealBall scaled(const RealBall& x, long exponent) {
  // Powers of two within the range of double words.
  constexpr long kLargestExponent = 400;
  if (x.words() && std::abs(exponent) <= kLargestExponent) {
    return x * RealBall(std::ldexp(1.0, static_cast<int>(exponent)));
  }
  ArbBall result;
  arb_mul_2exp_si(result.get(), ArbOperand(x).get(), exponent);
  return RealBall(std::move(result), x.precision());
}

PN_WITH_FUSED_MULTIPLY_ADD
ComplexBall& ComplexBall::add_product(const ComplexBall& a, const ComplexBall& b) {
  const DoubleWordBall *x = a.real_.words(), *y = a.imag_.words(), *u = b.real_.words(),
                       *v = b.imag_.words();
  if (real_.words() && imag_.words() && x && y && u && v) {
    DoubleWordSum real(*real_.words()), imag(*imag_.words());
    real.add_product(*x, *u);
    real.add_product(-*y, *v);
    imag.add_product(*x, *v);
    imag.add_product(*y, *u);
    const auto re = real.result(), im = imag.result();
    if (re && im) {
      const long bits = std::max({precision(), a.precision(), b.precision()});
      real_ = RealBall(*re, bits);
      imag_ = RealBall(*im, bits);
      return *this;
    }
  }
  return add_product_in_parts(a, b);
}

ComplexBall& ComplexBall::add_product_in_parts(const ComplexBall& a, const ComplexBall& b) {
  const RealBall imag = RealBall(imag_).add_product(a.real_, b.imag_).add_product(a.imag_, b.real_);
  real_ = RealBall(real_).add_product(a.real_, b.real_).add_product(-a.imag_, b.imag_);
  imag_ = imag;
  return *this;
}

ComplexBall sqrt(const ComplexBall& z) {
  acb_t root;
  acb_init(root);
  acb_set_arb_arb(root, z.real().arb().get(), z.imag().arb().get());
  acb_sqrt(root, root, z.precision());
  ArbBall real, imaginary;
  arb_swap(real.get(), acb_realref(root));
  arb_swap(imaginary.get(), acb_imagref(root));
  acb_clear(root);
  return {RealBall(std::move(real), z.precision()), RealBall(std::move(imaginary), z.precision())};
}

}  // namespace pn
