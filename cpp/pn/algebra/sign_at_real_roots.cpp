// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/sign_at_real_roots.hpp"

#include "pn/algebra/common_factor.hpp"
#include "pn/algebra/roots.hpp"

namespace pn {
namespace {

bool has_real_roots(const RationalPolynomial& p) {
  return numbers_between_real_roots(p).size() > 1;
}

Rational resultant(const RationalPolynomial& a, const RationalPolynomial& b) {
  Rational result;
  fmpq_poly_resultant(result.flint(), a.flint(), b.flint());
  return result;
}

}  // namespace

std::optional<int> sign_at_real_roots(const RationalPolynomial& p, const RationalPolynomial& f) {
  if (has_real_roots(gcd(p, f))) return std::nullopt;
  const RationalPolynomial rest = without_common_roots(p, f);
  if (rest.degree() < 1) return 1;
  const int leading = rest.coefficient(rest.degree()).sign();
  return resultant(rest, f).sign() * (f.degree() % 2 == 0 ? 1 : leading);
}

}  // namespace pn
