// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/negative_interval.hpp"

#include <catch2/catch.hpp>

using namespace pn;

namespace {

std::optional<NegativeInterval> found(const std::vector<Rational>& ascending) {
  const RationalPolynomial p(ascending);
  return first_negative_interval(p, roots_in_unit_interval(p));
}

}  // namespace

TEST_CASE("The first interval where a polynomial is negative", "[negative_interval]") {
  // 16 (t - 1/4) (t - 3/4)
  const auto inner = found({3, -16, 16});
  REQUIRE(inner);
  CHECK(inner->begin == 0.25);
  CHECK(inner->end == 0.75);
  const auto all = found({-1});
  REQUIRE(all);
  CHECK(all->begin == 0);
  CHECK(all->end == 1);
  // Touching zero is not negative.
  CHECK_FALSE(found({1, -4, 4}));
  CHECK_FALSE(found({0, 1}));
}
