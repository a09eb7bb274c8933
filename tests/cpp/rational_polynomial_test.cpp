// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rational_polynomial.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

using pn::Rational;
using pn::RationalPolynomial;

namespace {

const RationalPolynomial kT({Rational(0L), Rational(1L)});

RationalPolynomial power(const RationalPolynomial& p, int exponent) {
  RationalPolynomial result(1L);
  for (int i = 0; i < exponent; ++i) result *= p;
  return result;
}

RationalPolynomial linear(long root) { return kT - RationalPolynomial(root); }

}  // namespace

TEST_CASE("The degree is that of the last coefficient that is not zero", "[rational_polynomial]") {
  CHECK(RationalPolynomial().degree() == -1);
  CHECK(RationalPolynomial(0L).is_zero());
  CHECK(RationalPolynomial(5L).degree() == 0);
  CHECK(RationalPolynomial({Rational(1L), Rational(2L), Rational(0L)}).degree() == 1);
  CHECK((kT * kT - kT * kT + kT).degree() == 1);
  CHECK(coefficients(linear(3), 3) ==
        std::vector<Rational>{Rational(-3L), Rational(1L), Rational(0L), Rational(0L)});
}

TEST_CASE("Values, products and derivatives agree", "[rational_polynomial]") {
  const RationalPolynomial p = linear(2) * power(linear(-1), 3) + RationalPolynomial(7L);
  const RationalPolynomial q = power(linear(5), 2) - kT;
  const Rational x = Rational(3L) / Rational(7L);
  CHECK((p * q)(x) == p(x) * q(x));
  CHECK((p - q)(x) == p(x) - q(x));
  CHECK((p * q).derivative() == p.derivative() * q + p * q.derivative());
  CHECK(RationalPolynomial(3L).derivative().is_zero());
  CHECK(-p + p == RationalPolynomial());
}

TEST_CASE("Restriction to an interval composes with the linear map", "[rational_polynomial]") {
  const RationalPolynomial p = power(linear(1), 3) * linear(-4);
  const Rational origin = Rational(-2L), length = Rational(3L) / Rational(5L),
                 x = Rational(2L) / Rational(9L);
  CHECK(p.on_interval(origin, length)(x) == p(origin + length * x));
  CHECK(p.on_interval(Rational(0L), Rational(1L)) == p);
}

TEST_CASE("The gcd is monic and divides both exactly", "[rational_polynomial]") {
  const RationalPolynomial common = linear(1) * (kT * kT + RationalPolynomial(1L));
  const RationalPolynomial a = common * linear(2) * RationalPolynomial(6L), b = common * linear(3);
  CHECK(gcd(a, b) == common);
  CHECK(exact_quotient(a, common) * common == a);
  CHECK(gcd(linear(1), linear(2)) == RationalPolynomial(1L));
  CHECK(gcd(RationalPolynomial(), RationalPolynomial()).is_zero());
  CHECK(gcd(RationalPolynomial(), a * RationalPolynomial(2L)) == gcd(a, a));
}

TEST_CASE("A division that leaves a remainder is refused", "[rational_polynomial]") {
  CHECK_THROWS_AS(exact_quotient(linear(1), linear(2)), std::domain_error);
  CHECK_THROWS_AS(exact_quotient(linear(1), RationalPolynomial()), std::domain_error);
  CHECK(exact_quotient(RationalPolynomial(), linear(2)).is_zero());
}

TEST_CASE("A root is divided out as often as it occurs", "[rational_polynomial]") {
  const RationalPolynomial rest = linear(2) * (kT * kT + kT + RationalPolynomial(1L));
  CHECK((power(linear(0), 2) * rest).without_root(Rational(0L)) == rest);
  CHECK((power(linear(1), 3) * rest).without_root(Rational(1L)) == rest);
  CHECK(rest.without_root(Rational(1L)) == rest);
  CHECK(RationalPolynomial().without_root(Rational(1L)).is_zero());
}

TEST_CASE("The squarefree factors reproduce the polynomial", "[rational_polynomial]") {
  const RationalPolynomial half(Rational(1L) / Rational(2L));
  const RationalPolynomial p = half * power(linear(1), 3) *
                               power(kT * kT + RationalPolynomial(2L), 2) * linear(-5) *
                               power(linear(4), 3);
  RationalPolynomial product(p.coefficient(p.degree()));
  const auto factors = squarefree_factorization(p);
  CHECK(factors.size() == 3);
  for (const auto& [factor, multiplicity] : factors) {
    CHECK(factor.degree() >= 1);
    CHECK(factor.coefficient(factor.degree()) == Rational(1L));
    CHECK(gcd(factor, factor.derivative()) == RationalPolynomial(1L));
    product *= power(factor, multiplicity);
  }
  CHECK(product == p);
  CHECK(squarefree_factorization(RationalPolynomial(3L)).empty());
}
