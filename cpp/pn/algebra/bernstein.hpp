// SPDX-License-Identifier: LGPL-2.1-or-later
// The Bernstein basis B_j(t) = C(n, j) t^j (1 - t)^(n - j) on [0, 1].
//
//   t^i = sum_{j >= i} C(j, i) / C(n, i) B_j,   hence   b_j = sum_i C(j, i) a_i / C(n, i)
//
// for the Bernstein coefficients b of sum a_i t^i. Scaled by the binomials the change of basis is
// repeated addition of neighbours, and its inverse repeated subtraction: exact over Q, enclosing
// over balls. (G. Farin, Curves and Surfaces for CAGD, 5th ed. 2002, section 6.6.)
#pragma once

#include <cstddef>
#include <vector>

namespace pn {

/// Bernstein coefficients of the polynomial with these power coefficients (ascending; the size
/// fixes the degree of the basis).
template <class T>
std::vector<T> to_bernstein(std::vector<T> power) {
  const long degree = static_cast<long>(power.size()) - 1;
  long binomial = 1;
  for (long i = 0; i <= degree; ++i) {
    power[static_cast<std::size_t>(i)] /= T(binomial);
    binomial = binomial * (degree - i) / (i + 1);
  }
  for (std::size_t round = 1; round < power.size(); ++round) {
    for (std::size_t j = power.size() - 1; j >= round; --j) power[j] += power[j - 1];
  }
  return power;
}

/// Power coefficients of the polynomial with these Bernstein coefficients.
template <class T>
std::vector<T> from_bernstein(std::vector<T> bernstein) {
  const long degree = static_cast<long>(bernstein.size()) - 1;
  for (std::size_t round = bernstein.size(); round-- > 1;) {
    for (std::size_t j = round; j < bernstein.size(); ++j) bernstein[j] -= bernstein[j - 1];
  }
  long binomial = 1;
  for (long i = 0; i <= degree; ++i) {
    bernstein[static_cast<std::size_t>(i)] *= T(binomial);
    binomial = binomial * (degree - i) / (i + 1);
  }
  return bernstein;
}

}  // namespace pn
