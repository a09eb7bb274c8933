// SPDX-License-Identifier: LGPL-2.1-or-later
// Families of conics by hand and at random, biased to multiple, common, real and infinite zeros.
//
// Every family is a function of its seed.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "pn/conics/conic_family.hpp"

namespace pn::test {

using Conic = Matrix3<RationalPolynomial>;

inline RationalPolynomial conic_polynomial(const std::vector<long>& ascending) {
  return RationalPolynomial(std::vector<Rational>(ascending.begin(), ascending.end()));
}

inline Conic diagonal(const RationalPolynomial& l, const RationalPolynomial& m,
                      const RationalPolynomial& n) {
  const RationalPolynomial zero;
  return {{{l, zero, zero}, {zero, m, zero}, {zero, zero, n}}};
}

/// S^T C S
inline Conic transformed(const Conic& c, const Conic& s) {
  Conic result;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) result[a][b] += s[i][a] * c[i][j] * s[j][b];
      }
    }
  }
  return result;
}

struct NamedConic {
  std::string kind;
  Conic matrix;
};

class RandomConics {
 public:
  explicit RandomConics(std::uint64_t seed) : generator_(seed) {}

  NamedConic next() {
    switch (below(7)) {
      case 0:
        return {"squarefree diagonal",
                diagonal(positive(degree()), positive(degree()), -positive(degree()))};
      case 1:
        return {"any matrix", any_matrix(1 + below(3))};
      case 2:
        return {"common and multiple zeros", diagonal(product(), product(), -product())};
      case 3:
        return {"two lines less a square", lines_less_square()};
      case 4:
        return {"constant in moving coordinates",
                transformed(diagonal(constant(), constant(), -constant()), any_matrix(1))};
      case 5:
        return {"moving coordinates",
                transformed(diagonal(positive(1), positive(1), -positive(1)), any_matrix(1))};
      default:
        return {"zeros 1e-6 apart", diagonal(cluster(), cluster(), -cluster())};
    }
  }

  RationalPolynomial any(int degree) {
    std::vector<long> c;
    for (int i = 0; i <= degree; ++i) c.push_back(below(19) - 9);
    return conic_polynomial(c);
  }
  /// Without real zeros, of degree 2 count.
  RationalPolynomial positive(int count) {
    RationalPolynomial p = constant();
    for (int i = 0; i < count; ++i) p *= pair();
    return p;
  }
  int below(int bound) {
    return static_cast<int>(generator_() % static_cast<std::uint64_t>(bound));
  }

 private:
  RationalPolynomial constant() { return RationalPolynomial(static_cast<long>(1 + below(5))); }
  int degree() { return below(3); }
  /// (t - a)^2 + b, b > 0.
  RationalPolynomial pair() {
    const long a = below(9) - 4, b = 1 + below(9);
    return conic_polynomial({a * a + b, -2 * a, 1});
  }
  /// Few different factors, real and not, so that they meet and repeat.
  RationalPolynomial product() {
    RationalPolynomial p = constant();
    const RationalPolynomial factors[] = {conic_polynomial({1, 0, 1}), conic_polynomial({4, 0, 1}),
                                          conic_polynomial({-1, 1}), conic_polynomial({0, 1})};
    for (const RationalPolynomial& factor : factors) {
      for (int i = below(3); i > 0; --i) p *= factor;
    }
    return p;
  }
  Conic any_matrix(int degree) {
    Conic c;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) c[i][j] = c[j][i] = any(degree);
    }
    return c;
  }
  /// l1 l2 - q l3^2 for three lines with coefficients in Q[t].
  Conic lines_less_square() {
    Vector3<RationalPolynomial> l1, l2, l3;
    for (std::size_t i = 0; i < 3; ++i) l1[i] = any(1), l2[i] = any(1), l3[i] = any(1);
    const RationalPolynomial q = any(2);
    Conic c;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        c[i][j] = l1[i] * l2[j] + l1[j] * l2[i] - q * l3[i] * l3[j];
      }
    }
    return c;
  }
  /// Two pairs of zeros 1e-6 apart near those of the other polynomials.
  RationalPolynomial cluster() {
    RationalPolynomial p = constant();
    for (int i = 0; i < 2; ++i) {
      const Rational shift = Rational(static_cast<long>(below(5) + 1)) / Rational(1000000L);
      p *= RationalPolynomial(
          {Rational(1) + shift, shift * Rational(static_cast<long>(i)), Rational(1)});
    }
    return p;
  }

  std::mt19937_64 generator_;
};

}  // namespace pn::test
