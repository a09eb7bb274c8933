// SPDX-License-Identifier: LGPL-2.1-or-later
// Random balls, each with an exact number in it.
#pragma once

#include <cmath>
#include <random>

#include "pn/algebra/ball.hpp"

namespace pn::test {

/// A ball of a random size and, in it, an exact number that need not be its midpoint.
struct BallWithMember {
  RealBall ball;
  Rational member;
};

class RandomBalls {
 public:
  BallWithMember next() {
    const double low = std::ldexp(mantissa(), exponent());
    const double high = low + std::ldexp(std::abs(mantissa()), exponent());
    const Rational share = Rational(below(101)) / Rational(100L);
    const Rational begin = Rational::exactly(low), end = Rational::exactly(high);
    return {RealBall::between(low, high, 64 + below(3) * 64), begin + share * (end - begin)};
  }

 private:
  long below(long count) {
    return static_cast<long>(generator_() % static_cast<unsigned long>(count));
  }
  double mantissa() { return static_cast<double>(below(2001) - 1000) / 997; }
  int exponent() { return static_cast<int>(below(40)) - 20; }
  std::mt19937_64 generator_{7};
};

inline bool contains(const ComplexBall& z, const Rational& re, const Rational& im) {
  return z.real().contains(re) && z.imag().contains(im);
}

}  // namespace pn::test
