// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rational_polynomial.hpp"

#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <algorithm>
#include <stdexcept>

namespace pn {

RationalPolynomial::RationalPolynomial(const Rational& constant) : RationalPolynomial() {
  fmpq_poly_set_fmpq(value_, constant.flint());
}

RationalPolynomial::RationalPolynomial(const std::vector<Rational>& coefficients)
    : RationalPolynomial() {
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    fmpq_poly_set_coeff_fmpq(value_, static_cast<slong>(i), coefficients[i].flint());
  }
}

Rational RationalPolynomial::coefficient(int i) const {
  Rational result;
  fmpq_poly_get_coeff_fmpq(result.flint(), value_, i);
  return result;
}

Rational RationalPolynomial::operator()(const Rational& t) const {
  Rational result;
  fmpq_poly_evaluate_fmpq(result.flint(), value_, t.flint());
  return result;
}

RationalPolynomial RationalPolynomial::derivative() const {
  RationalPolynomial result;
  fmpq_poly_derivative(result.value_, value_);
  return result;
}

RationalPolynomial RationalPolynomial::on_interval(const Rational& origin,
                                                   const Rational& length) const {
  RationalPolynomial result;
  fmpq_poly_compose(result.value_, value_, RationalPolynomial({origin, length}).value_);
  return result;
}

RationalPolynomial RationalPolynomial::without_root(const Rational& root) const {
  RationalPolynomial result = *this;
  const RationalPolynomial linear({-root, Rational(1)});
  while (!result.is_zero() && result(root).is_zero()) result = exact_quotient(result, linear);
  return result;
}

RationalPolynomial& RationalPolynomial::operator+=(const RationalPolynomial& other) {
  fmpq_poly_add(value_, value_, other.value_);
  return *this;
}

RationalPolynomial& RationalPolynomial::operator-=(const RationalPolynomial& other) {
  fmpq_poly_sub(value_, value_, other.value_);
  return *this;
}

RationalPolynomial& RationalPolynomial::operator*=(const RationalPolynomial& other) {
  fmpq_poly_mul(value_, value_, other.value_);
  return *this;
}

RationalPolynomial RationalPolynomial::operator-() const {
  RationalPolynomial result;
  fmpq_poly_neg(result.value_, value_);
  return result;
}

RationalPolynomial gcd(const RationalPolynomial& a, const RationalPolynomial& b) {
  RationalPolynomial result;
  fmpq_poly_gcd(result.flint(), a.flint(), b.flint());
  return result;
}

BezoutIdentity extended_gcd(const RationalPolynomial& a, const RationalPolynomial& b) {
  BezoutIdentity result;
  fmpq_poly_xgcd(result.gcd.flint(), result.x.flint(), result.y.flint(), a.flint(), b.flint());
  return result;
}

RationalPolynomial remainder(const RationalPolynomial& a, const RationalPolynomial& b) {
  if (b.is_zero()) throw std::domain_error("remainder modulo the zero polynomial");
  RationalPolynomial result;
  fmpq_poly_rem(result.flint(), a.flint(), b.flint());
  return result;
}

RationalPolynomial exact_quotient(const RationalPolynomial& a, const RationalPolynomial& b) {
  if (b.is_zero()) throw std::domain_error("division by the zero polynomial");
  RationalPolynomial quotient, remainder;
  fmpq_poly_divrem(quotient.flint(), remainder.flint(), a.flint(), b.flint());
  if (!remainder.is_zero()) throw std::domain_error("the polynomial division is not exact");
  return quotient;
}

std::vector<SquarefreeFactor> squarefree_factorization(const RationalPolynomial& p) {
  std::vector<SquarefreeFactor> factors;
  if (p.degree() < 1) return factors;
  fmpz_poly_t integral;
  fmpz_poly_init(integral);
  fmpq_poly_get_numerator(integral, p.flint());
  fmpz_poly_factor_t factorization;
  fmpz_poly_factor_init(factorization);
  fmpz_poly_factor_squarefree(factorization, integral);
  for (slong i = 0; i < factorization->num; ++i) {
    RationalPolynomial factor;
    fmpq_poly_set_fmpz_poly(factor.flint(), factorization->p + i);
    fmpq_poly_make_monic(factor.flint(), factor.flint());
    factors.push_back({std::move(factor), static_cast<int>(factorization->exp[i])});
  }
  fmpz_poly_factor_clear(factorization);
  fmpz_poly_clear(integral);
  return factors;
}

std::vector<RationalPolynomial> irreducible_factors(const RationalPolynomial& squarefree) {
  if (squarefree.degree() < 1) return {};
  fmpz_poly_t integral;
  fmpz_poly_init(integral);
  fmpq_poly_get_numerator(integral, squarefree.flint());
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, integral);
  std::vector<RationalPolynomial> result;
  for (slong i = 0; i < factors->num; ++i) {
    RationalPolynomial factor;
    fmpq_poly_set_fmpz_poly(factor.flint(), factors->p + i);
    fmpq_poly_make_monic(factor.flint(), factor.flint());
    result.push_back(std::move(factor));
  }
  fmpz_poly_factor_clear(factors);
  fmpz_poly_clear(integral);
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.degree() < b.degree(); });
  return result;
}

Rational content(const RationalPolynomial& p) {
  Rational result;
  fmpq_poly_content(result.flint(), p.flint());
  return result;
}

RationalPolynomial power_of_t(int exponent) {
  RationalPolynomial result;
  fmpq_poly_set_coeff_si(result.flint(), exponent, 1);
  return result;
}

std::vector<Rational> coefficients(const RationalPolynomial& p, int degree) {
  std::vector<Rational> result;
  result.reserve(static_cast<std::size_t>(degree) + 1);
  for (int i = 0; i <= degree; ++i) result.push_back(p.coefficient(i));
  return result;
}

}  // namespace pn
