// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/ternary_form.hpp"

#include <catch2/catch.hpp>

using namespace pn;

namespace {

Rational value(const TernaryForm<Rational>& form, long u, long v, long w) {
  Rational sum;
  for (int i = 0; i <= form.degree(); ++i) {
    for (int j = 0; i + j <= form.degree(); ++j) {
      Rational term = form(i, j);
      for (int k = 0; k < i; ++k) term *= Rational(u);
      for (int k = 0; k < j; ++k) term *= Rational(v);
      for (int k = i + j; k < form.degree(); ++k) term *= Rational(w);
      sum += term;
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("Products and sums of ternary forms have the products and sums as values",
          "[ternary_form]") {
  const auto p = TernaryForm<Rational>::linear(2L, -3L, 5L),
             q = TernaryForm<Rational>::linear(1L, 4L, -7L);
  const auto square = p * p, mixed = p * q;
  for (const auto& [u, v, w] : {std::array{1L, 2L, 3L}, {5L, -1L, 2L}, {0L, 7L, 1L}}) {
    CHECK(value(p, u, v, w) == Rational(2 * u - 3 * v + 5 * w));
    CHECK(value(mixed, u, v, w) == value(p, u, v, w) * value(q, u, v, w));
    CHECK(value(mixed * square - square * Rational(2L) * mixed, u, v, w) ==
          -(value(mixed, u, v, w) * value(square, u, v, w)));
  }
}

TEST_CASE("Positive coefficients are found, and one that is not", "[ternary_form]") {
  const auto p = TernaryForm<Rational>::linear(2L, 3L, 5L);
  CHECK(has_positive_coefficients(p * p));
  CHECK_FALSE(has_positive_coefficients(TernaryForm<Rational>::linear(2L, 0L, 5L)));
  CHECK_FALSE(has_positive_coefficients(p - p * Rational(2L)));
}
