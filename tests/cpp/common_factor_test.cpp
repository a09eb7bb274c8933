// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/common_factor.hpp"

#include <array>
#include <catch2/catch.hpp>

using pn::coprime;
using pn::RationalPolynomial;

TEST_CASE("Coprime entries are proportional to those given, and have no common root",
          "[common_factor]") {
  const RationalPolynomial t({0L, 1L}), a({2L, 1L}), b({-3L, 0L, 1L});
  const std::array<RationalPolynomial, 3> given = {a * t * t, RationalPolynomial(), a * b * t};
  const auto entries = coprime(given);
  CHECK(gcd(entries[0], entries[2]).degree() == 0);
  CHECK(entries[0] * given[2] == entries[2] * given[0]);
  CHECK(entries[0].degree() == 1);
  CHECK(entries[1].is_zero());
}

TEST_CASE("Entries without a common factor stay as they are, and so do zeros", "[common_factor]") {
  const std::array<RationalPolynomial, 2> given = {RationalPolynomial({4L, 2L}),
                                                   RationalPolynomial({0L, 6L})};
  CHECK(coprime(given) == given);
  CHECK(coprime(std::array<RationalPolynomial, 2>{}) == std::array<RationalPolynomial, 2>{});
}
