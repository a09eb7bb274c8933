// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/elimination.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace pn;

namespace {

using Polynomial = MultivariatePolynomial<4>;
const Polynomial u(Variable::kU), v(Variable::kV), s(Variable::kS), t(Variable::kT);

bool contains(const std::vector<Polynomial>& factors, const Polynomial& p) {
  return std::any_of(factors.begin(), factors.end(),
                     [&](const Polynomial& x) { return quotient(x, p) && quotient(p, x); });
}

}  // namespace

TEST_CASE("Factors are found once each, over Q only", "[elimination]") {
  const Polynomial a = s * u - t, b = u * u - Polynomial(2L) * v * v, c = u * v + s;
  const auto factors = irreducible_factors(a * a * b * c * Polynomial(6L));
  CHECK(factors.size() == 3);
  for (const Polynomial& factor : {a, b, c}) CHECK(contains(factors, factor));
  CHECK(irreducible_factors(Polynomial(6L)).empty());
  CHECK(irreducible_factors(Polynomial()).empty());
}

TEST_CASE("A resultant vanishes exactly at common zeros", "[elimination]") {
  const Polynomial p = s * u + v - t, q = u * v - s;
  const Polynomial r = resultant(p, q, Variable::kU);
  CHECK(r.degree(Variable::kU) == 0);
  // From p, u = (t - v) / s; in q that is (t - v) v / s - s.
  const Polynomial expected = (t - v) * v - s * s;
  CHECK((r == expected || r == -expected));
  CHECK(resultant(p * q, p, Variable::kU).is_zero());
}
