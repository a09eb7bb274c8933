// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/column_reduction.hpp"

#include <catch2/catch.hpp>

#include "conic_families.hpp"

using namespace pn;
using namespace pn::test;

namespace {

LeadingTerm leading_term(const Conic& m, std::size_t j) {
  std::size_t row = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (m[i][j].degree() >= m[row][j].degree()) row = i;
  }
  const int degree = m[row][j].degree();
  return {row, degree, m[row][j].coefficient(degree)};
}

int sum_of_degrees(const Conic& m) {
  return leading_term(m, 0).degree + leading_term(m, 1).degree + leading_term(m, 2).degree;
}

}  // namespace

TEST_CASE("Degrees of a reduced basis add up to the degree of the determinant",
          "[column_reduction]") {
  RandomConics random(11);
  for (int repeat = 0; repeat < 20; ++repeat) {
    Conic m;
    for (auto& row : m) {
      for (RationalPolynomial& entry : row) entry = random.any(2);
    }
    // Steps that change the basis, not the module, and raise its degrees.
    for (auto& row : m) {
      row[1] += random.any(0) * row[0];
      row[2] += power_of_t(3) * row[1];
      row[0] += power_of_t(2) * row[2];
    }
    const RationalPolynomial before = determinant(m);
    if (before.is_zero()) continue;
    reduce_columns(
        3, [&](std::size_t j) { return leading_term(m, j); },
        [&](std::size_t i, const RationalPolynomial& factor, std::size_t j) {
          for (auto& row : m) row[i] += factor * row[j];
        });
    CHECK(determinant(m) == before);
    CHECK(sum_of_degrees(m) == before.degree());
  }
}
