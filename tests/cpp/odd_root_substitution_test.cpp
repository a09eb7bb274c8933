// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/odd_root_substitution.hpp"

#include <catch2/catch.hpp>

#include "circle_families.hpp"
#include "enclosures.hpp"
#include "pn/isotropic/envelope.hpp"

using namespace pn;
using namespace pn::test;

namespace {

RationalPolynomial root(long r) { return polynomial({-r, 1}); }

/// M = ((f + g) / 2, 0, 0) and R = (f - g) / 2, turned: D = f g.
CircleFamily family(const RationalPolynomial& f, const RationalPolynomial& g) {
  return turned({{f + g, 0L, 0L}, f - g});
}

/// D in the local parameter.
Form<RealBall> discriminant(const CircleForms<RealBall>& circles) {
  auto d = circles.level * circles.level * RealBall(-1);
  for (const auto& axis : circles.axis) d += axis * axis;
  return d;
}

/// The product of (s - c)^2p over all roots, real ones with 2q, as a form of the degree that is
/// left when those at infinity are dropped.
Form<RealBall> product_of_squares(const DoubleRoots& roots) {
  auto product = Form<RealBall>::constant(RealBall(1));
  for (const ConjugatePair& pair : roots.pairs) {
    const RealBall x = pair.value.real(), y = pair.value.imag();
    const Form<RealBall> quadratic({x * x + y * y, RealBall(-2) * x, RealBall(1)});
    for (int copy = 0; copy < pair.multiplicity; ++copy) product = product * quadratic;
  }
  for (const DoubleRoots::Real& real : roots.real) {
    const Form<RealBall> linear({-real.value, RealBall(1)});
    for (int copy = 0; copy < 2 * real.copies; ++copy) product = product * linear;
  }
  return product;
}

}  // namespace

TEST_CASE("In the local parameter D has exactly these roots, none of odd multiplicity and real",
          "[odd_root_substitution]") {
  const std::vector<CircleFamily> families = {
      family(root(-1), -root(2)),
      family(root(-1), 1L),
      family(-root(2), 1L),
      family(root(-1) * root(5), root(2) * root(-3)),
      family(root(-1) * polynomial({3, 1, 1}), -root(2) * polynomial({2, 0, 1})),
      family(root(-1) * root(-1) * root(-1), -root(2)),
      family(root(-1) * root(-4) * root(-4), -root(2)),
      // No odd root: the parameter stays t.
      family(polynomial({3, 1, 1}), polynomial({2, 0, 1})),
      family(root(-1) * root(-1), polynomial({2, 0, 1})),
  };
  for (const CircleFamily& circles : families) {
    const auto [parameter, roots] = local_family(circles, 256);
    const auto d = discriminant(circle_forms(circles, *parameter));
    const auto product = product_of_squares(roots);
    CHECK(product.degree() + 2 * roots.infinite_copies == d.degree());
    const RealBall lead = d[product.degree()];
    REQUIRE_FALSE(lead.contains_zero());
    for (int i = 0; i <= d.degree(); ++i) {
      const RealBall expected = i <= product.degree() ? product[i] * lead : RealBall(0);
      CHECK(encloses_zero(d[i] - expected, 1e-30 * (1 + lead.magnitude_upper())));
    }
  }
}

TEST_CASE("Without odd real roots the parameter stays t", "[odd_root_substitution]") {
  const auto circles = family(polynomial({3, 1, 1}), polynomial({2, 0, 1}));
  const auto family = local_family(circles, 128);
  CHECK_FALSE(family.parameter->is_substituted());
  const auto level = family.parameter->form(circles.level, circles.degree());
  REQUIRE(level.degree() == circles.degree());
  for (int i = 0; i <= circles.degree(); ++i) {
    CHECK(level[i].contains(circles.level.coefficient(i)));
  }
}

TEST_CASE("The denominator of the substitution stays between 1/2 and 1",
          "[odd_root_substitution]") {
  const auto local = local_family(family(root(-1), -root(2)), 128);
  REQUIRE(local.parameter->is_substituted());
  const auto denominator = local.parameter->form(1L, 1);
  for (const double s : {0.0, 0.25, 0.5, 1.0}) {
    const RealBall q = denominator(RealBall(s).at_precision(128));
    CHECK(q.upper() <= 1 + 1e-15);
    CHECK(q.lower() >= 0.5);
  }
}
