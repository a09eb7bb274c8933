// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/ball.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace pn {

RealBall RealBall::between(double low, double high, long precision) {
  RealBall result;
  result.precision_ = precision;
  arf_t a, b;
  arf_init_set_ui(a, 0);
  arf_init_set_ui(b, 0);
  arf_set_d(a, low);
  arf_set_d(b, high);
  arb_set_interval_arf(result.value_, a, b, precision);
  arf_clear(a);
  arf_clear(b);
  return result;
}

RealBall RealBall::at_precision(long bits) const {
  RealBall result = *this;
  result.precision_ = bits;
  return result;
}

namespace {

/// The double at or beyond a bound that one of Arb's functions gives for a ball.
template <class Bound>
double rounded_bound(Bound bound_of, const RealBall& x, arf_rnd_t direction) {
  arf_t bound;
  arf_init(bound);
  bound_of(bound, x.arb(), x.precision());
  const double result = arf_get_d(bound, direction);
  arf_clear(bound);
  return result;
}

}  // namespace

double RealBall::lower() const { return rounded_bound(arb_get_lbound_arf, *this, ARF_RND_FLOOR); }

double RealBall::upper() const { return rounded_bound(arb_get_ubound_arf, *this, ARF_RND_CEIL); }

double RealBall::magnitude_upper() const {
  return rounded_bound(arb_get_abs_ubound_arf, *this, ARF_RND_CEIL);
}

std::optional<double> RealBall::rounded() const {
  const double nearest = midpoint();
  if (!std::isfinite(nearest)) return std::nullopt;
  if (mag_is_zero(arb_radref(value_))) return nearest;
  if (nearest == 0) return std::nullopt;
  // The midpoint is at most half a unit in the last place away, so the radius may be the other
  // half.
  constexpr int kMantissaBits = 53;
  const int exponent = std::ilogb(nearest) + 1;
  const bool narrow = mag_cmp_2exp_si(arb_radref(value_), exponent - kMantissaBits - 1) <= 0;
  return narrow ? std::optional<double>(nearest) : std::nullopt;
}

double RealBall::rounding_error() const {
  constexpr int kMantissaBits = 53;
  const double nearest = midpoint(), least = std::numeric_limits<double>::denorm_min();
  const double half_unit = nearest == 0 ? 0 : std::ldexp(1.0, std::ilogb(nearest) - kMantissaBits);
  // The radius has fewer bits than a double, which can only be too small to hold it. The two units
  // more are for that and for the sum.
  const double error = half_unit + mag_get_d(arb_radref(value_));
  return std::nextafter(error + least, std::numeric_limits<double>::infinity());
}

RealBall sqrt(const RealBall& x) {
  RealBall result = x;
  arb_sqrtpos(result.arb(), x.arb(), x.precision());
  return result;
}

RealBall abs(const RealBall& x) {
  RealBall result = x;
  arb_abs(result.arb(), x.arb());
  return result;
}

RealBall scaled(const RealBall& x, long exponent) {
  RealBall result = x;
  arb_mul_2exp_si(result.arb(), x.arb(), exponent);
  return result;
}

std::vector<RealBall> normalized(std::vector<RealBall> numbers) {
  arf_srcptr largest = nullptr;
  for (const RealBall& x : numbers) {
    arf_srcptr midpoint = arb_midref(x.arb());
    if (!largest || arf_cmpabs(midpoint, largest) > 0) largest = midpoint;
  }
  if (!largest || arf_is_special(largest)) return numbers;
  const long exponent = fmpz_get_si(ARF_EXPREF(largest));
  for (RealBall& x : numbers) x = scaled(x, -exponent);
  return numbers;
}

ComplexBall sqrt(const ComplexBall& z) {
  ComplexBall result = z;
  acb_sqrt(result.acb(), z.acb(), z.precision());
  return result;
}

RealBall ComplexBall::real() const {
  RealBall result;
  result.precision_ = precision_;
  arb_set(result.value_, acb_realref(value_));
  return result;
}

RealBall ComplexBall::imag() const {
  RealBall result;
  result.precision_ = precision_;
  arb_set(result.value_, acb_imagref(value_));
  return result;
}

namespace {

const arb_struct& number(const RealBall& x) { return *x.arb(); }
const acb_struct& number(const ComplexBall& x) { return *x.acb(); }

/// The numbers of balls side by side, as Arb takes vectors; they remain those of the balls.
template <class Ball>
auto lent(const std::vector<Ball>& balls) {
  std::vector<std::decay_t<decltype(number(balls[0]))>> numbers;
  numbers.reserve(balls.size());
  for (const Ball& ball : balls) numbers.push_back(number(ball));
  return numbers;
}

template <class Ball>
long precision_of(const std::vector<Ball>& balls) {
  long precision = RealBall::kFloor;
  for (const Ball& ball : balls) precision = std::max(precision, ball.precision());
  return precision;
}

/// sum += x[0] y[0] + x[1] y[-1] + ...
void add_backwards(RealBall& sum, arb_srcptr x, arb_srcptr y, slong count, long precision) {
  arb_dot(sum.arb(), sum.arb(), 0, x, 1, y, -1, count, precision);
}
void add_backwards(ComplexBall& sum, acb_srcptr x, acb_srcptr y, slong count, long precision) {
  acb_dot(sum.acb(), sum.acb(), 0, x, 1, y, -1, count, precision);
}

template <class Ball>
void add_product_of(std::vector<Ball>& sum, const std::vector<Ball>& a,
                    const std::vector<Ball>& b) {
  const long precision = std::max({precision_of(sum), precision_of(a), precision_of(b)});
  const auto x = lent(a), y = lent(b);
  const std::size_t n = x.size() - 1, m = y.size() - 1;
  for (std::size_t k = 0; k < std::min(sum.size(), n + m + 1); ++k) {
    const std::size_t first = k > m ? k - m : 0, last = std::min(k, n);
    sum[k].set_precision(precision);
    add_backwards(sum[k], &x[first], &y[k - first], static_cast<slong>(last - first + 1),
                  precision);
  }
}

}  // namespace

RealBall dot(const std::vector<RealBall>& a, const std::vector<RealBall>& b) {
  // Few numbers at once, so that they need no memory of their own.
  constexpr std::size_t kAtOnce = 8;
  std::array<arb_struct, kAtOnce> x, y;
  const long precision = std::max(precision_of(a), precision_of(b));
  RealBall sum = RealBall().at_precision(precision);
  for (std::size_t first = 0; first < a.size(); first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, a.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = number(a[first + i]);
      y[i] = number(b[first + i]);
    }
    arb_dot(sum.arb(), sum.arb(), 0, x.data(), 1, y.data(), 1, static_cast<slong>(count),
            precision);
  }
  return sum;
}

void add_product(std::vector<RealBall>& sum, const std::vector<RealBall>& a,
                 const std::vector<RealBall>& b) {
  add_product_of(sum, a, b);
}

void add_product(std::vector<ComplexBall>& sum, const std::vector<ComplexBall>& a,
                 const std::vector<ComplexBall>& b) {
  add_product_of(sum, a, b);
}

}  // namespace pn
