// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rounded_square_root.hpp"

namespace pn {

Rational rounded_square_root(const Rational& x, long bits) {
  if (const auto root = square_root(x)) return *root;
  const auto shift = static_cast<unsigned long>(bits);
  Rational root;
  fmpz* numerator = fmpq_numref(root.flint());
  fmpz_mul(numerator, fmpq_numref(x.flint()), fmpq_denref(x.flint()));
  fmpz_mul_2exp(numerator, numerator, 2 * shift);
  fmpz_sqrt(numerator, numerator);
  fmpz_mul_2exp(fmpq_denref(root.flint()), fmpq_denref(x.flint()), shift);
  fmpq_canonicalise(root.flint());
  return root;
}

}  // namespace pn
