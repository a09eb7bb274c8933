// SPDX-License-Identifier: LGPL-2.1-or-later
// Circle families whose discriminant has planted roots.
//
// For H = [[0, f], [f~, c]] the discriminant is |f|^2, so the roots of f, a polynomial over Q(i),
// are those of D: a nonreal one of multiplicity p gives a pair of multiplicity p, a real one a
// double root, and a degree less than that of c a double root at infinity.
#pragma once

#include <array>
#include <vector>

#include "pn/isotropic/sphere_curve.hpp"

namespace pn::test {

/// A polynomial over Q(i).
struct GaussianPolynomial {
  RationalPolynomial re, im;
  friend GaussianPolynomial operator*(const GaussianPolynomial& a, const GaussianPolynomial& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
};

/// t - (re + i im).
inline GaussianPolynomial factor(long re, long im) {
  return {RationalPolynomial({Rational(-re), Rational(1L)}), RationalPolynomial(-im)};
}

inline GaussianPolynomial product(const std::vector<GaussianPolynomial>& factors) {
  GaussianPolynomial result{1L, 0L};
  for (const GaussianPolynomial& f : factors) result = result * f;
  return result;
}

inline RationalPolynomial polynomial(const std::vector<long>& coefficients) {
  std::vector<Rational> result;
  for (const long c : coefficients) result.emplace_back(c);
  return RationalPolynomial(result);
}

/// The family of H = [[0, f], [f~, 2 c]]: R = c, M = (Re f, -Im f, -c).
inline CircleFamily planted_family(const GaussianPolynomial& f, const RationalPolynomial& c) {
  return {{f.re, -f.im, -c}, c};
}

/// The family with its axis turned by the rational rotation of quaternion 1 + 2i - j + k, so that
/// no component vanishes by construction.
inline CircleFamily turned(const CircleFamily& family) {
  // 7 times the rotation of the unit quaternion (1, 2, -1, 1) / sqrt(7).
  static const std::array<std::array<long, 3>, 3> rotation = {
      {{3, -6, 2}, {-2, -3, -6}, {6, 2, -3}}};
  CircleFamily result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result.axis[i] += RationalPolynomial(rotation[i][j]) * family.axis[j];
    }
  }
  result.level = RationalPolynomial(7L) * family.level;
  return result;
}

}  // namespace pn::test
