// SPDX-License-Identifier: LGPL-2.1-or-later
// The rings Q[u, v], Q[u, v, s], Q[u, v, s, t]: exact polynomials in up to four variables.
//
// Contract: every operation is exact; degrees, common factors and squares are decided, not
// estimated. The number N of variables is 2, 3 or 4.
#pragma once

#include <flint/fmpq_mpoly.h>

#include <array>
#include <optional>
#include <vector>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

/// The variables of all rings in their order. Those of Q[u, v] are the first two.
enum class Variable { kU, kV, kS, kT };

template <std::size_t N>
class MultivariatePolynomial {
 public:
  MultivariatePolynomial() { fmpq_mpoly_init(value_, ring()); }
  MultivariatePolynomial(const Rational& constant);
  MultivariatePolynomial(long constant) : MultivariatePolynomial(Rational(constant)) {}
  explicit MultivariatePolynomial(Variable variable);
  /// coefficients[i][j] is that of u^i v^j.
  explicit MultivariatePolynomial(const std::vector<std::vector<Rational>>& coefficients);
  /// p of one of the variables.
  MultivariatePolynomial(const RationalPolynomial& p, Variable variable);
  MultivariatePolynomial(const MultivariatePolynomial& other) : MultivariatePolynomial() {
    fmpq_mpoly_set(value_, other.value_, ring());
  }
  MultivariatePolynomial(MultivariatePolynomial&& other) noexcept : MultivariatePolynomial() {
    fmpq_mpoly_swap(value_, other.value_, ring());
  }
  MultivariatePolynomial& operator=(MultivariatePolynomial other) noexcept {
    fmpq_mpoly_swap(value_, other.value_, ring());
    return *this;
  }
  ~MultivariatePolynomial() { fmpq_mpoly_clear(value_, ring()); }

  bool is_zero() const { return fmpq_mpoly_is_zero(value_, ring()) != 0; }
  bool is_constant() const { return fmpq_mpoly_is_fmpq(value_, ring()) != 0; }
  /// -1 for the zero polynomial.
  int degree(Variable variable) const;
  /// That of u^i v^j ..., one exponent for each variable.
  template <class... Exponents>
  Rational coefficient(Exponents... exponents) const {
    static_assert(sizeof...(Exponents) == N);
    return coefficient_at({static_cast<ulong>(exponents)...});
  }

  Rational at(const std::array<Rational, N>& values) const;
  template <class... Values>
  Rational operator()(const Values&... values) const {
    static_assert(sizeof...(Values) == N);
    return at({values...});
  }
  MultivariatePolynomial derivative(Variable variable) const;
  /// Polynomials, which may be of another ring, in place of the variables.
  template <std::size_t M>
  MultivariatePolynomial<M> composed(
      const std::array<MultivariatePolynomial<M>, N>& polynomials) const;
  template <std::size_t M, class... Others>
  MultivariatePolynomial<M> composed(const MultivariatePolynomial<M>& first,
                                     const Others&... others) const {
    return composed(std::array<MultivariatePolynomial<M>, N>{first, others...});
  }

  MultivariatePolynomial& operator+=(const MultivariatePolynomial& other);
  MultivariatePolynomial& operator-=(const MultivariatePolynomial& other);
  MultivariatePolynomial& operator*=(const MultivariatePolynomial& other);
  MultivariatePolynomial operator-() const;
  friend MultivariatePolynomial operator+(MultivariatePolynomial a,
                                          const MultivariatePolynomial& b) {
    return a += b;
  }
  friend MultivariatePolynomial operator-(MultivariatePolynomial a,
                                          const MultivariatePolynomial& b) {
    return a -= b;
  }
  friend MultivariatePolynomial operator*(MultivariatePolynomial a,
                                          const MultivariatePolynomial& b) {
    return a *= b;
  }
  friend bool operator==(const MultivariatePolynomial& a, const MultivariatePolynomial& b) {
    return fmpq_mpoly_equal(a.value_, b.value_, ring()) != 0;
  }
  friend bool operator!=(const MultivariatePolynomial& a, const MultivariatePolynomial& b) {
    return !(a == b);
  }

  /// FLINT's representation, for the algebra layer only.
  static const fmpq_mpoly_ctx_struct* ring();
  fmpq_mpoly_struct* flint() { return value_; }
  const fmpq_mpoly_struct* flint() const { return value_; }

 private:
  Rational coefficient_at(const std::array<ulong, N>& exponents) const;

  fmpq_mpoly_t value_;
};

using BivariatePolynomial = MultivariatePolynomial<2>;

/// Greatest common divisor, with leading coefficient 1 in the lexicographic order; zero when both
/// are zero.
template <std::size_t N>
MultivariatePolynomial<N> gcd(const MultivariatePolynomial<N>& a,
                              const MultivariatePolynomial<N>& b);

/// a / b, or nothing when b, which is not zero, does not divide a.
template <std::size_t N>
std::optional<MultivariatePolynomial<N>> quotient(const MultivariatePolynomial<N>& a,
                                                  const MultivariatePolynomial<N>& b);

/// The coefficient of the first term in the lexicographic order; zero for the zero polynomial.
template <std::size_t N>
Rational leading_coefficient(const MultivariatePolynomial<N>& p);

/// A polynomial whose square is p, or nothing when p is no square over Q.
template <std::size_t N>
std::optional<MultivariatePolynomial<N>> square_root(const MultivariatePolynomial<N>& p);

}  // namespace pn
