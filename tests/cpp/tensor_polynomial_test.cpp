// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/tensor_polynomial.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace pn;

namespace {

using Polynomial = TensorPolynomial<Rational>;

Polynomial random_polynomial(int m, int n, std::mt19937_64& random) {
  Polynomial p(m, n);
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) p(i, j) = Rational(static_cast<long>(random() % 11) - 5);
  }
  return p;
}

}  // namespace

TEST_CASE("Products, sums and derivatives are those of the ring", "[tensor_polynomial]") {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 10; ++trial) {
    const Polynomial p = random_polynomial(3, 2, random), q = random_polynomial(1, 4, random);
    const BivariatePolynomial a = in_ring(p), b = in_ring(q);
    CHECK(in_ring(p * q) == a * b);
    CHECK(in_ring(p + q) == a + b);
    CHECK(in_ring(q - p) == b - a);
    CHECK(in_ring(p * Rational(3L)) == a * BivariatePolynomial(3L));
    for (const Variable variable : {Variable::kU, Variable::kV}) {
      CHECK(in_ring(p.derivative(variable)) == a.derivative(variable));
    }
    const Rational u = Rational(2L) / Rational(3L), v = Rational(-5L) / Rational(7L);
    CHECK(p.at(u, v) == a(u, v));
    CHECK(in_ring(dense(a)) == a);
  }
}

TEST_CASE("Bernstein coefficients on the unit square give the polynomial back",
          "[tensor_polynomial]") {
  std::mt19937_64 random(2);
  const Polynomial p = random_polynomial(3, 2, random);
  const auto b = to_bernstein(p);
  const Rational u = Rational(1L) / Rational(3L), v = Rational(4L) / Rational(5L), one(1L);
  const auto power = [](const Rational& x, int n) {
    Rational result(1L);
    for (int i = 0; i < n; ++i) result *= x;
    return result;
  };
  const long rows[] = {1, 3, 3, 1}, columns[] = {1, 2, 1};
  Rational sum;
  for (int i = 0; i <= 3; ++i) {
    for (int j = 0; j <= 2; ++j) {
      sum += b[static_cast<std::size_t>(3 * i + j)] * Rational(rows[i] * columns[j]) * power(u, i) *
             power(one - u, 3 - i) * power(v, j) * power(one - v, 2 - j);
    }
  }
  CHECK(sum == p.at(u, v));
}

TEST_CASE("Affine functions in place of a variable, at the same degrees", "[tensor_polynomial]") {
  std::mt19937_64 random(3);
  const Polynomial p = random_polynomial(3, 2, random);
  const Rational c(2L), a(-3L), u = Rational(1L) / Rational(7L), v(5L);
  const Polynomial in_u = p.substituted(Variable::kU, c, a),
                   in_v = p.substituted(Variable::kV, c, a);
  CHECK(in_u.at(u, v) == p.at(c + a * u, v));
  CHECK(in_v.at(u, v) == p.at(u, c + a * v));
  for (const Polynomial* q : {&in_u, &in_v}) {
    CHECK(q->degree(Variable::kU) == 3);
    CHECK(q->degree(Variable::kV) == 2);
  }
  const Polynomial times_u = p * Polynomial::linear(Rational(0L), Rational(1L), Rational(0L));
  CHECK(in_ring(times_u.divided_by_u()) == in_ring(p));
}

TEST_CASE("Dense degrees drop to those that the polynomial has", "[tensor_polynomial]") {
  Polynomial p(4, 5);
  p(2, 1) = Rational(3L);
  const Polynomial low = dense(in_ring(p));
  CHECK(low.degree(Variable::kU) == 2);
  CHECK(low.degree(Variable::kV) == 1);
  CHECK(low(2, 1) == Rational(3L));
}
