// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/multivariate_polynomial.hpp"

#include <stdexcept>

namespace pn {
namespace {

/// Never cleared, since polynomials may outlive any static object.
const fmpq_mpoly_ctx_struct* new_ring(std::size_t variables) {
  auto* context = new fmpq_mpoly_ctx_struct;
  fmpq_mpoly_ctx_init(context, static_cast<slong>(variables), ORD_LEX);
  return context;
}

template <std::size_t N>
slong index(Variable variable) {
  const auto result = static_cast<std::size_t>(variable);
  if (result >= N) throw std::out_of_range("the ring has fewer variables");
  return static_cast<slong>(result);
}

}  // namespace

template <std::size_t N>
const fmpq_mpoly_ctx_struct* MultivariatePolynomial<N>::ring() {
  static const fmpq_mpoly_ctx_struct* const context = new_ring(N);
  return context;
}

template <std::size_t N>
MultivariatePolynomial<N>::MultivariatePolynomial(const Rational& constant)
    : MultivariatePolynomial() {
  fmpq_mpoly_set_fmpq(value_, constant.flint(), ring());
}

template <std::size_t N>
MultivariatePolynomial<N>::MultivariatePolynomial(Variable variable) : MultivariatePolynomial() {
  fmpq_mpoly_gen(value_, index<N>(variable), ring());
}

template <std::size_t N>
MultivariatePolynomial<N>::MultivariatePolynomial(
    const std::vector<std::vector<Rational>>& coefficients)
    : MultivariatePolynomial() {
  // Their content is found once, not anew with every term.
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    for (std::size_t j = 0; j < coefficients[i].size(); ++j) {
      if (coefficients[i][j].is_zero()) continue;
      const std::array<ulong, N> exponents = {i, j};
      fmpq_mpoly_push_term_fmpq_ui(value_, coefficients[i][j].flint(), exponents.data(), ring());
    }
  }
  fmpq_mpoly_sort_terms(value_, ring());
  fmpq_mpoly_reduce(value_, ring());
}

template <std::size_t N>
MultivariatePolynomial<N>::MultivariatePolynomial(const RationalPolynomial& p, Variable variable)
    : MultivariatePolynomial() {
  for (int i = 0; i <= p.degree(); ++i) {
    std::array<ulong, N> exponents{};
    exponents[static_cast<std::size_t>(index<N>(variable))] = static_cast<ulong>(i);
    fmpq_mpoly_set_coeff_fmpq_ui(value_, p.coefficient(i).flint(), exponents.data(), ring());
  }
}

template <std::size_t N>
int MultivariatePolynomial<N>::degree(Variable variable) const {
  return static_cast<int>(fmpq_mpoly_degree_si(value_, index<N>(variable), ring()));
}

template <std::size_t N>
Rational MultivariatePolynomial<N>::coefficient_at(const std::array<ulong, N>& exponents) const {
  Rational result;
  fmpq_mpoly_get_coeff_fmpq_ui(result.flint(), value_, exponents.data(), ring());
  return result;
}

template <std::size_t N>
Rational MultivariatePolynomial<N>::at(const std::array<Rational, N>& values) const {
  Rational result;
  std::array<Rational, N> copies = values;
  std::array<fmpq*, N> pointers;
  for (std::size_t i = 0; i < N; ++i) pointers[i] = copies[i].flint();
  if (fmpq_mpoly_evaluate_all_fmpq(result.flint(), value_, pointers.data(), ring()) == 0) {
    throw std::domain_error("the powers of these numbers do not fit the memory");
  }
  return result;
}

template <std::size_t N>
MultivariatePolynomial<N> MultivariatePolynomial<N>::derivative(Variable variable) const {
  MultivariatePolynomial result;
  fmpq_mpoly_derivative(result.value_, value_, index<N>(variable), ring());
  return result;
}

