// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/multivariate_polynomial.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

using pn::BivariatePolynomial;
using pn::MultivariatePolynomial;
using pn::Rational;
using pn::RationalPolynomial;
using pn::Variable;

namespace {

const RationalPolynomial kT({Rational(0L), Rational(1L)});
const BivariatePolynomial kU(kT, Variable::kU), kV(kT, Variable::kV);

const Rational kX = Rational(3L) / Rational(7L), kY = Rational(-5L) / Rational(2L);

const BivariatePolynomial kP =
    kU * kU * kV - BivariatePolynomial(2L) * kV + BivariatePolynomial(7L);
const BivariatePolynomial kQ = kU * kV * kV + kU - BivariatePolynomial(kX);

}  // namespace

TEST_CASE("Degrees count each variable, and cancel", "[multivariate_polynomial]") {
  CHECK(BivariatePolynomial().degree(Variable::kU) == -1);
  CHECK(BivariatePolynomial(0L).is_zero());
  CHECK(BivariatePolynomial(5L).degree(Variable::kV) == 0);
  CHECK(kP.degree(Variable::kU) == 2);
  CHECK(kP.degree(Variable::kV) == 1);
  CHECK((kP * kQ).degree(Variable::kU) == 3);
  CHECK((kP * kQ).degree(Variable::kV) == 3);
  CHECK((kP - kU * kU * kV).degree(Variable::kU) == 0);
}

TEST_CASE("Coefficients make the polynomial that they are read from", "[multivariate_polynomial]") {
  const BivariatePolynomial p = kP * kQ;
  std::vector<std::vector<Rational>> coefficients(4);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      coefficients[static_cast<std::size_t>(i)].push_back(p.coefficient(i, j));
    }
  }
  CHECK(BivariatePolynomial(coefficients) == p);
  CHECK(kP.coefficient(2, 1) == Rational(1L));
  CHECK(kP.coefficient(0, 1) == Rational(-2L));
  CHECK(kP.coefficient(9, 9).is_zero());
}

TEST_CASE("Values respect the operations of the ring", "[multivariate_polynomial]") {
  CHECK((kP * kQ)(kX, kY) == kP(kX, kY) * kQ(kX, kY));
  CHECK((kP + kQ)(kX, kY) == kP(kX, kY) + kQ(kX, kY));
  CHECK((kP - kQ)(kX, kY) == kP(kX, kY) - kQ(kX, kY));
  CHECK(-kP + kP == BivariatePolynomial());
  const RationalPolynomial p = kT * kT * kT - RationalPolynomial(kY);
  CHECK(BivariatePolynomial(p, Variable::kU)(kX, kY) == p(kX));
  CHECK(BivariatePolynomial(p, Variable::kV)(kX, kY) == p(kY));
}

TEST_CASE("Derivatives obey Leibniz and commute", "[multivariate_polynomial]") {
  for (const Variable by : {Variable::kU, Variable::kV}) {
    CHECK((kP * kQ).derivative(by) == kP.derivative(by) * kQ + kP * kQ.derivative(by));
  }
  const BivariatePolynomial p = kP * kQ;
  CHECK(p.derivative(Variable::kU).derivative(Variable::kV) ==
        p.derivative(Variable::kV).derivative(Variable::kU));
  CHECK(kU.derivative(Variable::kU) == BivariatePolynomial(1L));
  CHECK(kU.derivative(Variable::kV).is_zero());
}

TEST_CASE("Composition puts polynomials in place of the variables", "[multivariate_polynomial]") {
  CHECK(kP.composed(kU, kV) == kP);
  CHECK(kP.composed(kV, kU).coefficient(1, 2) == Rational(1L));
  CHECK(kP.composed(kQ, kU * kV)(kX, kY) == kP(kQ(kX, kY), kX * kY));
}

TEST_CASE("Common factors are found and divided out", "[multivariate_polynomial]") {
  CHECK(gcd(kP * kQ, kP * (kU + kV)) == kP);
  CHECK(gcd(kP, kQ) == BivariatePolynomial(1L));
  CHECK(gcd(BivariatePolynomial(), BivariatePolynomial()).is_zero());
  CHECK(gcd(BivariatePolynomial(), kP) == kP);
  CHECK(quotient(kP * kQ, kQ) == kP);
  CHECK_FALSE(quotient(kP, kQ).has_value());
  CHECK(quotient(BivariatePolynomial(), kQ) == BivariatePolynomial());
  CHECK_THROWS_AS(quotient(kP, BivariatePolynomial()), std::domain_error);
}

TEST_CASE("Squares are known from others", "[multivariate_polynomial]") {
  const Rational quarter = Rational(1L) / Rational(4L);
  const auto root = square_root(kP * kP * BivariatePolynomial(quarter));
  REQUIRE(root.has_value());
  CHECK(*root * *root == kP * kP * BivariatePolynomial(quarter));
  CHECK_FALSE(square_root(kP * kQ).has_value());
  CHECK_FALSE(square_root(kP * kP * BivariatePolynomial(2L)).has_value());
  CHECK_FALSE(square_root(-(kP * kP)).has_value());
  CHECK(square_root(BivariatePolynomial()) == BivariatePolynomial());
}

TEST_CASE("The leading coefficient is the first in the order of the variables",
          "[multivariate_polynomial]") {
  CHECK(leading_coefficient(BivariatePolynomial()).is_zero());
  CHECK(leading_coefficient(BivariatePolynomial(3L) * kU - kV * kV * kV) == Rational(3L));
}

TEST_CASE("Four variables", "[multivariate_polynomial]") {
  using Polynomial = MultivariatePolynomial<4>;
  const Polynomial u(Variable::kU), v(Variable::kV), s(Variable::kS), t(Variable::kT);
  const Polynomial p = u * t - v * s;
  CHECK(p.coefficient(1, 0, 0, 1) == Rational(1L));
  CHECK(p.coefficient(0, 1, 1, 0) == Rational(-1L));
  CHECK(p.derivative(Variable::kS) == -v);
  CHECK(p(kX, kY, Rational(2L), Rational(5L)) == Rational(5L) * kX - Rational(2L) * kY);
  CHECK(gcd(p * (u + s), p * (v - t)) == p);
  CHECK(quotient(p * p, p) == p);
  CHECK(square_root(p * p * s * s).has_value());
  // The determinant of (a, b) and (b, a), in the ring of two variables.
  CHECK(p.composed(kP, kQ, kQ, kP) == kP * kP - kQ * kQ);
  // A polynomial in u and v as one in s and t.
  CHECK(kP.composed(s, t).degree(Variable::kS) == 2);
  CHECK(kP.composed(s, t).derivative(Variable::kU).is_zero());
}

TEST_CASE("A ring has no more variables than it says", "[multivariate_polynomial]") {
  CHECK_THROWS_AS(kP.derivative(Variable::kT), std::out_of_range);
  CHECK_THROWS_AS(MultivariatePolynomial<3>(Variable::kT), std::out_of_range);
}
