// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rational_function.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

using pn::MultivariatePolynomial;
using pn::Rational;
using pn::RationalFunction;
using pn::Variable;

namespace {

using Function = RationalFunction<2>;
using Polynomial = MultivariatePolynomial<2>;

const Polynomial kU(Variable::kU), kV(Variable::kV), kOne(1L);
const Rational kX = Rational(3L) / Rational(7L), kY = Rational(-5L) / Rational(2L);

const Function kF(kU* kU - kV, kU + Polynomial(2L) * kV);
const Function kG(kU* kV + kOne, kU* kU + kV * kV + kOne);
const Function kH(kV - Polynomial(3L), (kU + Polynomial(2L) * kV) * (kV + kOne));

}  // namespace

TEST_CASE("Functions are in lowest terms with a denominator of leading coefficient 1",
          "[rational_function]") {
  const Function f(Polynomial(6L) * (kU - kV) * (kU + kOne), Polynomial(-4L) * (kU - kV) * kV);
  CHECK(f.numerator() == (kU + kOne) * Polynomial(Rational(-3L) / Rational(2L)));
  CHECK(f.denominator() == kV);
  CHECK(f == Function(Polynomial(-3L) * (kU + kOne), Polynomial(2L) * kV));
  CHECK(Function(Polynomial(), kU).denominator() == kOne);
  CHECK(Function(5L) == Function(Polynomial(10L), Polynomial(2L)));
}

TEST_CASE("The axioms of a field hold", "[rational_function]") {
  CHECK((kF + kG) + kH == kF + (kG + kH));
  CHECK((kF * kG) * kH == kF * (kG * kH));
  CHECK(kF * (kG + kH) == kF * kG + kF * kH);
  CHECK(kF + kH == kH + kF);
  CHECK((kF - kF).is_zero());
  CHECK(kF - kF == Function());
  CHECK(kF / kF == Function(1L));
  CHECK(kF / kG * kG == kF);
  CHECK(-kF + kF == Function());
  CHECK_THROWS_AS(kF / Function(), std::domain_error);
  CHECK_THROWS_AS(Function(kU, Polynomial()), std::domain_error);
}

TEST_CASE("Values are those of the operations", "[rational_function]") {
  CHECK((kF + kH)(kX, kY) == kF(kX, kY) + kH(kX, kY));
  CHECK((kF * kH)(kX, kY) == kF(kX, kY) * kH(kX, kY));
  CHECK((kF / kG)(kX, kY) == kF(kX, kY) / kG(kX, kY));
  CHECK_THROWS_AS(kF(Rational(2L), Rational(-1L)), std::domain_error);
}

TEST_CASE("Derivatives obey the product and the quotient rule", "[rational_function]") {
  for (const Variable by : {Variable::kU, Variable::kV}) {
    CHECK((kF * kG).derivative(by) == kF.derivative(by) * kG + kF * kG.derivative(by));
    CHECK((kF / kG).derivative(by) ==
          (kF.derivative(by) * kG - kF * kG.derivative(by)) / (kG * kG));
  }
  CHECK(Function(kOne, kU).derivative(Variable::kU) == Function(-kOne, kU * kU));
  CHECK(kF.derivative(Variable::kU).derivative(Variable::kV) ==
        kF.derivative(Variable::kV).derivative(Variable::kU));
}

TEST_CASE("Composition commutes with values and obeys the chain rule", "[rational_function]") {
  const Function h = kF.composed<2>({kG, kH});
  CHECK(h(kX, kY) == kF(kG(kX, kY), kH(kX, kY)));
  CHECK(kF.composed<2>({kU, kV}) == kF);
  CHECK(h.derivative(Variable::kV) ==
        kF.derivative(Variable::kU).composed<2>({kG, kH}) * kG.derivative(Variable::kV) +
            kF.derivative(Variable::kV).composed<2>({kG, kH}) * kH.derivative(Variable::kV));
  CHECK_THROWS_AS(kF.composed<2>({Function(-2L), Function(1L)}), std::domain_error);
}

TEST_CASE("Composition leads from one field to another", "[rational_function]") {
  using Function4 = RationalFunction<4>;
  using Polynomial4 = MultivariatePolynomial<4>;
  const Polynomial4 s(Variable::kS), t(Variable::kT);
  const Function4 f = kF.composed<4>({Function4(s, t), Function4(t)});
  const Function4 expected(s * s - t * t * t, t * (s + Polynomial4(2L) * t * t));
  CHECK(f == expected);
  CHECK(f.composed<2>({Function(), Function(), Function(kU) * Function(kV), Function(kV)}) == kF);
}

TEST_CASE("Squares of functions are known from others", "[rational_function]") {
  const auto root = square_root(kF * kF * Function(Rational(9L) / Rational(4L)));
  REQUIRE(root.has_value());
  CHECK(*root * *root == kF * kF * Function(Rational(9L) / Rational(4L)));
  CHECK(square_root(kF * kG * kG * kF).has_value());
  CHECK_FALSE(square_root(kF * kG).has_value());
  CHECK_FALSE(square_root(kF * kF * Function(3L)).has_value());
  CHECK_FALSE(square_root(kF * kF * Function(kU)).has_value());
}
