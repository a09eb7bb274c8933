// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/elimination.hpp"

#include <flint/fmpq_mpoly_factor.h>

#include <stdexcept>

namespace pn {

template <std::size_t N>
std::vector<MultivariatePolynomial<N>> irreducible_factors(const MultivariatePolynomial<N>& p) {
  fmpq_mpoly_factor_t product;
  fmpq_mpoly_factor_init(product, p.ring());
  const bool is_factored = fmpq_mpoly_factor(product, p.flint(), p.ring()) != 0;
  std::vector<MultivariatePolynomial<N>> factors;
  for (slong i = 0; is_factored && i < fmpq_mpoly_factor_length(product, p.ring()); ++i) {
    fmpq_mpoly_factor_get_base(factors.emplace_back().flint(), product, i, p.ring());
  }
  fmpq_mpoly_factor_clear(product, p.ring());
  if (!is_factored) throw std::domain_error("the degrees do not fit a factorization");
  return factors;
}

template <std::size_t N>
MultivariatePolynomial<N> resultant(const MultivariatePolynomial<N>& p,
                                    const MultivariatePolynomial<N>& q, Variable variable) {
  MultivariatePolynomial<N> result;
  if (fmpq_mpoly_resultant(result.flint(), p.flint(), q.flint(), static_cast<slong>(variable),
                           p.ring()) == 0) {
    throw std::domain_error("the degrees do not fit a resultant");
  }
  return result;
}

#define PN_INSTANTIATE(N)                                                        \
  template std::vector<MultivariatePolynomial<N>> irreducible_factors(           \
      const MultivariatePolynomial<N>&);                                         \
  template MultivariatePolynomial<N> resultant(const MultivariatePolynomial<N>&, \
                                               const MultivariatePolynomial<N>&, Variable);

PN_INSTANTIATE(2)
PN_INSTANTIATE(3)
PN_INSTANTIATE(4)

}  // namespace pn
