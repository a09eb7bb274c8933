// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rational.hpp"

#include <arf.h>

#include <cmath>
#include <stdexcept>

namespace pn {

Rational Rational::exactly(double x) {
  if (!std::isfinite(x)) throw std::domain_error("a number is not finite");
  int exponent = 0;
  const auto mantissa = static_cast<long>(std::ldexp(std::frexp(x, &exponent), 53));
  Rational result(mantissa);
  const int shift = exponent - 53;
  if (shift >= 0) {
    fmpq_mul_2exp(result.value_, result.value_, static_cast<ulong>(shift));
  } else {
    fmpq_div_2exp(result.value_, result.value_, static_cast<ulong>(-shift));
  }
  return result;
}

double Rational::to_double() const {
  arf_t quotient;
  arf_init(quotient);
  arf_fmpz_div_fmpz(quotient, fmpq_numref(value_), fmpq_denref(value_), 53, ARF_RND_NEAR);
  const double result = arf_get_d(quotient, ARF_RND_NEAR);
  arf_clear(quotient);
  return result;
}

Rational& Rational::operator/=(const Rational& other) {
  if (other.is_zero()) throw std::domain_error("division by zero");
  fmpq_div(value_, value_, other.value_);
  return *this;
}

Rational gcd(const Rational& a, const Rational& b) {
  Rational result;
  fmpq_gcd(result.flint(), a.flint(), b.flint());
  return result;
}

Rational common_denominator(const Rational& a, const Rational& b) {
  Rational result;
  fmpz_lcm(fmpq_numref(result.flint()), fmpq_denref(a.flint()), fmpq_denref(b.flint()));
  return result;
}

std::optional<Rational> square_root(const Rational& x) {
  const fmpz *numerator = fmpq_numref(x.flint()), *denominator = fmpq_denref(x.flint());
  if (fmpz_is_square(numerator) == 0 || fmpz_is_square(denominator) == 0) return std::nullopt;
  Rational root;
  fmpz_sqrt(fmpq_numref(root.flint()), numerator);
  fmpz_sqrt(fmpq_denref(root.flint()), denominator);
  return root;
}

}  // namespace pn
