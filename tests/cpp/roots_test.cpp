// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/roots.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using pn::ConjugatePair;
using pn::Rational;
using pn::RationalPolynomial;
using pn::RealRoot;

namespace {

RationalPolynomial power(const RationalPolynomial& p, int exponent) {
  RationalPolynomial result(1L);
  for (int i = 0; i < exponent; ++i) result *= p;
  return result;
}

/// t - root.
RationalPolynomial real_factor(const Rational& root) {
  return RationalPolynomial({-root, Rational(1L)});
}

/// The polynomial with roots re +- i im.
RationalPolynomial pair_factor(const Rational& re, const Rational& im) {
  return power(real_factor(re), 2) + RationalPolynomial(im * im);
}

Rational fraction(long p, long q) { return Rational(p) / Rational(q); }

const Rational kTiny = Rational(1L) / Rational(1L << 60);

bool contains(const ConjugatePair& pair, const Rational& re, const Rational& im) {
  return pair.value.real().contains(re) && pair.value.imag().contains(im);
}

}  // namespace

TEST_CASE("Planted roots are found with their multiplicities", "[roots]") {
  const auto p = RationalPolynomial(fraction(-7, 3)) * power(real_factor(fraction(1, 3)), 3) *
                 real_factor(Rational(-2L)) * power(pair_factor(fraction(1, 2), Rational(3L)), 2) *
                 pair_factor(Rational(-5L), fraction(1, 7));
  for (const long precision : {64L, 128L, 512L}) {
    const auto roots = isolate_roots(p, precision);
    REQUIRE(roots.real.size() == 2);
    CHECK(roots.real[0].value.contains(Rational(-2L)));
    CHECK(roots.real[0].multiplicity == 1);
    CHECK(roots.real[1].value.contains(fraction(1, 3)));
    CHECK(roots.real[1].multiplicity == 3);
    REQUIRE(roots.pairs.size() == 2);
    const bool swapped = roots.pairs[0].multiplicity == 1;
    CHECK(contains(roots.pairs[swapped ? 1 : 0], fraction(1, 2), Rational(3L)));
    CHECK(roots.pairs[swapped ? 1 : 0].multiplicity == 2);
    CHECK(contains(roots.pairs[swapped ? 0 : 1], Rational(-5L), fraction(1, 7)));
    CHECK(roots.pairs[swapped ? 0 : 1].multiplicity == 1);
    for (const ConjugatePair& pair : roots.pairs) CHECK(pair.value.imag().is_positive());
    const double width = std::ldexp(1.0, static_cast<int>(12 - precision));
    CHECK((roots.real[1].value - pn::RealBall(fraction(1, 3), 1024)).magnitude_upper() < width);
  }
}

TEST_CASE("Close roots are told apart, real or not", "[roots]") {
  const auto real = real_factor(Rational(1L)) * real_factor(Rational(1L) + kTiny) *
                    pair_factor(Rational(2L), Rational(1L));
  const auto two = isolate_roots(real, 128);
  REQUIRE(two.real.size() == 2);
  CHECK(two.real[0].value.contains(Rational(1L)));
  CHECK(two.real[1].value.contains(Rational(1L) + kTiny));
  CHECK_FALSE(two.real[0].value.overlaps(two.real[1].value));

  const auto almost_real =
      isolate_roots(pair_factor(Rational(1L), kTiny) * real_factor(Rational(3L)), 128);
  REQUIRE(almost_real.real.size() == 1);
  REQUIRE(almost_real.pairs.size() == 1);
  CHECK(contains(almost_real.pairs[0], Rational(1L), kTiny));
}

TEST_CASE("Clusters of roots are as narrow as the precision asks", "[roots]") {
  for (const long reciprocal : {1000L, 10000L, 100000000L}) {
    for (long count = 2; count <= 5; ++count) {
      RationalPolynomial p(1L);
      for (long i = 0; i < count; ++i) {
        p *= pair_factor(Rational(1L) + fraction(i, reciprocal),
                         Rational(2L) + fraction(i * i, 3 * reciprocal));
      }
      const auto roots = isolate_roots(p, 512);
      REQUIRE(roots.pairs.size() == static_cast<std::size_t>(count));
      for (const ConjugatePair& pair : roots.pairs) {
        // x - x has twice the radius of x.
        CHECK((pair.value.imag() - pair.value.imag()).magnitude_upper() < 0x1p-254);
      }
    }
  }
}

TEST_CASE("Roots of very different sizes, and zero, are all found", "[roots]") {
  const Rational huge(1L << 40), small = Rational(1L) / huge;
  const auto p = power(real_factor(Rational(0L)), 2) * real_factor(huge) * real_factor(-small) *
                 pair_factor(small, huge);
  const auto roots = isolate_roots(p, 128);
  REQUIRE(roots.real.size() == 3);
  CHECK(roots.real[0].value.contains(-small));
  CHECK(roots.real[1].value.contains(Rational(0L)));
  CHECK(roots.real[1].multiplicity == 2);
  CHECK(roots.real[2].value.contains(huge));
  REQUIRE(roots.pairs.size() == 1);
  CHECK(contains(roots.pairs[0], small, huge));
}

