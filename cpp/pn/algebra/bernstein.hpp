// SPDX-License-Identifier: LGPL-2.1-or-later
// The Bernstein basis B_j(t) = C(n, j) t^j (1 - t)^(n - j) on [0, 1].
//
//   t^i = sum_{j >= i} C(j, i) / C(n, i) B_j,   hence   b_j = sum_i C(j, i) a_i / C(n, i)
//
// for the Bernstein coefficients b of sum a_i t^i. Scaled by the binomials the change of basis is
// repeated addition of neighbours, and its inverse repeated subtraction: exact over Q, enclosing
// over balls. (G. Farin, Curves and Surfaces for CAGD, 5th ed. 2002, section 6.6.)
//
// Written as b_j = j! / n!^2 sum_i ((n - i)! a_i) (n! / (j - i)!) it is a convolution, for which
// balls have fast sums of products.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "pn/algebra/ball.hpp"

namespace pn {

/// The largest degree whose binomials, and the products on the way to them, fit a 64-bit word.
inline constexpr long kWordDegree = 61;

/// Calls apply(i, numerator, denominator) with factors that multiply up to C(degree, i) for every
/// i.
template <class Apply>
void for_each_binomial_factor(long degree, Apply&& apply) {
  if (degree <= kWordDegree) {
    long binomial = 1;
    for (long i = 0; i <= degree; ++i) {
      apply(static_cast<std::size_t>(i), binomial, 1L);
      binomial = binomial * (degree - i) / (i + 1);
    }
    return;
  }
  for (long i = 0; i <= degree; ++i) {
    for (long j = 0; j < std::min(i, degree - i); ++j) {
      apply(static_cast<std::size_t>(i), degree - j, j + 1);
    }
  }
}

/// Bernstein coefficients of the polynomial with these power coefficients (ascending; the size
/// fixes the degree of the basis).
template <class T>
std::vector<T> to_bernstein(std::vector<T> power) {
  for_each_binomial_factor(static_cast<long>(power.size()) - 1,
                           [&](std::size_t i, long numerator, long denominator) {
                             if (denominator != 1) power[i] *= T(denominator);
                             power[i] /= T(numerator);
                           });
  for (std::size_t round = 1; round < power.size(); ++round) {
    for (std::size_t j = power.size() - 1; j >= round; --j) power[j] += power[j - 1];
  }
  return power;
}

/// Power coefficients of the polynomial with these Bernstein coefficients.
template <class T>
std::vector<T> from_bernstein(std::vector<T> bernstein) {
  for (std::size_t round = bernstein.size(); round-- > 1;) {
    for (std::size_t j = round; j < bernstein.size(); ++j) bernstein[j] -= bernstein[j - 1];
  }
  for_each_binomial_factor(static_cast<long>(bernstein.size()) - 1,
                           [&](std::size_t i, long numerator, long denominator) {
                             bernstein[i] *= T(numerator);
                             if (denominator != 1) bernstein[i] /= T(denominator);
                           });
  return bernstein;
}

/// to_bernstein for many polynomials of one degree over balls, as a convolution.
class BernsteinOfBalls {
 public:
  BernsteinOfBalls(int degree, long precision);

  /// The coefficients of a polynomial of this degree in powers, ascending.
  std::vector<RealBall> operator()(std::vector<RealBall> power) const;

 private:
  std::vector<RealBall> factorial_;  ///< i!
  std::vector<RealBall> falling_;    ///< n! / i!
  std::vector<RealBall> scale_;      ///< i! / n!^2
};

}  // namespace pn
