// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rational_matrix.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <stdexcept>

using namespace pn;

namespace {

RationalMatrix product(const RationalMatrix& a, const RationalMatrix& b) {
  RationalMatrix result(a.size(), std::vector<Rational>(b.front().size()));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.front().size(); ++j) {
      for (std::size_t k = 0; k < b.size(); ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

RationalMatrix random_matrix(std::mt19937& random, std::size_t rows, std::size_t columns) {
  std::uniform_int_distribution<long> numerator(-9, 9), denominator(1, 5);
  RationalMatrix result(rows, std::vector<Rational>(columns));
  for (auto& row : result) {
    for (Rational& x : row) x = Rational(numerator(random)) / Rational(denominator(random));
  }
  return result;
}

}  // namespace

TEST_CASE("A product through a short side has its rank, and the null space the rest",
          "[rational_matrix]") {
  std::mt19937 random(1);
  for (const std::size_t rank : {1, 2, 3}) {
    const RationalMatrix m =
        product(random_matrix(random, 4, rank), random_matrix(random, rank, 6));
    CHECK(row_echelon_form(m).size() == rank);
    const RationalMatrix kernel = null_space(m, 6);
    CHECK(kernel.size() == 6 - rank);
    CHECK(row_echelon_form(kernel).size() == 6 - rank);
    for (const auto& x : kernel) {
      for (const auto& row : m) {
        Rational sum;
        for (std::size_t i = 0; i < 6; ++i) sum += row[i] * x[i];
        CHECK(sum.is_zero());
      }
    }
  }
  CHECK(null_space({}, 3).size() == 3);
}

TEST_CASE("The row echelon form depends on the row space alone", "[rational_matrix]") {
  std::mt19937 random(2);
  const RationalMatrix m = random_matrix(random, 3, 5);
  CHECK(row_echelon_form(product(random_matrix(random, 4, 3), m)) == row_echelon_form(m));
}

TEST_CASE("A matrix times its inverse is the unit matrix", "[rational_matrix]") {
  std::mt19937 random(3);
  const RationalMatrix m = random_matrix(random, 4, 4);
  const RationalMatrix unit = product(m, inverse(m));
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) CHECK(unit[i][j] == Rational(i == j ? 1L : 0L));
  }
  CHECK_THROWS_AS(inverse({{1L, 2L}, {2L, 4L}}), std::domain_error);
}
