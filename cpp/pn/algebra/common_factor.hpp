// SPDX-License-Identifier: LGPL-2.1-or-later
// Homogeneous coordinates over Q[t] without their common factor.
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

}  // namespace pn
