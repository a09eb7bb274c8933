// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/double_word_ball.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "pn/algebra/rational.hpp"

using pn::DoubleWordBall;
using pn::Rational;

namespace {

Rational exactly(double x) { return Rational::exactly(x); }
Rational midpoint(const DoubleWordBall& x) { return exactly(x.high) + exactly(x.low); }

bool contains(const std::optional<DoubleWordBall>& ball, const Rational& x) {
  if (!ball) return false;
  const Rational distance = x - midpoint(*ball), radius = exactly(ball->radius);
  return !(radius < distance) && !(radius < -distance);
}

/// The radius is below 2^-100 of this size.
bool is_narrow(const std::optional<DoubleWordBall>& ball, double size) {
  return ball && ball->radius <= std::ldexp(std::abs(size), -100);
}

/// Double words of all kinds: zero, short, of two words, with a radius or none; far and near to
/// each other in size.
class RandomDoubleWords {
 public:
  DoubleWordBall next() {
    const double high = below(8) == 0 ? 0 : std::ldexp(mantissa(), static_cast<int>(below(40)));
    const double part = below(2) == 0 ? 0 : high * std::ldexp(mantissa(), -54);
    const auto [sum, low] = pn::double_word::sum(high, part);
    const double radius = below(2) == 0 ? 0 : std::ldexp(std::abs(mantissa()), -70);
    return {sum, low, radius};
  }
  /// The same without a radius.
  DoubleWordBall next_number() {
    const DoubleWordBall ball = next();
    return {ball.high, ball.low, 0};
  }
  /// A number of the ball, at its border or inside.
  Rational member(const DoubleWordBall& ball) {
    return midpoint(ball) + Rational(below(3) - 1) * exactly(ball.radius);
  }
  static constexpr unsigned kSeed = 20;

 private:
  long below(long count) {
    return static_cast<long>(generator_() % static_cast<unsigned long>(count));
  }
  double mantissa() { return std::uniform_real_distribution<double>(-1, 1)(generator_); }
  std::mt19937_64 generator_{kSeed};
};

Rational magnitude(const Rational& x) { return x.sign() < 0 ? -x : x; }

}  // namespace

TEST_CASE("An operation on double words contains that on their numbers", "[double_word_ball]") {
  INFO("seed " << RandomDoubleWords::kSeed);
  RandomDoubleWords random;
  for (int i = 0; i < 5000; ++i) {
    const DoubleWordBall a = random.next(), b = random.next();
    const Rational x = random.member(a), y = random.member(b);
    CHECK(contains(sum(a, b), x + y));
    CHECK(contains(difference(a, b), x - y));
    CHECK(contains(product(a, b), x * y));
    if (const auto q = quotient(a, b)) CHECK(contains(q, x / y));
    // sqrt(x^2) = |x|
    if (const auto square = product(a, a)) {
      if (const auto r = root(*square)) CHECK(contains(r, magnitude(x)));
    }
  }
}

TEST_CASE("Double words without a radius keep their digits", "[double_word_ball]") {
  RandomDoubleWords random;
  for (int i = 0; i < 5000; ++i) {
    const DoubleWordBall a = random.next_number(), b = random.next_number();
    CHECK(is_narrow(sum(a, b), std::max(std::abs(a.high), std::abs(b.high))));
    CHECK(is_narrow(product(a, b), a.high * b.high));
    if (b.high != 0) CHECK(is_narrow(quotient(a, b), a.high / b.high));
    if (a.high > 0) CHECK(is_narrow(root(a), std::sqrt(a.high)));
  }
}

TEST_CASE("What fits into two doubles is exact", "[double_word_ball]") {
  const DoubleWordBall one{1, 0, 0}, small{0x1p-60, 0, 0}, three{3, 0, 0}, twelve{12, 0, 0};
  const auto both = sum(one, small);
  REQUIRE(both);
  CHECK(both->radius == 0);
  CHECK(midpoint(*both) == exactly(1) + exactly(0x1p-60));
  CHECK(difference(*both, *both)->is_zero());
  CHECK(product(*both, DoubleWordBall{}).value().is_zero());
  CHECK(product(*both, DoubleWordBall{-2, 0, 0})->radius == 0);
  CHECK(quotient(twelve, three)->radius == 0);
  CHECK(quotient(twelve, three)->high == 4);
  CHECK(root(DoubleWordBall{49, 0, 0})->radius == 0);
  CHECK(quotient(one, three)->radius > 0);
}

TEST_CASE("A sum of products contains that of the numbers, and is narrow", "[double_word_ball]") {
  INFO("seed " << RandomDoubleWords::kSeed);
  RandomDoubleWords random;
  for (int i = 0; i < 1000; ++i) {
    const DoubleWordBall start = random.next();
    pn::DoubleWordSum result(start), of_numbers({});
    Rational expected = random.member(start);
    double size = 0;
    for (int term = 0; term <= i % 7; ++term) {
      const DoubleWordBall a = random.next(), b = random.next();
      result.add_product(a, b);
      expected += random.member(a) * random.member(b);
      of_numbers.add_product({a.high, a.low, 0}, {b.high, b.low, 0});
      size += std::abs(a.high * b.high);
    }
    CHECK(contains(result.result(), expected));
    CHECK(is_narrow(of_numbers.result(), size));
  }
}

TEST_CASE("Bounds of double words are the doubles next to them", "[double_word_ball]") {
  CHECK(DoubleWordBall{1, 0, 0}.lower() == 1);
  CHECK(DoubleWordBall{1, 0, 0}.upper() == 1);
  CHECK(DoubleWordBall{1, 0x1p-60, 0}.lower() == 1);
  CHECK(DoubleWordBall{1, 0x1p-60, 0}.upper() == 1 + 0x1p-52);
  CHECK(DoubleWordBall{1, 0, 0x1p-60}.lower() == 1 - 0x1p-53);
  RandomDoubleWords random;
  for (int i = 0; i < 1000; ++i) {
    const DoubleWordBall a = random.next();
    CHECK_FALSE(midpoint(a) - exactly(a.radius) < exactly(a.lower()));
    CHECK_FALSE(exactly(a.upper()) < midpoint(a) + exactly(a.radius));
  }
}

TEST_CASE("What may underflow or overflow has no double words", "[double_word_ball]") {
  const DoubleWordBall large{0x1p400, 0, 0}, small{0x1p-400, 0, 0}, one{1, 0, 0};
  CHECK_FALSE(product(large, large));
  CHECK_FALSE(product(small, small));
  CHECK_FALSE(quotient(large, small));
  CHECK_FALSE(quotient(one, DoubleWordBall{}));
  CHECK_FALSE(quotient(one, DoubleWordBall{1, 0, 2}));
  CHECK_FALSE(root(DoubleWordBall{-1, 0, 0}));
  CHECK_FALSE(sum(one, DoubleWordBall{0x1p-460, 0, 0}));
  CHECK(product(large, small)->high == 1);
  // A radius that underflows does not become exact.
  CHECK(product(DoubleWordBall{0x1p-400, 0, 0x1p-480}, one)->radius > 0);
  CHECK(quotient(DoubleWordBall{1, 0, 0x1p-490}, DoubleWordBall{0x1p300, 0, 0})->radius > 0);
}
