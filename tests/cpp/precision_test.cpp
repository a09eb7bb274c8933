// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/precision.hpp"

#include <catch2/catch.hpp>
#include <vector>

using pn::at_sufficient_precision;
using pn::Undecided;

TEST_CASE("The precision doubles until everything is decided", "[precision]") {
  std::vector<long> tried;
  const long sufficient = at_sufficient_precision([&](long bits) {
    tried.push_back(bits);
    if (bits < 1000) throw Undecided("a matter of 1000 bits");
    return bits;
  });
  CHECK(sufficient == 1024);
  CHECK(tried == std::vector<long>{104, 128, 256, 512, 1024});
  CHECK(at_sufficient_precision([](long bits) { return bits; }, 512) == 512);
}

TEST_CASE("A difference below 2^-300 is decided by more bits, not by a tolerance", "[precision]") {
  const pn::Rational third = pn::Rational(1L) / pn::Rational(3L);
  pn::Rational tiny(1L);
  for (int i = 0; i < 300; ++i) tiny = tiny / pn::Rational(2L);
  const bool greater = at_sufficient_precision([&](long bits) {
    const pn::RealBall gap = pn::RealBall(third + tiny, bits) - pn::RealBall(third, bits);
    if (gap.contains_zero()) throw Undecided("which is larger");
    return gap.is_positive();
  });
  CHECK(greater);
}

TEST_CASE("The cap is an error that says what was not decided", "[precision]") {
  long last = 0;
  try {
    at_sufficient_precision([&](long bits) -> int {
      last = bits;
      throw Undecided("the sign of zero");
    });
    FAIL("nothing was thrown");
  } catch (const pn::GeometryError& error) {
    CHECK(error.code() == pn::ErrorCode::kPrecisionExhausted);
    CHECK_THAT(error.what(), Catch::Contains("the sign of zero") && Catch::Contains("4096"));
  }
  CHECK(last == pn::kMostPrecision);
}

TEST_CASE("Other errors pass through", "[precision]") {
  CHECK_THROWS_AS(at_sufficient_precision([](long) -> int { throw std::logic_error("another"); }),
                  std::logic_error);
}
