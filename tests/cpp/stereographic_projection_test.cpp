// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/stereographic_projection.hpp"

#include <catch2/catch.hpp>

#include "pn/algebra/rational_function.hpp"
#include "pn/algebra/tensor_polynomial.hpp"

using namespace pn;

namespace {

template <class T, std::size_t N>
std::array<std::array<T, N>, N> diagonal_matrix(const std::array<T, N>& entries) {
  std::array<std::array<T, N>, N> result{};
  for (std::size_t i = 0; i < N; ++i) result[i][i] = entries[i];
  return result;
}

}  // namespace

TEST_CASE("Stereographic projection of a conic is the formula (1.29), identically",
          "[stereographic_projection]") {
  // In Q(c1, c2, u) for a point f = (1, 2, 3): c0 = -4 c1 - 9 c2.
  using F = RationalFunction<3>;
  const auto variable = [](Variable v) { return F(MultivariatePolynomial<3>(v)); };
  const F c1 = variable(Variable::kU), c2 = variable(Variable::kV), u = variable(Variable::kS);
  const F c0 = F(-4L) * c1 + F(-9L) * c2;
  const std::array<F, 3> f = {F(1L), F(2L), F(3L)}, q = {F(0L), F(1L), u};
  const auto c = diagonal_matrix<F, 3>({c0, c1, c2});
  REQUIRE(polar_form(c, f, f).is_zero());
  const auto x = stereographic_projection(c, f, q);
  const F lambda = c1 + c2 * u * u, mu = F(-2L) * (c1 * f[1] + c2 * f[2] * u);
  CHECK(x == std::array<F, 3>{lambda * f[0], lambda * f[1] + mu, lambda * f[2] + mu * u});
  CHECK(polar_form(c, x, x).is_zero());
}

TEST_CASE("Stereographic projection of a quadric is the formula (1.32), identically",
          "[stereographic_projection]") {
  // x0^2 + x1^2 + x2^2 - x3^2 - x4^2 = 0
  using P = MultivariatePolynomial<3>;
  const P one(1L), u1(Variable::kU), u2(Variable::kV), u3(Variable::kS);
  const P s = u1 * u1 + u2 * u2 - u3 * u3;
  const auto c = diagonal_matrix<P, 5>({one, one, one, -one, -one});
  const auto x =
      stereographic_projection<P, 5>(c, {one, P(), P(), P(), one}, {one, u1, u2, u3, P()});
  const P minus_two(-2L);
  CHECK(x == std::array<P, 5>{s - one, minus_two * u1, minus_two * u2, minus_two * u3, s + one});
  CHECK(polar_form(c, x, x).is_zero());
}

TEST_CASE("The second tangent through a point of a tangent, dually", "[stereographic_projection]") {
  // Lines a x + b y + c = 0 touch the unit circle where a^2 + b^2 = c^2. The tangent y = 1 and the
  // line through (s, 1) and the centre, x - s y = 0, span the pencil of (s, 1).
  using P = RationalPolynomial;
  const P s = power_of_t(1);
  const auto c = diagonal_matrix<P, 3>({1L, 1L, P(-1L)});
  const std::array<P, 3> tangent = {0L, 1L, P(-1L)}, line = {1L, -s, 0L};
  const auto second = stereographic_projection(c, tangent, line);
  CHECK(polar_form(c, second, second).is_zero());
  CHECK((second[0] * s + second[1] + second[2]).is_zero());
  CHECK_FALSE(second[0].is_zero());
}

TEST_CASE("In balls the projected points enclose zero narrowly", "[stereographic_projection]") {
  using P = TensorPolynomial<RealBall>;
  const auto number = [](long x) { return P::constant(RealBall(Rational(x) / Rational(7L), 128)); };
  const auto c = diagonal_matrix<P, 3>({number(9), number(16), number(-25)});
  const P u = P::linear(RealBall(0L), RealBall(0L), RealBall(1L));
  const auto x =
      stereographic_projection<P, 3>(c, {number(1), number(1), number(1)}, {P(), number(1), u});
  const P zero = polar_form(c, x, x);
  for (const RealBall& k : zero.coefficients()) {
    CHECK(k.contains_zero());
    CHECK(k.magnitude_upper() < 1e-30);
  }
}
