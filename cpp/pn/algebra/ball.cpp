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
  ArbFloat low;
  arf_set_d(arb_midref(result.get()), x.high);
  arf_set_d(low.get(), x.low);
  arf_add(arb_midref(result.get()), arb_midref(result.get()), low.get(), ARF_PREC_EXACT,
          ARF_RND_DOWN);
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

/// Half a unit in the last place of a double.
double half_unit(double x) {
  constexpr int kMantissaBits = 53;
  return x == 0 ? 0 : std::ldexp(1.0, std::ilogb(x) - kMantissaBits);
}

/// The double at or beyond a bound that one of Arb's functions gives for a ball.
template <class Bound>
double rounded_bound(Bound bound_of, const ArbBall& x, long precision, arf_rnd_t direction) {
  ArbFloat bound;
  bound_of(bound.get(), x.get(), precision);
  return arf_get_d(bound.get(), direction);
}

}  // namespace

RealBall::RealBall(ArbBall x, long precision) : precision_(precision) {
  const auto words = precision <= kWordPrecision ? in_double_words(x.get()) : std::nullopt;
  if (words) {
    words_ = *words;
  } else {
    arb_ = std::make_unique<ArbBall>(std::move(x));
  }
}

RealBall::RealBall(const Rational& x, long precision) : precision_(precision) {
  const auto words = precision <= kWordPrecision ? in_double_words(x) : std::nullopt;
  if (words) {
    words_ = *words;
  } else {
    ArbBall ball;
    arb_set_fmpq(ball.get(), x.flint(), precision);
    *this = RealBall(std::move(ball), precision);
  }
}

RealBall::RealBall(long exact) {
  constexpr long kMantissaBits = 53, kMostOfDouble = 1L << kMantissaBits;
  if (std::abs(exact) <= kMostOfDouble) {
    words_.high = static_cast<double>(exact);
    return;
  }
  ArbBall ball;
  arb_set_si(ball.get(), exact);
  *this = RealBall(std::move(ball), kFloor);
}

RealBall RealBall::beyond_double_words(double exact) {
  ArbBall ball;
  arb_set_d(ball.get(), exact);
  return RealBall(std::move(ball), kFloor);
}

RealBall RealBall::between(double low, double high, long precision) {
  ArbBall ball;
  ArbFloat a, b;
  arf_set_d(a.get(), low);
  arf_set_d(b.get(), high);
  arb_set_interval_arf(ball.get(), a.get(), b.get(), precision);
  return RealBall(std::move(ball), precision);
}

ArbBall RealBall::arb() const { return arb_ ? *arb_ : pn::in_arb(words_); }

namespace {

/// A ball as Arb has it, lent where it is one of Arb's already.
class ArbOperand {
 public:
  ArbOperand(const ArbBall* ball, const DoubleWordBall& words)
      : own_(ball ? ArbBall() : in_arb(words)), ball_(ball ? ball->get() : own_.get()) {}
  ArbOperand(const ArbOperand&) = delete;
  ArbOperand& operator=(const ArbOperand&) = delete;
  const arb_struct* get() const { return ball_; }

 private:
  ArbBall own_;
  const arb_struct* ball_;
};

}  // namespace

RealBall RealBall::in_arb(const RealBall& a, const RealBall& b, OnArb& function) {
  const long precision = std::max(a.precision_, b.precision_);
  const ArbOperand x(a.arb_.get(), a.words_), y(b.arb_.get(), b.words_);
  ArbBall result;
  function(result.get(), x.get(), y.get(), precision);
  return RealBall(std::move(result), precision);
}

RealBall RealBall::at_precision(long bits) const {
  RealBall result = *this;
  result.precision_ = bits;
  if (!arb_ && bits > kWordPrecision) result.arb_ = std::make_unique<ArbBall>(arb());
  return result;
}

RealBall& RealBall::add_product(const RealBall& a, const RealBall& b) {
  const long precision = std::max({precision_, a.precision_, b.precision_});
  if (words() && a.words() && b.words()) {
    DoubleWordSum result(words_);
    result.add_product(a.words_, b.words_);
    if (const auto words = result.result()) return *this = RealBall(*words, precision);
  }
  const ArbOperand x(a.arb_.get(), a.words_), y(b.arb_.get(), b.words_);
  ArbBall result = arb();
  arb_addmul(result.get(), x.get(), y.get(), precision);
  return *this = RealBall(std::move(result), precision);
}

