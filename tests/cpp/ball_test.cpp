// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/ball.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "random_balls.hpp"

using pn::ComplexBall;
using pn::Rational;
using pn::RealBall;
using pn::test::contains;
using pn::test::RandomBalls;

TEST_CASE("An operation on balls contains the operation on their numbers", "[ball]") {
  RandomBalls random;
  for (int i = 0; i < 2000; ++i) {
    const auto [a, x] = random.next();
    const auto [b, y] = random.next();
    REQUIRE(a.contains(x));
    CHECK((a + b).contains(x + y));
    CHECK((a - b).contains(x - y));
    CHECK((a * b).contains(x * y));
    CHECK((-a).contains(-x));
    if (!b.contains_zero()) CHECK((a / b).contains(x / y));
    CHECK(RealBall(a).add_product(a, b).contains(x + x * y));
    CHECK((RealBall(a) += b).contains(x + y));
    CHECK((RealBall(a) -= b).contains(x - y));
    CHECK((RealBall(a) *= b).contains(x * y));
    CHECK(abs(a).contains(x.sign() < 0 ? -x : x));
    CHECK(scaled(a, 5).contains(x * Rational(32L)));
    CHECK(scaled(a, -5).contains(x / Rational(32L)));
    CHECK(sqrt(a * a).contains(x.sign() < 0 ? -x : x));
    CHECK(a.overlaps(RealBall(x, 64)));
  }
}

TEST_CASE("Complex balls multiply and divide their numbers", "[ball]") {
  RandomBalls random;
  for (int i = 0; i < 1000; ++i) {
    const auto [a, x] = random.next();
    const auto [b, y] = random.next();
    const auto [c, u] = random.next();
    const auto [d, v] = random.next();
    const ComplexBall z(a, b), w(c, d);
    CHECK(contains(z * w, x * u - y * v, x * v + y * u));
    CHECK(contains(z + w, x + u, y + v));
    CHECK(contains(-z, -x, -y));
    CHECK(contains(conj(z), x, -y));
    CHECK(contains(ComplexBall(z).add_product(z, w), x + x * u - y * v, y + x * v + y * u));
    const Rational norm = u * u + v * v;
    if (w.contains_zero()) continue;
    CHECK(contains(z / w, (x * u + y * v) / norm, (y * u - x * v) / norm));
  }
}

TEST_CASE("The principal square root squares to its radicand", "[ball]") {
  const ComplexBall z(RealBall(-3).at_precision(128), RealBall(4).at_precision(128));
  const ComplexBall root = sqrt(z);
  CHECK(contains(root, Rational(1L), Rational(2L)));
  CHECK((root * root - z).contains_zero());
  CHECK(sqrt(RealBall(49).at_precision(128)).contains(Rational(7L)));
}

TEST_CASE("Bounds are outside the ball and signs are proofs", "[ball]") {
  const RealBall third(Rational(1L) / Rational(3L), 128);
  CHECK(Rational::exactly(third.lower()) < Rational(1L) / Rational(3L));
  CHECK(Rational::exactly(third.upper()) > Rational(1L) / Rational(3L));
  CHECK((-third).magnitude_upper() == third.upper());
  CHECK(third.is_positive());
  CHECK((-third).is_negative());

  const RealBall straddling = RealBall::between(-1, 2, 64);
  CHECK(straddling.contains_zero());
  CHECK_FALSE(straddling.is_positive());
  CHECK_FALSE(straddling.is_negative());
  CHECK_FALSE(straddling.is_zero());
  CHECK(straddling.lower() <= -1);
  CHECK(straddling.upper() >= 2);
  CHECK(straddling.contains(Rational(-1L)));
  CHECK(straddling.contains(Rational(2L)));
  CHECK_FALSE(straddling.contains(Rational(3L)));
  CHECK_FALSE(straddling.overlaps(RealBall(3)));
  CHECK_FALSE((RealBall(1) / straddling).is_finite());
  CHECK(RealBall().is_zero());
}

TEST_CASE("An operation works at the larger precision of its operands", "[ball]") {
  const RealBall fine(Rational(1L) / Rational(3L), 512);
  CHECK((RealBall(1) + fine).precision() == 512);
  CHECK((fine * RealBall(2)).precision() == 512);
  CHECK((ComplexBall(fine) / ComplexBall(3.0)).precision() == 512);
  // Three thirds are one to 500 bits, far closer than doubles could tell.
  CHECK((fine * RealBall(3) - RealBall(1)).magnitude_upper() < std::ldexp(1.0, -500));
}

