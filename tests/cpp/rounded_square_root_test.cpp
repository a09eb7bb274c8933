// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rounded_square_root.hpp"

#include <catch2/catch.hpp>

using namespace pn;

TEST_CASE("Rounded square roots are as near as they promise", "[rational]") {
  CHECK(rounded_square_root(Rational(9L) / Rational(4L), 8) == Rational(3L) / Rational(2L));
  // Twice the relative error of the root is that of its square, about.
  const Rational bound = Rational::exactly(0x1p-18);
  for (const Rational& x : {Rational(2L), Rational(1L) / Rational(3L), Rational::exactly(1e-9)}) {
    const Rational root = rounded_square_root(x, 20);
    const Rational error = root * root / x - Rational(1L);
    CHECK(error < bound);
    CHECK(-bound < error);
    CHECK_FALSE(error.is_zero());
  }
}
