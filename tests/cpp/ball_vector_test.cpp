// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/ball_vector.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "random_balls.hpp"

using pn::ComplexBall;
using pn::Rational;
using pn::RealBall;
using pn::test::contains;
using pn::test::RandomBalls;

TEST_CASE("Sums of products contain those of their numbers", "[ball_vector]") {
  RandomBalls random;
  for (const std::size_t count : {1u, 2u, 5u, 9u}) {
    std::vector<RealBall> a, b;
    Rational expected;
    for (std::size_t i = 0; i < count; ++i) {
      const auto [x, in_x] = random.next();
      const auto [y, in_y] = random.next();
      a.push_back(x);
      b.push_back(y);
      expected += in_x * in_y;
    }
    CHECK(dot(a, b).contains(expected));
    CHECK(dot(a, b).precision() >= a.back().precision());
  }
}

TEST_CASE("A product of polynomials contains that of their numbers, up to the room in the sum",
          "[ball_vector]") {
  RandomBalls random;
  const auto polynomial = [&](std::size_t size, std::vector<Rational>& members) {
    std::vector<RealBall> balls;
    for (std::size_t i = 0; i < size; ++i) {
      const auto [x, in_x] = random.next();
      balls.push_back(x);
      members.push_back(in_x);
    }
    return balls;
  };
  const auto with_imaginary = [](const std::vector<RealBall>& re) {
    std::vector<ComplexBall> result;
    for (const RealBall& x : re) result.emplace_back(x, RealBall(2) * x);
    return result;
  };
  for (const auto& [n, m, room] : {std::array<std::size_t, 3>{1, 1, 1}, {4, 2, 5}, {3, 6, 4}}) {
    std::vector<Rational> in_a, in_b, in_sum;
    const auto a = polynomial(n, in_a), b = polynomial(m, in_b), before = polynomial(room, in_sum);
    auto sum = before;
    add_product(sum, a, b);
    auto complex_sum = with_imaginary(before);
    add_product(complex_sum, with_imaginary(a), with_imaginary(b));
    for (std::size_t k = 0; k < room; ++k) {
      Rational product;
      for (std::size_t i = 0; i < n; ++i) {
        if (i <= k && k - i < m) product += in_a[i] * in_b[k - i];
      }
      CHECK(sum[k].contains(in_sum[k] + product));
      // (1 + 2 i)^2 = -3 + 4 i.
      CHECK(contains(complex_sum[k], in_sum[k] - Rational(3L) * product,
                     Rational(2L) * in_sum[k] + Rational(4L) * product));
    }
  }
}

TEST_CASE("Homogeneous coordinates beyond all doubles are made fit for them", "[ball_vector]") {
  const Rational large = [] {
    Rational x(3L);
    for (int i = 0; i < 12; ++i) x *= x;  // about 2^6492
    return x;
  }();
  const std::vector<RealBall> numbers = {RealBall(large, 100), RealBall(-large * Rational(2L), 100),
                                         RealBall(0L)};
  CHECK(std::isinf(numbers[0].midpoint()));
  const std::vector<RealBall> even = normalized(numbers);
  CHECK(even[1].midpoint() <= -0.5);
  CHECK(even[1].midpoint() > -1);
  CHECK((even[0] * RealBall(2L) + even[1]).contains_zero());
  CHECK(even[2].is_zero());
  CHECK(pn::normalized({RealBall(0L)})[0].is_zero());
}
