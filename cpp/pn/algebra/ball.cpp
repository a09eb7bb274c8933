// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/ball.hpp"

#include <cmath>

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

}  // namespace pn