template <std::size_t N>
template <std::size_t M>
MultivariatePolynomial<M> MultivariatePolynomial<N>::composed(
    const std::array<MultivariatePolynomial<M>, N>& polynomials) const {
  MultivariatePolynomial<M> result;
  std::array<MultivariatePolynomial<M>, N> copies = polynomials;
  std::array<fmpq_mpoly_struct*, N> pointers;
  for (std::size_t i = 0; i < N; ++i) pointers[i] = copies[i].flint();
  if (fmpq_mpoly_compose_fmpq_mpoly(result.flint(), value_, pointers.data(), ring(),
                                    MultivariatePolynomial<M>::ring()) == 0) {
    throw std::domain_error("the powers of these polynomials do not fit the memory");
  }
  return result;
}

template <std::size_t N>
MultivariatePolynomial<N>& MultivariatePolynomial<N>::operator+=(
    const MultivariatePolynomial& other) {
  fmpq_mpoly_add(value_, value_, other.value_, ring());
  return *this;
}

template <std::size_t N>
MultivariatePolynomial<N>& MultivariatePolynomial<N>::operator-=(
    const MultivariatePolynomial& other) {
  fmpq_mpoly_sub(value_, value_, other.value_, ring());
  return *this;
}

template <std::size_t N>
MultivariatePolynomial<N>& MultivariatePolynomial<N>::operator*=(
    const MultivariatePolynomial& other) {
  fmpq_mpoly_mul(value_, value_, other.value_, ring());
  return *this;
}

template <std::size_t N>
MultivariatePolynomial<N> MultivariatePolynomial<N>::operator-() const {
  MultivariatePolynomial result;
  fmpq_mpoly_neg(result.value_, value_, ring());
  return result;
}

template <std::size_t N>
MultivariatePolynomial<N> gcd(const MultivariatePolynomial<N>& a,
                              const MultivariatePolynomial<N>& b) {
  MultivariatePolynomial<N> result;
  if (fmpq_mpoly_gcd(result.flint(), a.flint(), b.flint(), a.ring()) == 0) {
    throw std::domain_error("the degrees do not fit a greatest common divisor");
  }
  return result;
}

template <std::size_t N>
std::optional<MultivariatePolynomial<N>> quotient(const MultivariatePolynomial<N>& a,
                                                  const MultivariatePolynomial<N>& b) {
  if (b.is_zero()) throw std::domain_error("division by the zero polynomial");
  MultivariatePolynomial<N> result;
  if (fmpq_mpoly_divides(result.flint(), a.flint(), b.flint(), a.ring()) == 0) {
    return std::nullopt;
  }
  return result;
}

template <std::size_t N>
Rational leading_coefficient(const MultivariatePolynomial<N>& p) {
  Rational result;
  if (!p.is_zero()) fmpq_mpoly_get_term_coeff_fmpq(result.flint(), p.flint(), 0, p.ring());
  return result;
}

template <std::size_t N>
std::optional<MultivariatePolynomial<N>> square_root(const MultivariatePolynomial<N>& p) {
  MultivariatePolynomial<N> result;
  if (fmpq_mpoly_sqrt(result.flint(), p.flint(), p.ring()) == 0) return std::nullopt;
  return result;
}

#define PN_INSTANTIATE_COMPOSED(N, M)                                        \
  template MultivariatePolynomial<M> MultivariatePolynomial<N>::composed<M>( \
      const std::array<MultivariatePolynomial<M>, N>&) const;
#define PN_INSTANTIATE(N)                                                                          \
  template class MultivariatePolynomial<N>;                                                        \
  template MultivariatePolynomial<N> gcd(const MultivariatePolynomial<N>&,                         \
                                         const MultivariatePolynomial<N>&);                        \
  template std::optional<MultivariatePolynomial<N>> quotient(const MultivariatePolynomial<N>&,     \
                                                             const MultivariatePolynomial<N>&);    \
  template Rational leading_coefficient(const MultivariatePolynomial<N>&);                         \
  template std::optional<MultivariatePolynomial<N>> square_root(const MultivariatePolynomial<N>&); \
  PN_INSTANTIATE_COMPOSED(N, 2) PN_INSTANTIATE_COMPOSED(N, 3) PN_INSTANTIATE_COMPOSED(N, 4)

PN_INSTANTIATE(2)
PN_INSTANTIATE(3)
PN_INSTANTIATE(4)

}  // namespace pn
