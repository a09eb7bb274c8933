// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rational.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

using pn::Rational;

TEST_CASE("A double is the rational number it stands for", "[rational]") {
  // 0.1 is the binary fraction 3602879701896397 / 2^55, not a tenth.
  CHECK(Rational::exactly(0.1) == Rational(3602879701896397L) / Rational(1L << 55));
  CHECK(Rational::exactly(0.1) != Rational(1L) / Rational(10L));
  CHECK(Rational::exactly(-0.75) == Rational(-3L) / Rational(4L));
  CHECK(Rational::exactly(0.0).is_zero());
  CHECK(Rational::exactly(-0.0).is_zero());
  for (const double x : {0.1, -1e300, 1e-300, 1 / 3.0, std::numeric_limits<double>::denorm_min(),
                         std::numeric_limits<double>::max(), std::nextafter(1.0, 2.0)}) {
    CHECK(Rational::exactly(x).to_double() == x);
    CHECK(Rational::exactly(2 * (x / 2)) == Rational::exactly(x / 2) * Rational(2L));
  }
}

TEST_CASE("NaN and infinity are no rational numbers", "[rational]") {
  CHECK_THROWS_AS(Rational::exactly(std::nan("")), std::domain_error);
  CHECK_THROWS_AS(Rational::exactly(INFINITY), std::domain_error);
  CHECK_THROWS_AS(Rational(1L) / Rational(), std::domain_error);
}

TEST_CASE("Rounding goes to the nearest double", "[rational]") {
  const Rational third = Rational(1L) / Rational(3L);
  const double nearest = third.to_double();
  const auto distance = [&](double x) {
    const Rational gap = Rational::exactly(x) - third;
    return gap.sign() < 0 ? -gap : gap;
  };
  CHECK(distance(nearest) < distance(std::nextafter(nearest, 0.0)));
  CHECK(distance(nearest) < distance(std::nextafter(nearest, 1.0)));
}

TEST_CASE("The field axioms hold exactly", "[rational]") {
  const Rational a = Rational::exactly(0.1), b = Rational::exactly(-1e17),
                 c = Rational(7L) / Rational(-3L);
  CHECK((a + b) - b == a);
  CHECK((a * b) / b == a);
  CHECK(a * (b + c) == a * b + a * c);
  CHECK(-(-c) == c);
  CHECK(c.sign() == -1);
  CHECK((c - c).sign() == 0);
  CHECK(b < c);
  CHECK(a > c);
  CHECK_FALSE(a < a);
}

TEST_CASE("The root of a rational square is known exactly", "[rational]") {
  CHECK(square_root(Rational(9L) / Rational(4L)) == Rational(3L) / Rational(2L));
  CHECK(square_root(Rational()) == Rational());
  CHECK_FALSE(square_root(Rational(2L)).has_value());
  CHECK_FALSE(square_root(Rational(-4L)).has_value());
  CHECK_FALSE(square_root(Rational::exactly(0.01)).has_value());
}
