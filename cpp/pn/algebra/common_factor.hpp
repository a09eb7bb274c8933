// SPDX-License-Identifier: LGPL-2.1-or-later
// Polynomials and homogeneous coordinates over Q[t] without common factors.
#pragma once

#include <utility>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

/// The same entries, of a container, divided by their greatest common divisor; zeros stay zeros.
template <class Polynomials>
Polynomials coprime(Polynomials entries) {
  RationalPolynomial common;
  for (const RationalPolynomial& entry : entries) common = gcd(common, entry);
  if (common.degree() < 1) return entries;
  for (RationalPolynomial& entry : entries) entry = exact_quotient(entry, common);
  return entries;
}

/// p without the roots, of any multiplicity, that another polynomial shares.
inline RationalPolynomial without_common_roots(RationalPolynomial p,
                                               const RationalPolynomial& other) {
  for (;;) {
    const RationalPolynomial common = gcd(p, other);
    if (common.degree() < 1) return p;
    p = exact_quotient(p, common);
  }
}

}  // namespace pn
