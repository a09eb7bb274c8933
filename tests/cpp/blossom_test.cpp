// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/blossom.hpp"

#include <catch2/catch.hpp>

#include "error_code.hpp"

using namespace pn;
using test::code_of;

namespace {

/// The truncated power (t - 1)_+^2 over the knots 0, 1, 3, of degree 2, by its blossoms (a - 1) (b
/// - 1) at (0, 0), (0, 1), (1, 3), (3, 3), which vanish left of 1.
const std::vector<int> kMultiplicities = {3, 1, 3};
const std::vector<Rational> kKnots = {Rational(0L), Rational(1L), Rational(3L)};
const std::vector<Rational> kCoefficients = {Rational(0L), Rational(0L), Rational(0L),
                                             Rational(4L)};

}  // namespace

TEST_CASE("The spans of a B-spline are its polynomials", "[blossom]") {
  const std::vector<std::size_t> places = span_places(kMultiplicities);
  REQUIRE(places == std::vector<std::size_t>{2, 3});
  const std::vector<Rational> flat = flat_knots(kKnots, kMultiplicities);
  REQUIRE(flat.size() == 7);
  CHECK(span_polynomial(flat, places[0], 2, kCoefficients).is_zero());
  // With t = 1 + 2 s it is 4 s^2.
  CHECK(span_polynomial(flat, places[1], 2, kCoefficients) ==
        RationalPolynomial({Rational(0L), Rational(0L), Rational(4L)}));
}

TEST_CASE("Only the ratios of weights matter", "[blossom]") {
  const std::vector<Rational> weights = scaled_weights({3e200, 6e200, 1.5e200}, 3);
  CHECK(weights[1] == Rational(2L) * weights[0]);
  CHECK(weights[0] == Rational(2L) * weights[2]);
  CHECK_FALSE(weights[1] < Rational(1L));
  CHECK(weights[1] < Rational(2L));
  CHECK(scaled_weights({}, 2) == std::vector<Rational>{Rational(1L), Rational(1L)});
}

TEST_CASE("Knots that are not those of a clamped spline are refused", "[blossom]") {
  const auto refused = [](const std::vector<double>& knots, const std::vector<int>& multiplicities,
                          std::size_t poles) {
    return code_of([&] { require_clamped(2, knots, multiplicities, poles); });
  };
  CHECK_FALSE(refused({0, 1, 3}, kMultiplicities, 4).has_value());
  CHECK(refused({0, 1, 3}, kMultiplicities, 5) == ErrorCode::kBadKnots);
  CHECK(refused({0, 3, 3}, kMultiplicities, 4) == ErrorCode::kBadKnots);
  CHECK(refused({0, 1, 3}, {2, 2, 3}, 4) == ErrorCode::kBadKnots);
  CHECK(refused({0, 1, 3}, {3, 0, 3}, 3) == ErrorCode::kBadKnots);
  CHECK(refused({0, 1}, kMultiplicities, 4) == ErrorCode::kBadKnots);
}
