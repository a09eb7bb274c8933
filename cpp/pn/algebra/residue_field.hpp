// SPDX-License-Identifier: LGPL-2.1-or-later
// Residue fields Q[t] / (p) of irreducible polynomials p: the numbers a(c) at a root c of p,
// exactly.
//
// An element is a polynomial of lower degree than p.
//
// THEOREM (B. Trager, 1976, for the polynomial x^2 - a). Let a generate the field, and chi be its
// characteristic polynomial. Then a is a square if and only if chi(x^2) is reducible over Q; its
// square root is then the common root of x^2 - a and an irreducible factor of chi(x^2).
#pragma once

#include <optional>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

class ResidueField {
 public:
  /// The field of an irreducible polynomial, which is not constant.
  explicit ResidueField(RationalPolynomial modulus) : modulus_(std::move(modulus)) {}

  const RationalPolynomial& modulus() const { return modulus_; }

  RationalPolynomial reduced(const RationalPolynomial& a) const { return remainder(a, modulus_); }
  RationalPolynomial product(const RationalPolynomial& a, const RationalPolynomial& b) const {
    return reduced(a * b);
  }
  /// 1 / a for a != 0.
  RationalPolynomial inverse(const RationalPolynomial& a) const;
  /// One of the two roots of x^2 = a != 0, if a is a square.
  std::optional<RationalPolynomial> square_root(const RationalPolynomial& a) const;

 private:
  bool looks_like_square(const RationalPolynomial& a) const;
  RationalPolynomial characteristic_polynomial(const RationalPolynomial& a) const;

  RationalPolynomial modulus_;
};

}  // namespace pn
