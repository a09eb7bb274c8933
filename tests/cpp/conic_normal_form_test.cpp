// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/conic_normal_form.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "enclosures.hpp"

using namespace pn;
using namespace pn::test;

namespace {

/// A symmetric matrix with small entries for which e_1 + 2 e_2 - e_3 is a point.
Matrix3<Rational> conic_through_point(std::mt19937& random) {
  const auto entry = [&] { return Rational(static_cast<long>(random() % 11) - 5); };
  Matrix3<Rational> c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) c[i][j] = c[j][i] = entry();
  }
  const Rational two(2L), four(4L);
  c[2][2] = -(c[0][0] + four * c[0][1] - two * c[0][2] + four * c[1][1] - four * c[1][2]);
  return c;
}

Rational determinant_of(const Matrix3<Rational>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// The five coefficients in u of x^T C x for x = B (u0^2, u0 u1, u1^2).
template <class T>
std::array<T, 5> equation_in_u(const Matrix3<T>& c, const Matrix3<T>& b) {
  std::array<T, 5> sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t p = 0; p < 3; ++p) {
        for (std::size_t q = 0; q < 3; ++q) sum[p + q] += b[i][p] * c[i][j] * b[j][q];
      }
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("Points of a constant conic satisfy its equation, in balls and from a rational point",
          "[conic_normal_form]") {
  std::mt19937 random(3);
  int regular = 0;
  for (int repeat = 0; repeat < 40; ++repeat) {
    const Matrix3<Rational> c = conic_through_point(random);
    if (determinant_of(c).is_zero()) continue;
    ++regular;
    const auto exact = points_of_constant_conic(c, {Rational(1), Rational(2), Rational(-1)});
    for (const Rational& x : equation_in_u(c, exact)) CHECK(x.is_zero());
    CHECK_FALSE(determinant_of(exact).is_zero());
    Matrix3<RealBall> in_balls;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) in_balls[i][j] = RealBall(c[i][j], 128);
    }
    const auto points = points_of_constant_conic(in_balls);
    REQUIRE(points);
    for (const RealBall& x : equation_in_u(in_balls, *points)) CHECK(encloses_zero(x, 1e-25));
  }
  CHECK(regular > 20);
}

TEST_CASE("A definite or singular constant conic has no points in balls", "[conic_normal_form]") {
  const auto diagonal_in_balls = [](long a, long b, long c) {
    Matrix3<RealBall> m;
    m[0][0] = RealBall(a);
    m[1][1] = RealBall(b);
    m[2][2] = RealBall(c);
    return m;
  };
  CHECK_FALSE(points_of_constant_conic(diagonal_in_balls(1, 2, 3)));
  CHECK_FALSE(points_of_constant_conic(diagonal_in_balls(-1, -2, -3)));
  CHECK_FALSE(points_of_constant_conic(diagonal_in_balls(1, 0, -1)));
  CHECK(points_of_constant_conic(diagonal_in_balls(1, 2, -3)));
}
