// SPDX-License-Identifier: LGPL-2.1-or-later
// Elimination in Q[u, v, s, t]: resultants and irreducible factors.
//
// THEOREM. Two polynomials have a common zero in x over an algebraic closure of the field of their
// coefficients, or both leading coefficients in x vanish, exactly when their resultant in x is
// zero. (B. L. van der Waerden, Algebra I, section 34.) So the solutions of two equations project
// to the zeros of the resultant, and those that are rational to its linear factors.
//
// Contract: every operation is exact, over Q. Factors over an extension of Q are not found.
#pragma once

#include <vector>

#include "pn/algebra/multivariate_polynomial.hpp"

namespace pn {

/// The irreducible factors that are not constant, each once; none of a constant.
template <std::size_t N>
std::vector<MultivariatePolynomial<N>> irreducible_factors(const MultivariatePolynomial<N>& p);

/// Of degrees in the variable that both polynomials have.
template <std::size_t N>
MultivariatePolynomial<N> resultant(const MultivariatePolynomial<N>& p,
                                    const MultivariatePolynomial<N>& q, Variable variable);

}  // namespace pn
