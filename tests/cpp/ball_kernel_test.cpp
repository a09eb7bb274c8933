// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/ball_kernel.hpp"

#include <catch2/catch.hpp>

#include "pn/algebra/ball_vector.hpp"

using pn::Rational;
using pn::RealBall;

namespace {
using Matrix = std::vector<std::vector<RealBall>>;

Matrix thirds(const std::vector<std::vector<long>>& numerators) {
  Matrix m;
  for (const auto& row : numerators) {
    m.emplace_back();
    for (const long x : row) m.back().emplace_back(Rational(x) / Rational(3L), 128);
  }
  return m;
}
}  // namespace

TEST_CASE("The kernel is orthogonal to all rows and has one vector for each free coordinate",
          "[ball_kernel]") {
  const Matrix m = thirds({{1, 2, -1, 4, 7}, {0, 3, 5, -2, 1}, {2, -2, 1, 1, 0}});
  const auto basis = pn::kernel(m, 3);
  REQUIRE(basis);
  REQUIRE(basis->size() == 2);
  for (const auto& vector : *basis) {
    for (const auto& row : m) {
      const RealBall product = pn::dot(row, vector);
      CHECK(product.contains_zero());
      CHECK(product.magnitude_upper() < 1e-30);
    }
  }
}

TEST_CASE("A rank that is not proved is not claimed, one that is known may be less",
          "[ball_kernel]") {
  const Matrix dependent = thirds({{1, 2, 4}, {2, 4, 8}});
  CHECK_FALSE(pn::kernel(dependent, 2));
  const auto basis = pn::kernel(dependent, 1);
  REQUIRE(basis);
  CHECK(basis->size() == 2);
}
