// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/residue_field.hpp"

#include <catch2/catch.hpp>

using pn::Rational;
using pn::RationalPolynomial;
using pn::ResidueField;

namespace {
RationalPolynomial poly(const std::vector<long>& c) {
  return RationalPolynomial(std::vector<Rational>(c.begin(), c.end()));
}
const RationalPolynomial kOne(1L);
}  // namespace

TEST_CASE("Inverses of a residue field", "[residue_field]") {
  const ResidueField field(poly({-2, 0, 0, 1}));
  for (const auto& a : {poly({0, 1}), poly({1, 1}), poly({3, -1, 2}), poly({5})}) {
    CHECK(field.product(a, field.inverse(a)) == kOne);
  }
}

TEST_CASE("Squares of a residue field have their roots, also from a subfield", "[residue_field]") {
  for (const auto& modulus :
       {poly({-3, 1}), poly({1, 0, 1}), poly({-2, 0, 0, 1}), poly({-5, 0, 1, 1, 1}),
        poly({1, 0, 0, 0, 1}), poly({3, 1, 0, 0, 0, 2, 1})}) {
    const ResidueField field(modulus);
    for (const auto& root : {poly({2}), poly({1, 1}), poly({0, 0, 1}), poly({-4, 3, 1, 2})}) {
      const RationalPolynomial a = field.product(root, root);
      if (a.is_zero()) continue;
      const auto found = field.square_root(a);
      REQUIRE(found);
      CHECK(field.product(*found, *found) == a);
    }
  }
  // 2 = (sqrt 2)^2 where t^2 = 2, and -1 = t^4 where t^4 = -1.
  CHECK(ResidueField(poly({-2, 0, 1})).square_root(poly({2})));
  CHECK(ResidueField(poly({1, 0, 0, 0, 1})).square_root(poly({-1})));
}

TEST_CASE("What is no square has no root", "[residue_field]") {
  CHECK_FALSE(ResidueField(poly({-3, 1})).square_root(poly({2})));
  CHECK_FALSE(ResidueField(poly({-3, 1})).square_root(poly({-4})));
  CHECK_FALSE(ResidueField(poly({1, 0, 1})).square_root(poly({0, 1})));
  CHECK_FALSE(ResidueField(poly({1, 0, 1})).square_root(poly({3})));
  CHECK_FALSE(ResidueField(poly({-2, 0, 0, 1})).square_root(poly({0, 1})));
  // Squares in the complex numbers at each root, but not in the field.
  CHECK_FALSE(ResidueField(poly({-2, 0, 1})).square_root(poly({3})));
}
