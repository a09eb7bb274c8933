// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/bernstein.hpp"

#include <catch2/catch.hpp>

#include "pn/algebra/ball.hpp"
#include "pn/algebra/rational_polynomial.hpp"

using pn::from_bernstein;
using pn::Rational;
using pn::RationalPolynomial;
using pn::to_bernstein;

namespace {

/// The coefficients i^2 - 3 i + 1/2, whose signs change and none of which vanishes.
std::vector<Rational> coefficients_of_degree(int degree) {
  std::vector<Rational> result;
  for (long i = 0; i <= degree; ++i)
    result.push_back(Rational(2 * i * i - 6 * i + 1) / Rational(2L));
  return result;
}

/// de Casteljau's algorithm.
Rational bezier_value(std::vector<Rational> b, const Rational& t) {
  for (std::size_t n = b.size(); n-- > 1;) {
    for (std::size_t i = 0; i < n; ++i) b[i] = b[i] * (Rational(1L) - t) + b[i + 1] * t;
  }
  return b.front();
}

}  // namespace

TEST_CASE("The change to the Bernstein basis and back is the identity over Q", "[bernstein]") {
  for (int degree = 0; degree <= 25; ++degree) {
    const auto power = coefficients_of_degree(degree);
    CHECK(from_bernstein(to_bernstein(power)) == power);
    CHECK(to_bernstein(from_bernstein(power)) == power);
  }
}

TEST_CASE("Both forms have the same values", "[bernstein]") {
  for (const int degree : {0, 1, 4, 25}) {
    const auto power = coefficients_of_degree(degree);
    const RationalPolynomial p(power);
    for (const long sevenths : {-3, 0, 2, 7, 9}) {
      const Rational t = Rational(sevenths) / Rational(7L);
      CHECK(bezier_value(to_bernstein(power), t) == p(t));
    }
  }
}

TEST_CASE("The basis is that of the formal degree", "[bernstein]") {
  const Rational one(1L), zero(0L), third = one / Rational(3L);
  CHECK(to_bernstein(std::vector<Rational>{one, zero, zero}) ==
        std::vector<Rational>{one, one, one});
  CHECK(to_bernstein(std::vector<Rational>{zero, one, zero, zero}) ==
        std::vector<Rational>{zero, third, third + third, one});
}

TEST_CASE("Over balls the change of basis encloses the exact one", "[bernstein]") {
  for (const int degree : {0, 1, 12, 25, 40}) {
    const auto power = coefficients_of_degree(degree);
    std::vector<pn::RealBall> balls;
    for (const Rational& c : power) balls.emplace_back(c, 128L);
    const auto exact = to_bernstein(power);
    for (const auto& enclosed : {to_bernstein(balls), pn::BernsteinOfBalls(degree, 128)(balls)}) {
      REQUIRE(enclosed.size() == exact.size());
      for (std::size_t i = 0; i < exact.size(); ++i) {
        CHECK(enclosed[i].contains(exact[i]));
        CHECK((enclosed[i] - pn::RealBall(exact[i], 256)).magnitude_upper() < 1e-25);
      }
    }
  }
}
