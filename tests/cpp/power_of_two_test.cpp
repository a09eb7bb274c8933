// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/power_of_two.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pn;

TEST_CASE("Powers of two are within a factor of two", "[power_of_two]") {
  for (const double x : {1.0, -1.0, 3.0, 0.1, -1e-200, 7e300}) {
    const Rational exact = Rational::exactly(x), power = power_of_two_near(exact);
    const double ratio = std::abs((exact / power).to_double());
    CHECK(ratio >= 0.5);
    CHECK(ratio <= 2);
    int exponent = 0;
    CHECK(std::frexp(power.to_double(), &exponent) == 0.5);
  }
}

TEST_CASE("The power of two of polynomials is that of their largest coefficient",
          "[power_of_two]") {
  const RationalPolynomial p({Rational(3), Rational(-1000)});
  CHECK(power_of_two_near({p, RationalPolynomial()}) == power_of_two_near(Rational(1000)));
  CHECK(power_of_two_near(std::vector<RationalPolynomial>(2)) == Rational(1));
}
