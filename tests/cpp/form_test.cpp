// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/form.hpp"

#include <catch2/catch.hpp>

using pn::Form;
using pn::Rational;
using RationalForm = Form<Rational>;

namespace {

RationalForm form(std::initializer_list<long> coefficients) {
  std::vector<Rational> result;
  for (const long c : coefficients) result.emplace_back(c);
  return RationalForm(std::move(result));
}

}  // namespace

TEST_CASE("The formal degree does not depend on the coefficients", "[form]") {
  CHECK(form({1, 2, 0}).degree() == 2);
  CHECK(form({1, 2, 0}).at_infinity() == Rational(0L));
  CHECK(RationalForm().degree() == -1);
  CHECK(RationalForm().at_infinity().is_zero());
  CHECK((form({1, 2, 0}) * form({0, 0})).degree() == 3);
  CHECK((form({1, 2}) * RationalForm()).degree() == -1);
}

TEST_CASE("Sums and products have the values of sums and products", "[form]") {
  const RationalForm a = form({3, -1, 2}), b = form({5, 0, -7});
  const Rational t = Rational(4L) / Rational(3L);
  CHECK((a * b)(t) == a(t) * b(t));
  CHECK((a + b)(t) == a(t) + b(t));
  CHECK((a - b)(t) == a(t) - b(t));
  CHECK((a * Rational(9L))(t) == Rational(9L) * a(t));
  CHECK((a * b).at_infinity() == a.at_infinity() * b.at_infinity());
  CHECK(a.elevated(6)(t) == a(t));
  CHECK(a.elevated(6).degree() == 6);
  CHECK((RationalForm() + a).coefficients() == a.coefficients());
}

TEST_CASE("A product that is added to a form raises its degree where it has to", "[form]") {
  const RationalForm a = form({3, -1, 2}), b = form({5, 7});
  const Rational t = Rational(4L) / Rational(3L);
  for (const RationalForm& before : {RationalForm(), form({1, 4}), form({1, 0, 0, 0, 2})}) {
    RationalForm sum = before;
    sum.add_product(a, b);
    CHECK(sum(t) == before(t) + a(t) * b(t));
    CHECK(sum.degree() == std::max(3, before.degree()));
    CHECK(sum.add_product(a, RationalForm())(t) == before(t) + a(t) * b(t));
  }
}

TEST_CASE("A form on an interval is composed with the linear map", "[form]") {
  const RationalForm a = form({3, -1, 2, 5});
  const Rational origin = Rational(1L) / Rational(7L), length = Rational(-2L),
                 t = Rational(3L) / Rational(5L);
  const RationalForm part = a.on_interval(origin, length);
  CHECK(part.degree() == a.degree());
  CHECK(part(t) == a(origin + length * t));
}

TEST_CASE("The derivative obeys Leibniz and keeps its formal degree", "[form]") {
  const RationalForm a = form({3, -1, 2}), b = form({5, 0, -7, 1});
  CHECK((a * b).derivative().coefficients() ==
        (a.derivative() * b + a * b.derivative()).coefficients());
  CHECK(form({1, 2, 0}).derivative().degree() == 1);
  CHECK(b.slope(Rational(3L)) == b.derivative()(Rational(3L)));
  CHECK(form({4}).derivative().coefficients() == form({0}).coefficients());
}

TEST_CASE("Division by a root undoes multiplication, from either end", "[form]") {
  const pn::ComplexBall inside(pn::RealBall(0.5), pn::RealBall(-0.25)),
      outside(pn::RealBall(-3), pn::RealBall(2));
  const Form<pn::ComplexBall> quotient(
      {pn::ComplexBall(2.0), inside, outside, pn::ComplexBall(1.0)});
  for (const pn::ComplexBall& root : {inside, outside}) {
    const Form<pn::ComplexBall> product =
        quotient * Form<pn::ComplexBall>({-root, pn::ComplexBall(1.0)});
    for (const bool beyond : {false, true}) {
      const auto back = divided_by_root(product, root, beyond);
      REQUIRE(back.degree() == quotient.degree());
      for (int i = 0; i <= back.degree(); ++i) {
        CHECK((back[i] - quotient[i]).contains_zero());
        CHECK(std::abs((back[i] - quotient[i]).midpoint()) < 1e-15);
      }
    }
  }
  CHECK(divided_by_infinity(form({1, 2, 0})).coefficients() == form({1, 2}).coefficients());
  CHECK(divided_by_root(Form<double>({0.0}), 2.0, true).degree() == -1);
}

TEST_CASE("Conjugation acts on the coefficients", "[form]") {
  const Form<std::complex<double>> a({{1, 2}, {0, -1}});
  CHECK(conj(a).coefficients() == std::vector<std::complex<double>>{{1, -2}, {0, 1}});
}
