// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/sign_at_real_roots.hpp"

#include <arb_fmpz_poly.h>

#include "pn/algebra/common_factor.hpp"
#include "pn/algebra/roots.hpp"

namespace pn {
namespace {

bool has_real_roots(const RationalPolynomial& p) {
  return numbers_between_real_roots(p).size() > 1;
}

/// A ball with the sign of f(t): the numerator of f has it.
RealBall numerator_at(const RationalPolynomial& f, const RealBall& t, long precision) {
  ArbBall result;
  _arb_fmpz_poly_evaluate_arb(result.get(), fmpq_poly_numref(f.flint()), f.degree() + 1,
                              t.arb().get(), precision);
  return RealBall(result, precision);
}

/// Nothing where the precision is too low.
std::optional<int> product_of_signs(const RationalPolynomial& p, const RationalPolynomial& f,
                                    long precision) {
  int product = 1;
  for (const RealRoot& root : isolate_roots(p, precision).real) {
    const RealBall value = numerator_at(f, root.value, precision);
    if (value.contains_zero()) return std::nullopt;
    if (value.is_negative() && root.multiplicity % 2 != 0) product = -product;
  }
  return product;
}

}  // namespace

std::optional<int> sign_at_real_roots(const RationalPolynomial& p, const RationalPolynomial& f) {
  if (has_real_roots(gcd(p, f))) return std::nullopt;
  const RationalPolynomial rest = without_common_roots(p, f);
  for (long precision = 128;; precision *= 2) {
    if (const auto product = product_of_signs(rest, f, precision)) return product;
  }
}

}  // namespace pn
