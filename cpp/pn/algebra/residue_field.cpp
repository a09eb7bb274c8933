// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/residue_field.hpp"

#include <flint/fmpq_mat.h>
#include <flint/nmod_poly.h>
#include <flint/nmod_poly_factor.h>
#include <flint/ulong_extras.h>

#include <utility>

namespace pn {
namespace {

/// A polynomial over Q modulo a prime that does not divide its denominator.
class ModularPolynomial {
 public:
  ModularPolynomial(const RationalPolynomial& p, ulong prime) {
    nmod_poly_init(value_, prime);
    fmpz_poly_t numerator;
    fmpz_poly_init(numerator);
    fmpq_poly_get_numerator(numerator, p.flint());
    fmpz_poly_get_nmod_poly(value_, numerator);
    fmpz_poly_clear(numerator);
    const ulong denominator = fmpz_fdiv_ui(fmpq_poly_denref(p.flint()), prime);
    is_defined_ = denominator != 0;
    if (is_defined_) nmod_poly_scalar_mul_nmod(value_, value_, n_invmod(denominator, prime));
  }
  ModularPolynomial(const ModularPolynomial&) = delete;
  ModularPolynomial& operator=(const ModularPolynomial&) = delete;
  ~ModularPolynomial() { nmod_poly_clear(value_); }

  bool is_defined() const { return is_defined_; }
  const nmod_poly_struct* get() const { return value_; }

 private:
  nmod_poly_t value_;
  bool is_defined_;
};

/// At the simple roots of the modulus modulo a prime, a square takes squares for values.
bool is_square_at_roots(const ModularPolynomial& modulus, const ModularPolynomial& a, ulong prime) {
  nmod_poly_factor_t factors;
  nmod_poly_factor_init(factors);
  nmod_poly_factor(factors, modulus.get());
  bool all_squares = true;
  for (slong i = 0; i < factors->num; ++i) {
    const nmod_poly_struct* factor = factors->p + i;
    if (nmod_poly_degree(factor) != 1 || factors->exp[i] != 1) continue;
    const ulong root = n_negmod(nmod_poly_get_coeff_ui(factor, 0), prime);
    const ulong value = nmod_poly_evaluate_nmod(a.get(), root);
    all_squares = all_squares && n_jacobi_unsigned(value, prime) != -1;
  }
  nmod_poly_factor_clear(factors);
  return all_squares;
}

/// chi(x^2).
RationalPolynomial chi_of_square(const RationalPolynomial& chi) {
  std::vector<Rational> spread(static_cast<std::size_t>(2 * chi.degree() + 1));
  for (int i = 0; i <= chi.degree(); ++i)
    spread[static_cast<std::size_t>(2 * i)] = chi.coefficient(i);
  return RationalPolynomial(spread);
}

}  // namespace

RationalPolynomial ResidueField::inverse(const RationalPolynomial& a) const {
  return reduced(extended_gcd(a, modulus_).x);
}

/// A non-square of the field fails at half of the roots modulo primes, of which each prime has one
/// on average: what passes is nearly always a square, and only then is the proof worth its cost.
bool ResidueField::looks_like_square(const RationalPolynomial& a) const {
  constexpr int kPrimes = 24;
  ulong prime = 1000;
  for (int i = 0; i < kPrimes; ++i) {
    prime = n_nextprime(prime, 1);
    const ModularPolynomial modulus(modulus_, prime), value(a, prime);
    if (modulus.is_defined() && value.is_defined() && !is_square_at_roots(modulus, value, prime)) {
      return false;
    }
  }
  return true;
}

/// Of the multiplication with a.
RationalPolynomial ResidueField::characteristic_polynomial(const RationalPolynomial& a) const {
  const int n = modulus_.degree();
  fmpq_mat_t matrix;
  fmpq_mat_init(matrix, n, n);
  RationalPolynomial column = reduced(a);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      fmpq_set(fmpq_mat_entry(matrix, i, j), column.coefficient(i).flint());
    }
    column = product(column, power_of_t(1));
  }
  RationalPolynomial result;
  fmpq_mat_charpoly(result.flint(), matrix);
  fmpq_mat_clear(matrix);
  return result;
}

std::optional<RationalPolynomial> ResidueField::square_root(const RationalPolynomial& a) const {
  if (!looks_like_square(a)) return std::nullopt;
  // a s^2 is a square with a, and all but finitely many s make it a generator.
  for (long shift = 0;; ++shift) {
    const RationalPolynomial s =
        shift == 0 ? RationalPolynomial(1L) : reduced(power_of_t(1) + RationalPolynomial(shift));
    if (s.is_zero()) continue;
    const RationalPolynomial b = product(a, product(s, s));
    const RationalPolynomial chi = characteristic_polynomial(b);
    if (gcd(chi, chi.derivative()).degree() > 0) continue;
    const std::vector<RationalPolynomial> factors = irreducible_factors(chi_of_square(chi));
    if (factors.size() == 1) return std::nullopt;
    // At x^2 = b the factor is even + odd x, so x = -even / odd.
    RationalPolynomial even, odd;
    for (int i = factors.front().degree(); i >= 0; --i) {
      RationalPolynomial& part = i % 2 == 0 ? even : odd;
      part = product(part, b) + RationalPolynomial(factors.front().coefficient(i));
    }
    return product(-product(even, inverse(odd)), inverse(s));
  }
}

}  // namespace pn
