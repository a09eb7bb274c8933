// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/interval_substitution.hpp"

#include <catch2/catch.hpp>

#include "conic_families.hpp"
#include "error_code.hpp"
#include "pn/conics/rational_conic_family.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const Rational kZero(0), kOne(1), kHalf = Rational(1) / Rational(2);

ConicFamily circles_of_squared_radius(const std::vector<long>& square) {
  return conic_family(diagonal(1L, 1L, -conic_polynomial(square)));
}

Rational value(const IntervalSubstitution& t, const Rational& s) {
  return t.numerator(s) / t.denominator(s);
}

/// Linear or quadratic, with the ends of the interval at 0 and 1 and real points everywhere.
IntervalSubstitution checked(const ConicFamily& family, const Rational& begin,
                             const Rational& end) {
  const IntervalSubstitution t = interval_substitution(family, begin, end);
  CHECK(value(t, kZero) == begin);
  CHECK(value(t, kOne) == end);
  CHECK(begin < value(t, kHalf));
  CHECK(value(t, kHalf) < end);
  const ConicFamily over_s = substituted(family, t);
  CHECK_FALSE(interval_without_real_points(over_s));
  CHECK_NOTHROW(RationalConicFamily(over_s));
  return t;
}

}  // namespace

TEST_CASE("Families that are real everywhere keep their degree", "[interval_substitution]") {
  CHECK(checked(circles_of_squared_radius({2, 0, 1}), Rational(-3), Rational(5)).degree == 1);
}

TEST_CASE("Families that are real on the interval only get a quadratic substitution",
          "[interval_substitution]") {
  CHECK(checked(circles_of_squared_radius({1, 0, -1}), -kHalf, kHalf).degree == 2);
  CHECK(checked(circles_of_squared_radius({1, 8}), kZero, kOne).degree == 2);
  // So near that the first enclosures reach beyond.
  CHECK(checked(circles_of_squared_radius({1, 999}), kZero, kOne).degree == 2);
}

TEST_CASE("An irrational zero just outside the interval is left out, and dt/ds stays positive",
          "[interval_substitution]") {
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12}) {
    INFO("gap " << gap);
    // The circles end at the square root of 1 + gap.
    const Rational square = kOne + Rational::exactly(gap);
    const ConicFamily family =
        conic_family(diagonal(1L, 1L, RationalPolynomial({-square, kZero, kOne})));
    const IntervalSubstitution t = checked(family, -kOne, kOne);
    CHECK(t.degree == 2);
    for (const Rational& s : {kZero, kHalf, kOne}) {
      CHECK((t.numerator.derivative() * t.denominator - t.numerator * t.denominator.derivative())(s)
                .sign() > 0);
    }
  }
}

TEST_CASE("The conics may end exactly at the ends of the interval", "[interval_substitution]") {
  CHECK(checked(circles_of_squared_radius({0, 1}), kZero, kOne).degree == 2);
  CHECK(checked(circles_of_squared_radius({0, 1, -1}), kZero, kOne).degree == 2);
}

TEST_CASE("Intervals with conics without real points are refused", "[interval_substitution]") {
  const auto refused = [](const std::vector<long>& square) {
    return code_of([&] {
             interval_substitution(circles_of_squared_radius(square), kZero, kOne);
           }) == ErrorCode::kNoRealPoints;
  };
  CHECK(refused({-1, 2}));
  CHECK(refused({-1}));
  CHECK(refused({1, -6, 6}));
  // A zero beyond the end by 2^-80 of the interval, closer than any r2 is tried.
  Rational gap(1);
  for (int i = 0; i < 80; ++i) gap *= kHalf;
  const auto too_close = conic_family(diagonal(1L, 1L, -RationalPolynomial({kOne + gap, -kOne})));
  CHECK(code_of([&] { interval_substitution(too_close, kZero, kOne); }) ==
        ErrorCode::kNoRealPoints);
}

TEST_CASE("A substituted polynomial is the polynomial of the substituted parameter",
          "[interval_substitution]") {
  const IntervalSubstitution t =
      interval_substitution(circles_of_squared_radius({1, 0, -1}), -kHalf, kHalf);
  const RationalPolynomial p = conic_polynomial({3, -1, 4, 2});
  const Rational s = Rational(3) / Rational(7), d = t.denominator(s);
  CHECK(t(p, 4)(s) == p(value(t, s)) * d * d * d * d);
}