TEST_CASE("Roots and lead reproduce the polynomial", "[roots]") {
  // An irreducible polynomial of degree 9 with no pattern to its roots.
  const RationalPolynomial p({Rational(2L), Rational(-7L), Rational(3L), Rational(0L), Rational(5L),
                              Rational(-1L), Rational(11L), Rational(4L), Rational(-3L),
                              Rational(13L)});
  const auto roots = isolate_roots(p, 256);
  CHECK(roots.real.size() + 2 * roots.pairs.size() == 9);
  const pn::RealBall t(fraction(3, 11), 256);
  pn::RealBall product(p.coefficient(9), 256);
  for (const RealRoot& root : roots.real) product *= t - root.value;
  for (const ConjugatePair& pair : roots.pairs) {
    const pn::RealBall x = t - pair.value.real(), y = pair.value.imag();
    product *= x * x + y * y;
  }
  CHECK(product.contains(p(fraction(3, 11))));
  CHECK(product.rounded());
}

TEST_CASE("A constant has no roots", "[roots]") {
  CHECK(isolate_roots(RationalPolynomial(4L), 128).real.empty());
  CHECK(isolate_roots(RationalPolynomial(4L), 128).pairs.empty());
}

TEST_CASE("Roots at the ends of [0, 1] count, those beyond do not", "[roots]") {
  const auto p = power(real_factor(Rational(0L)), 2) * real_factor(Rational(1L)) *
                 power(real_factor(fraction(1, 3)), 2) * real_factor(-kTiny) *
                 real_factor(Rational(1L) + kTiny) * real_factor(kTiny) *
                 pair_factor(fraction(1, 2), kTiny);
  auto roots = roots_in_unit_interval(p);
  REQUIRE(roots.size() == 4);
  const auto multiplicity_at = [&](const Rational& x) {
    int sum = 0;
    for (const RealRoot& root : roots) sum += root.value.contains(x) ? root.multiplicity : 0;
    return sum;
  };
  CHECK(multiplicity_at(Rational(0L)) == 2);
  CHECK(multiplicity_at(kTiny) == 1);
  CHECK(multiplicity_at(fraction(1, 3)) == 2);
  CHECK(multiplicity_at(Rational(1L)) == 1);
  CHECK(roots_in_unit_interval(RationalPolynomial(1L)).empty());
  // Coefficients of one sign in the Bernstein basis, and of both.
  CHECK(roots_in_unit_interval(pair_factor(fraction(1, 2), Rational(3L))).empty());
  CHECK(roots_in_unit_interval(pair_factor(fraction(1, 2), kTiny)).empty());
}

TEST_CASE("Positivity on [0, 1] is decided exactly", "[roots]") {
  CHECK(is_positive_on_unit_interval(RationalPolynomial(1L)));
  CHECK_FALSE(is_positive_on_unit_interval(RationalPolynomial()));
  CHECK_FALSE(is_positive_on_unit_interval(RationalPolynomial(-1L)));
  CHECK_FALSE(is_positive_on_unit_interval(real_factor(Rational(0L))));
  CHECK_FALSE(is_positive_on_unit_interval(-real_factor(Rational(1L))));
  CHECK(is_positive_on_unit_interval(real_factor(-kTiny)));
  CHECK(is_positive_on_unit_interval(-real_factor(Rational(1L) + kTiny)));
  // The Bernstein coefficients of (t - 1/2)^2 + e have both signs; a touch is no sign change.
  const auto square = power(real_factor(fraction(1, 2)), 2);
  CHECK_FALSE(is_positive_on_unit_interval(square));
  CHECK(is_positive_on_unit_interval(square + RationalPolynomial(kTiny)));
  CHECK_FALSE(is_positive_on_unit_interval(square - RationalPolynomial(kTiny)));
}

TEST_CASE("Roots at which another polynomial is not positive", "[roots]") {
  const Rational third = fraction(1, 3), half = fraction(1, 2), near = half + kTiny;
  const auto p = real_factor(third) * real_factor(half) * real_factor(near) *
                 real_factor(fraction(2, 3)) * real_factor(Rational(2L)) * pair_factor(half, third);
  const auto found = [&](const RationalPolynomial& other) {
    std::vector<Rational> result;
    for (const RealRoot& root : roots_in_unit_interval_without_positive(p, other)) {
      for (const Rational& x : {third, half, near, fraction(2, 3)}) {
        if (root.value.contains(x)) result.push_back(x);
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  CHECK(found(RationalPolynomial(1L)).empty());
  CHECK(found(RationalPolynomial(-1L)).size() == 4);
  // Zero at a root, to any order, and a sign that changes between two close ones.
  CHECK(found(power(real_factor(third), 2)) == std::vector<Rational>{third});
  CHECK(found(real_factor(half)) == std::vector<Rational>{third, half});
  CHECK(found(real_factor(half + kTiny / Rational(2L))) == std::vector<Rational>{third, half});
  CHECK(found(-real_factor(near)) == std::vector<Rational>{near, fraction(2, 3)});
}
