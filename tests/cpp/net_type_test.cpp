// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/net_type.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "minkowski_cases.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Line = LineCoordinates<Rational>;

Line combination(const Rational& k, const Line& a, const Rational& l, const Line& b) {
  Line result;
  for (std::size_t i = 0; i < 6; ++i) result[i] = k * a[i] + l * b[i];
  return result;
}

}  // namespace

TEST_CASE("The type of a net with known axes does not depend on its complexes", "[minkowski]") {
  RandomRationals random(23);
  const MinkowskiVector<Rational> x = {1L, 0L, 0L, 0L}, y = {0L, 1L, 0L, 0L}, z = {0L, 0L, 1L, 0L},
                                  r = {0L, 0L, 0L, 1L}, touching = {0L, 1L, 0L, 1L};
  const auto type = [&](const Line& a, const Line& b) {
    const Rational k = random() + Rational(40L), l = random(), m = random();
    return name(net_type({combination(k, a, l, b), combination(m, a, k, b)}));
  };
  CHECK(type(join(x, y), join(z, r)) == "hyperbolic S/P polar");
  CHECK(type(join(x, y), join(translated(z, Rational(1L) / Rational(3L), x), r)) ==
        "hyperbolic S/P");
  CHECK(type(join(x, r), join(y, translated(z, Rational(2L), r))) == "hyperbolic S/S");
  CHECK(type(join(x, touching), join(z, r)) == "hyperbolic S/T");
  CHECK(type(join(x, y), join(x, z)) == "singular");
  CHECK_THROWS_AS(type(join(x, y), join(y, x)), std::domain_error);
}

TEST_CASE("Axes that are irrational have their positions too", "[minkowski]") {
  // On k a + l b the forms are K = 2 k^2 - 4 l^2 or 2 k^2 + 4 l^2, and O is a multiple of l^2.
  const Line a = {1L, 0L, 0L, 1L, 0L, 0L};
  CHECK(name(net_type({a, {0L, 2L, 0L, 0L, -1L, 0L}})) == "hyperbolic P/P");
  CHECK(name(net_type({a, {0L, 1L, 0L, 0L, -2L, 0L}})) == "hyperbolic S/S");
  CHECK(name(net_type({a, {0L, 2L, 0L, 0L, 1L, 0L}})) == "elliptic S/S");
  CHECK(name(net_type({a, {0L, 1L, 0L, 0L, 1L, 0L}})) == "elliptic T/T");
}