RealBall RealBall::operator-() const {
  if (!arb_) return RealBall(-words_, precision_);
  RealBall result = *this;
  arb_neg(result.arb_->get(), arb_->get());
  return result;
}

bool RealBall::is_positive() const {
  return arb_ ? arb_is_positive(arb_->get()) != 0 : words_.lower() > 0;
}

bool RealBall::is_negative() const {
  return arb_ ? arb_is_negative(arb_->get()) != 0 : words_.upper() < 0;
}

bool RealBall::contains_zero() const {
  return arb_ ? arb_contains_zero(arb_->get()) != 0 : words_.lower() <= 0 && words_.upper() >= 0;
}

bool RealBall::contains(const Rational& x) const {
  return arb_contains_fmpq(arb().get(), x.flint()) != 0;
}

bool RealBall::overlaps(const RealBall& other) const {
  return arb_overlaps(arb().get(), other.arb().get()) != 0;
}

double RealBall::arb_midpoint() const { return arf_get_d(arb_midref(arb_->get()), ARF_RND_NEAR); }

Rational RealBall::exact_midpoint() const {
  Rational result;
  arf_get_fmpq(result.flint(), arb_midref(arb().get()));
  return result;
}

double RealBall::radius() const {
  return arb_ ? mag_get_d(arb_radref(arb_->get())) : words_.radius;
}

double RealBall::lower() const {
  if (!arb_) return words_.lower();
  return rounded_bound(arb_get_lbound_arf, *arb_, precision_, ARF_RND_FLOOR);
}

double RealBall::upper() const {
  if (!arb_) return words_.upper();
  return rounded_bound(arb_get_ubound_arf, *arb_, precision_, ARF_RND_CEIL);
}

double RealBall::magnitude_upper() const {
  if (!arb_) return std::max(-words_.lower(), words_.upper());
  return rounded_bound(arb_get_abs_ubound_arf, *arb_, precision_, ARF_RND_CEIL);
}

std::optional<double> RealBall::rounded() const {
  const double nearest = midpoint();
  if (!std::isfinite(nearest)) return std::nullopt;
  if (radius() == 0) return nearest;
  if (nearest == 0) return std::nullopt;
  // The midpoint is at most half a unit in the last place away, so the radius may be the other
  // half.
  return radius() <= half_unit(nearest) ? std::optional<double>(nearest) : std::nullopt;
}

double RealBall::rounding_error() const {
  const double nearest = midpoint(), least = std::numeric_limits<double>::denorm_min();
  const double to_midpoint = arb_ ? half_unit(nearest) : std::abs(words_.low);
  // The radius has fewer bits than a double, which can only be too small to hold it. The two units
  // more are for that and for the sum.
  return std::nextafter(to_midpoint + radius() + least, std::numeric_limits<double>::infinity());
}

RealBall sqrt(const RealBall& x) {
  if (x.words()) {
    if (const auto words = root(x.words_)) return RealBall(*words, x.precision_);
  }
  ArbBall result;
  arb_sqrtpos(result.get(), x.arb().get(), x.precision_);
  return RealBall(std::move(result), x.precision_);
}

RealBall abs(const RealBall& x) { return x.midpoint() < 0 ? -x : x; }

RealBall scaled(const RealBall& x, long exponent) {
  // Powers of two within the range of double words.
  constexpr long kLargestExponent = 400;
  if (x.words() && std::abs(exponent) <= kLargestExponent) {
    return x * RealBall(std::ldexp(1.0, static_cast<int>(exponent)));
  }
  ArbBall result;
  arb_mul_2exp_si(result.get(), x.arb().get(), exponent);
  return RealBall(std::move(result), x.precision_);
}

