// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/power_of_two.hpp"

#include <flint/fmpz.h>

#include <algorithm>

namespace pn {

Rational power_of_two_near(const Rational& x) {
  const fmpz *numerator = fmpq_numref(x.flint()), *denominator = fmpq_denref(x.flint());
  const auto exponent =
      static_cast<long>(fmpz_bits(numerator)) - static_cast<long>(fmpz_bits(denominator));
  Rational power(1);
  fmpz* part = exponent < 0 ? fmpq_denref(power.flint()) : fmpq_numref(power.flint());
  fmpz_mul_2exp(part, part, static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return power;
}

Rational power_of_two_near(const std::vector<RationalPolynomial>& polynomials) {
  Rational largest;
  for (const RationalPolynomial& p : polynomials) {
    for (int i = 0; i <= p.degree(); ++i) {
      const Rational c = p.coefficient(i);
      if (!c.is_zero()) largest = std::max(largest, power_of_two_near(c));
    }
  }
  return largest.is_zero() ? Rational(1) : largest;
}

}  // namespace pn
