// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/sign_at_real_roots.hpp"

#include <catch2/catch.hpp>

using namespace pn;

namespace {

const Rational kHalf = Rational(1L) / Rational(2L), kThird = Rational(1L) / Rational(3L);
const Rational kTiny = Rational(1L) / Rational(1000000000000L);

RationalPolynomial root(const Rational& x) { return RationalPolynomial({-x, Rational(1L)}); }

RationalPolynomial pair(const Rational& re, const Rational& im) {
  return root(re) * root(re) + RationalPolynomial(im * im);
}

}  // namespace

TEST_CASE("The signs at real roots are multiplied exactly", "[sign_at_real_roots]") {
  const RationalPolynomial p = root(kThird) * root(kHalf + kTiny) * pair(kHalf, kThird);
  // Of odd degree and negative at 1/3 only, although it changes its sign next to the other root.
  const RationalPolynomial f = root(kHalf) * pair(kThird, kTiny);
  CHECK(sign_at_real_roots(p, f) == -1);
  CHECK(sign_at_real_roots(p, -f) == -1);
  CHECK(sign_at_real_roots(-p, f) == -1);
  CHECK(sign_at_real_roots(-p, f * f) == 1);
  CHECK(sign_at_real_roots(p * root(kThird), f) == 1);
  CHECK(sign_at_real_roots(p * root(-kHalf) * root(-kHalf), f) == -1);
  CHECK(sign_at_real_roots(-p * root(-kHalf), f) == 1);
}

TEST_CASE("No real roots, and common ones", "[sign_at_real_roots]") {
  const RationalPolynomial nonreal = pair(kHalf, kTiny), p = root(kThird) * nonreal * nonreal;
  CHECK(sign_at_real_roots(nonreal, RationalPolynomial(-1L)) == 1);
  CHECK(sign_at_real_roots(nonreal, RationalPolynomial()) == 1);
  CHECK(sign_at_real_roots(RationalPolynomial(-3L), root(kHalf)) == 1);
  CHECK(sign_at_real_roots(p, root(kHalf) * nonreal) == -1);
  CHECK(sign_at_real_roots(p, root(kThird) * nonreal) == std::nullopt);
  CHECK(sign_at_real_roots(p, RationalPolynomial()) == std::nullopt);
}