std::vector<RealBall> normalized(std::vector<RealBall> numbers) {
  ArbBall largest;
  for (const RealBall& x : numbers) {
    const ArbBall ball = x.arb();
    if (arf_cmpabs(arb_midref(ball.get()), arb_midref(largest.get())) > 0) largest = ball;
  }
  if (arf_is_special(arb_midref(largest.get()))) return numbers;
  const long exponent = fmpz_get_si(ARF_EXPREF(arb_midref(largest.get())));
  for (RealBall& x : numbers) x = scaled(x, -exponent);
  return numbers;
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

namespace {

/// Balls side by side, as Arb takes vectors.
class ArbVector {
 public:
  explicit ArbVector(const std::vector<RealBall>& balls)
      : numbers_(_arb_vec_init(static_cast<slong>(balls.size()))),
        size_(static_cast<slong>(balls.size())) {
    for (std::size_t i = 0; i < balls.size(); ++i) arb_set(numbers_ + i, balls[i].arb().get());
  }
  ArbVector(const ArbVector&) = delete;
  ArbVector& operator=(const ArbVector&) = delete;
  ~ArbVector() { _arb_vec_clear(numbers_, size_); }

  arb_srcptr operator[](std::size_t i) const { return numbers_ + i; }
  slong size() const { return size_; }

 private:
  arb_ptr numbers_;
  slong size_;
};

template <class Ball>
long precision_of(const std::vector<Ball>& balls) {
  long precision = RealBall::kFloor;
  for (const Ball& ball : balls) precision = std::max(precision, ball.precision());
  return precision;
}

/// The coefficients a_i b_(k - i), first <= i < end, of t^k in a product of polynomials.
struct Terms {
  std::size_t first, end;
};

template <class Ball>
Terms terms_of(std::size_t k, const std::vector<Ball>& a, const std::vector<Ball>& b) {
  return {k < b.size() ? 0 : k - b.size() + 1, std::min(k + 1, a.size())};
}

/// How many coefficients of a product of polynomials are wanted and not zero.
template <class Ball>
std::size_t count_of(const std::vector<Ball>& sum, const std::vector<Ball>& a,
                     const std::vector<Ball>& b) {
  return std::min(sum.size(), a.size() + b.size() - 1);
}

bool are_double_words(const std::vector<RealBall>& balls) {
  return std::all_of(balls.begin(), balls.end(), [](const RealBall& x) { return x.words(); });
}

void add_in_double_words(std::vector<RealBall>& sum, const std::vector<RealBall>& a,
                         const std::vector<RealBall>& b, long precision) {
  for (std::size_t k = 0; k < count_of(sum, a, b); ++k) {
    const auto [first, end] = terms_of(k, a, b);
    DoubleWordSum words(*sum[k].words());
    for (std::size_t i = first; i < end; ++i) words.add_product(*a[i].words(), *b[k - i].words());
    if (const auto result = words.result()) {
      sum[k] = RealBall(*result, precision);
    } else {
      for (std::size_t i = first; i < end; ++i) sum[k].add_product(a[i], b[k - i]);
    }
  }
}

void add_in_arb(std::vector<RealBall>& sum, const std::vector<RealBall>& a,
                const std::vector<RealBall>& b, long precision) {
  const ArbVector x(a), y(b);
  for (std::size_t k = 0; k < count_of(sum, a, b); ++k) {
    const auto [first, end] = terms_of(k, a, b);
    ArbBall result = sum[k].arb();
    arb_dot(result.get(), result.get(), 0, x[first], 1, y[k - first], -1,
            static_cast<slong>(end - first), precision);
    sum[k] = RealBall(std::move(result), precision);
  }
}

}  // namespace

RealBall dot(const std::vector<RealBall>& a, const std::vector<RealBall>& b) {
  const long precision = std::max(precision_of(a), precision_of(b));
  if (are_double_words(a) && are_double_words(b)) {
    DoubleWordSum words({});
    for (std::size_t i = 0; i < a.size(); ++i) words.add_product(*a[i].words(), *b[i].words());
    if (const auto result = words.result()) return RealBall(*result, precision);
  }
  const ArbVector x(a), y(b);
  ArbBall sum;
  arb_dot(sum.get(), nullptr, 0, x[0], 1, y[0], 1, x.size(), precision);
  return RealBall(std::move(sum), precision);
}

void add_product(std::vector<RealBall>& sum, const std::vector<RealBall>& a,
                 const std::vector<RealBall>& b) {
  const long precision = std::max({precision_of(sum), precision_of(a), precision_of(b)});
  if (are_double_words(sum) && are_double_words(a) && are_double_words(b)) {
    add_in_double_words(sum, a, b, precision);
  } else {
    add_in_arb(sum, a, b, precision);
  }
}

void add_product(std::vector<ComplexBall>& sum, const std::vector<ComplexBall>& a,
                 const std::vector<ComplexBall>& b) {
  for (std::size_t k = 0; k < count_of(sum, a, b); ++k) {
    const auto [first, end] = terms_of(k, a, b);
    for (std::size_t i = first; i < end; ++i) sum[k].add_product(a[i], b[k - i]);
  }
}

}  // namespace pn
