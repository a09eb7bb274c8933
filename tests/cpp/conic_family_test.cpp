// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/conic_family.hpp"

#include <catch2/catch.hpp>

#include "conic_families.hpp"
#include "error_code.hpp"

using namespace pn;
using namespace pn::test;

namespace {

RationalPolynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

SmithType type_at(const SingularConics& singular, const RationalPolynomial& factor) {
  for (const SingularFactor& part : singular.finite) {
    if (remainder(part.factor, factor).is_zero()) return part.type;
  }
  return {};
}

}  // namespace

TEST_CASE("Common factors and powers of t beyond the degrees are removed", "[conic_family]") {
  const RationalPolynomial common = poly({3, 1, 2});
  const ConicFamily family =
      conic_family(diagonal(common, common * poly({0, 1}), -common * poly({1, 1})));
  CHECK(family.twist == 1);
  CHECK(family.matrix[0][0].degree() == 0);
  CHECK(conic_family(diagonal(1L, poly({0, 1}), -1L), {1, 0, 0}).twist == 1);
}

TEST_CASE("Smith types are those of diagonal matrices, in any coordinates", "[conic_family]") {
  const RationalPolynomial i = poly({1, 0, 1}), t = poly({0, 1});
  // (1, 3) at i, (0, 2) at 0, infinity: degrees 6, 5, 2 of 6.
  const Conic c = diagonal(i * i * i, i * t * poly({4, 1, 1}) * t, -poly({5, 0, 2}));
  // Unimodular, so no type changes at finite places.
  const RationalPolynomial zero, one(1L);
  const Conic s = {{{one, poly({1, 2}), t}, {zero, one, poly({0, 3})}, {zero, zero, one}}};
  for (const Conic& matrix : {c, transformed(c, s)}) {
    const SingularConics singular = singular_conics(conic_family(matrix));
    CHECK(type_at(singular, i).a == 1);
    CHECK(type_at(singular, i).b == 3);
    CHECK(type_at(singular, t).a == 0);
    CHECK(type_at(singular, t).b == 2);
    CHECK(type_at(singular, poly({5, 0, 2})).b == 1);
  }
  const SingularConics singular = singular_conics(conic_family(c));
  CHECK(singular.at_infinity.a == 0);
  CHECK(singular.at_infinity.b == 4);
}

TEST_CASE("All zeros of det C are counted, those at infinity too", "[conic_family]") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const NamedConic conic = RandomConics(seed).next();
    INFO(conic.kind << ", seed " << seed);
    if (determinant(conic.matrix).is_zero()) continue;
    const ConicFamily family = conic_family(conic.matrix);
    const SingularConics singular = singular_conics(family);
    int sum = singular.at_infinity.a + singular.at_infinity.b;
    for (const SingularFactor& part : singular.finite) {
      CHECK(part.type.a <= part.type.b);
      sum += (part.type.a + part.type.b) * part.factor.degree();
    }
    CHECK(sum == 3 * family.twist);
  }
}

TEST_CASE("Intervals without real points are found, and their ends", "[conic_family]") {
  // Real where (t - 1)(t - 3) < 0.
  const ConicFamily family = conic_family(diagonal(1L, 1L, poly({3, -4, 1})));
  CHECK_FALSE(interval_without_real_points(family, Rational(1), Rational(3)));
  CHECK_FALSE(interval_without_real_points(family, Rational(2), Rational(5) / Rational(2)));
  const auto left = interval_without_real_points(family, Rational(0), Rational(2));
  REQUIRE(left);
  CHECK_FALSE(left->begin);
  CHECK(*left->end == Approx(1));
  const auto right = interval_without_real_points(family, Rational(2), Rational(7));
  REQUIRE(right);
  CHECK(*right->begin == Approx(3));
  CHECK_FALSE(right->end);
  CHECK(interval_without_real_points(family));
}

TEST_CASE("Matrices that are not symmetric or always singular are refused", "[conic_family]") {
  const RationalPolynomial zero, one(1L);
  CHECK(code_of([&] {
          conic_family({{{one, one, zero}, {zero, one, zero}, {zero, zero, one}}});
        }) == ErrorCode::kWrongShape);
  CHECK(code_of([&] {
          conic_family(diagonal(1L, poly({0, 1}), zero));
        }) == ErrorCode::kSingularConics);
}