TEST_CASE("A ball rounds to a double when it is narrower than its last place", "[ball]") {
  const long precision = GENERATE(values<long>({pn::DoubleWordBall::kPrecision, 128}));
  CHECK(RealBall(0.1).rounded() == 0.1);
  CHECK(RealBall(0).rounded() == 0.0);
  CHECK(RealBall(Rational(1L) / Rational(3L), precision).rounded() == 1 / 3.0);
  CHECK_FALSE(RealBall::between(1, 1 + 0x1p-40, precision).rounded());
  CHECK_FALSE(RealBall::between(-0x1p-200, 0x1p-200, precision).rounded());
  CHECK_FALSE((RealBall(1) / RealBall::between(-1, 1, 64)).rounded());

  // The contract at its border: all numbers are within one unit in the last place.
  for (const double width : {0x1p-54, 0x1p-53, 0x1p-52, 0x1p-51, 0x1p-48}) {
    const RealBall ball = RealBall::between(1.5, 1.5 + width, precision);
    if (const auto nearest = ball.rounded()) {
      CHECK(std::abs(1.5 + width - *nearest) <= 0x1p-52);
      CHECK(std::abs(1.5 - *nearest) <= 0x1p-52);
      CHECK(ball.rounding_error() >= std::max(std::abs(1.5 + width - *nearest), *nearest - 1.5));
      CHECK(ball.rounding_error() <= 0x1.001p-52);
    } else {
      CHECK(width > 0x1p-53);
    }
  }
}

TEST_CASE("Numbers of every magnitude are rounded to the nearest double, ties to even", "[ball]") {
  constexpr int kLeastExponent = -1074, kMostExponent = 971;
  std::mt19937_64 generator(11);
  std::uniform_int_distribution<int> exponents(kLeastExponent, kMostExponent);
  std::uniform_int_distribution<long> mantissas(1, (1L << 53) - 1);
  const Rational half = Rational(1L) / Rational(2L), third = Rational(1L) / Rational(3L);
  const Rational most = Rational::exactly(std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < 2000; ++i) {
    const std::array ends = {kLeastExponent, kMostExponent, exponents(generator)};
    const std::array borders = {1L, 2L, (1L << 53) - 1, mantissas(generator)};
    const int exponent = ends[i % ends.size()];
    const long mantissa = borders[i % borders.size()];
    for (const Rational& part : {-half, -third, Rational(0L), third, half}) {
      const Rational x = (Rational(mantissa) + part) * Rational::exactly(std::ldexp(1.0, exponent));
      const RealBall ball(x, 200);
      CAPTURE(exponent, mantissa, part.to_double());
      const auto nearest = ball.rounded();
      if (!nearest) {
        CHECK(most < x);
        continue;
      }
      const int last_place = *nearest == 0 ? kLeastExponent : std::ilogb(*nearest) - 52;
      const double unit = std::ldexp(1.0, std::max(last_place, kLeastExponent));
      const Rational difference = Rational::exactly(*nearest) - x;
      const Rational error = difference.sign() < 0 ? -difference : difference;
      CHECK_FALSE(Rational::exactly(unit) < error * Rational(2L));
      CHECK_FALSE(Rational::exactly(ball.rounding_error()) < error);
      const bool is_tie = (part == half || part == -half) && unit == std::ldexp(1.0, exponent);
      if (is_tie) {
        CHECK(std::fmod(std::ldexp(*nearest, -exponent), 2.0) == 0);
      }
    }
  }
}

TEST_CASE("The error of a rounded ball is half a unit in the last place and the radius", "[ball]") {
  const RealBall third(Rational(1L) / Rational(3L), 128), difference = third - RealBall(1 / 3.0);
  CHECK(third.rounding_error() >= difference.magnitude_upper());
  CHECK(third.rounding_error() <= 0x1.001p-55);
  CHECK(RealBall(0).rounding_error() <= 0x1p-1073);
  CHECK(RealBall::between(-0x1p-200, 0x1p-200, 128).rounding_error() >= 0x1p-200);
}
