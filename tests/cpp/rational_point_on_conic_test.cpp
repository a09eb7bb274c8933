// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rational_point_on_conic.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace pn;

namespace {

using Vector = std::array<Rational, 3>;
using RationalConic = std::array<Vector, 3>;

RationalConic diagonal_conic(const Rational& a, const Rational& b, const Rational& c) {
  const Rational zero;
  return {{{a, zero, zero}, {zero, b, zero}, {zero, zero, c}}};
}

Rational value_at(const RationalConic& conic, const Vector& x) {
  Rational sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += x[i] * conic[i][j] * x[j];
  }
  return sum;
}

void check_point(const RationalConic& conic) {
  const PointOnConic result = rational_point_on_conic(conic);
  REQUIRE(result.points == RationalPoints::kExist);
  const Vector& x = result.point;
  CHECK(value_at(conic, x).is_zero());
  CHECK(gcd(gcd(x[0], x[1]), x[2]) == Rational(1));
}

Rational power(long base, int exponent) {
  Rational result(1);
  for (int i = 0; i < exponent; ++i) result *= Rational(base);
  return result;
}

/// S^T diag(1, 1, -1) S is a conic with points for every S.
RationalConic with_points(std::mt19937& random, long size) {
  RationalConic s, conic;
  for (auto& row : s) {
    for (Rational& x : row) {
      x = Rational(static_cast<long>(random() % static_cast<unsigned long>(2 * size + 1)) - size) /
          Rational(static_cast<long>(1 + random() % 3));
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      conic[i][j] = s[0][i] * s[0][j] + s[1][i] * s[1][j] - s[2][i] * s[2][j];
    }
  }
  return conic;
}

bool is_singular(const RationalConic& m) {
  return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
          m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
          m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))
      .is_zero();
}

/// By a search, for forms with small points.
bool has_small_point(long a, long b, long c) {
  constexpr long kSize = 40;
  for (long x = 0; x <= kSize; ++x) {
    for (long y = 0; y <= kSize; ++y) {
      for (long z = 0; z <= kSize; ++z) {
        if (x + y + z > 0 && a * x * x + b * y * y + c * z * z == 0) return true;
      }
    }
  }
  return false;
}

}  // namespace

TEST_CASE("Diagonal forms have points exactly where a search finds one",
          "[rational_point_on_conic]") {
  // Holzer: the least point of a Legendre form has |x| <= sqrt(bc), |y| <= sqrt(ca), |z| <=
  // sqrt(ab).
  int exist = 0, none = 0;
  for (const long a : {1L, 2L, 3L, 5L, 6L, 8L, 12L, 18L}) {
    for (const long b : {1L, 2L, 3L, 7L, 10L, 20L}) {
      for (const long c : {-1L, -2L, -3L, -5L, -6L, -14L, -27L, -32L}) {
        INFO(a << ", " << b << ", " << c);
        const RationalConic conic = diagonal_conic(a, b, c);
        if (has_small_point(a, b, c)) {
          check_point(conic);
          ++exist;
        } else {
          CHECK(rational_point_on_conic(conic).points == RationalPoints::kNone);
          ++none;
        }
      }
    }
  }
  CHECK(exist > 50);
  CHECK(none > 50);
}

TEST_CASE("Conics with a planted point have a point", "[rational_point_on_conic]") {
  std::mt19937 random(1);
  for (const long size : {3L, 20L, 1000L}) {
    for (int repeat = 0; repeat < 40; ++repeat) {
      const RationalConic conic = with_points(random, size);
      if (!is_singular(conic)) check_point(conic);
    }
  }
}

TEST_CASE("Squares, common primes and denominators do not matter", "[rational_point_on_conic]") {
  const Rational large = power(3, 180), square(49L);
  check_point(
      diagonal_conic(Rational(3) * large, Rational(6) * square, Rational(-9) * square * large));
  check_point(diagonal_conic(Rational(1) / Rational(6), Rational(6), Rational(-1) / Rational(150)));
  check_point(diagonal_conic(Rational(15), Rational(10), Rational(-6) * Rational(25)));
}

TEST_CASE("Definite forms have no points, isotropic axes are points", "[rational_point_on_conic]") {
  CHECK(rational_point_on_conic(diagonal_conic(1, 2, 3)).points == RationalPoints::kNone);
  const Rational zero;
  check_point({{{zero, Rational(1), zero}, {Rational(1), Rational(3), zero}, {zero, zero, 2}}});
  check_point({{{Rational(1), Rational(1), zero}, {Rational(1), Rational(1), 5}, {zero, 5, 2}}});
}

TEST_CASE("Products of two large primes are not factored", "[rational_point_on_conic]") {
  // 2^89 - 1 and 2^107 - 1.
  const Rational product = (power(2, 89) - Rational(1)) * (power(2, 107) - Rational(1));
  const auto result = rational_point_on_conic(diagonal_conic(product, 3, -5));
  CHECK(result.points == RationalPoints::kUnknown);
}
