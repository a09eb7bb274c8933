// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/bivariate_polynomial.hpp"

#include <stdexcept>

namespace pn {
namespace {

/// Two variables; never cleared, since polynomials may outlive any static object.
const fmpq_mpoly_ctx_struct* new_ring() {
  auto* context = new fmpq_mpoly_ctx_struct;
  fmpq_mpoly_ctx_init(context, 2, ORD_LEX);
  return context;
}

slong index(Variable variable) { return variable == Variable::kU ? 0 : 1; }

}  // namespace

const fmpq_mpoly_ctx_struct* BivariatePolynomial::ring() {
  static const fmpq_mpoly_ctx_struct* const context = new_ring();
  return context;
}

BivariatePolynomial::BivariatePolynomial(const Rational& constant) : BivariatePolynomial() {
  fmpq_mpoly_set_fmpq(value_, constant.flint(), ring());
}

BivariatePolynomial::BivariatePolynomial(const std::vector<std::vector<Rational>>& coefficients)
    : BivariatePolynomial() {
  // Their content is found once, not anew with every term.
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    for (std::size_t j = 0; j < coefficients[i].size(); ++j) {
      if (coefficients[i][j].is_zero()) continue;
      const ulong exponents[] = {i, j};
      fmpq_mpoly_push_term_fmpq_ui(value_, coefficients[i][j].flint(), exponents, ring());
    }
  }
  fmpq_mpoly_sort_terms(value_, ring());
  fmpq_mpoly_reduce(value_, ring());
}

BivariatePolynomial::BivariatePolynomial(const RationalPolynomial& p, Variable variable)
    : BivariatePolynomial() {
  for (int i = 0; i <= p.degree(); ++i) {
    ulong exponents[] = {0, 0};
    exponents[index(variable)] = static_cast<ulong>(i);
    fmpq_mpoly_set_coeff_fmpq_ui(value_, p.coefficient(i).flint(), exponents, ring());
  }
}

int BivariatePolynomial::degree(Variable variable) const {
  return static_cast<int>(fmpq_mpoly_degree_si(value_, index(variable), ring()));
}

Rational BivariatePolynomial::coefficient(int i, int j) const {
  Rational result;
  const ulong exponents[] = {static_cast<ulong>(i), static_cast<ulong>(j)};
  fmpq_mpoly_get_coeff_fmpq_ui(result.flint(), value_, exponents, ring());
  return result;
}

Rational BivariatePolynomial::operator()(const Rational& u, const Rational& v) const {
  Rational result, at_u = u, at_v = v;
  fmpq* const values[] = {at_u.flint(), at_v.flint()};
  if (fmpq_mpoly_evaluate_all_fmpq(result.flint(), value_, values, ring()) == 0) {
    throw std::domain_error("the powers of these numbers do not fit the memory");
  }
  return result;
}

BivariatePolynomial BivariatePolynomial::derivative(Variable variable) const {
  BivariatePolynomial result;
  fmpq_mpoly_derivative(result.value_, value_, index(variable), ring());
  return result;
}

BivariatePolynomial BivariatePolynomial::composed(const BivariatePolynomial& a,
                                                  const BivariatePolynomial& b) const {
  BivariatePolynomial result, in_place_of_u = a, in_place_of_v = b;
  fmpq_mpoly_struct* const values[] = {in_place_of_u.value_, in_place_of_v.value_};
  if (fmpq_mpoly_compose_fmpq_mpoly(result.value_, value_, values, ring(), ring()) == 0) {
    throw std::domain_error("the powers of these polynomials do not fit the memory");
  }
  return result;
}

BivariatePolynomial& BivariatePolynomial::operator+=(const BivariatePolynomial& other) {
  fmpq_mpoly_add(value_, value_, other.value_, ring());
  return *this;
}

BivariatePolynomial& BivariatePolynomial::operator-=(const BivariatePolynomial& other) {
  fmpq_mpoly_sub(value_, value_, other.value_, ring());
  return *this;
}

BivariatePolynomial& BivariatePolynomial::operator*=(const BivariatePolynomial& other) {
  fmpq_mpoly_mul(value_, value_, other.value_, ring());
  return *this;
}

BivariatePolynomial BivariatePolynomial::operator-() const {
  BivariatePolynomial result;
  fmpq_mpoly_neg(result.value_, value_, ring());
  return result;
}

BivariatePolynomial gcd(const BivariatePolynomial& a, const BivariatePolynomial& b) {
  BivariatePolynomial result;
  if (fmpq_mpoly_gcd(result.flint(), a.flint(), b.flint(), BivariatePolynomial::ring()) == 0) {
    throw std::domain_error("the degrees do not fit a greatest common divisor");
  }
  return result;
}

std::optional<BivariatePolynomial> quotient(const BivariatePolynomial& a,
                                            const BivariatePolynomial& b) {
  if (b.is_zero()) throw std::domain_error("division by the zero polynomial");
  BivariatePolynomial result;
  if (fmpq_mpoly_divides(result.flint(), a.flint(), b.flint(), BivariatePolynomial::ring()) == 0) {
    return std::nullopt;
  }
  return result;
}

Rational leading_coefficient(const BivariatePolynomial& p) {
  Rational result;
  if (!p.is_zero()) {
    fmpq_mpoly_get_term_coeff_fmpq(result.flint(), p.flint(), 0, BivariatePolynomial::ring());
  }
  return result;
}

std::optional<BivariatePolynomial> square_root(const BivariatePolynomial& p) {
  BivariatePolynomial result;
  if (fmpq_mpoly_sqrt(result.flint(), p.flint(), BivariatePolynomial::ring()) == 0) {
    return std::nullopt;
  }
  return result;
}

}  // namespace pn
