// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/minkowski_vector.hpp"

#include <catch2/catch.hpp>

#include "minkowski_cases.hpp"

using namespace pn;
using namespace pn::test;

TEST_CASE("The causal type of a vector is the sign of its square", "[minkowski]") {
  const auto type = [](long x1, long x2, long x3, long x4) {
    const MinkowskiVector<Rational> x = {x1, x2, x3, x4};
    return causal_type(minkowski(x, x));
  };
  CHECK(type(3, 4, 12, 13) == CausalType::kLightLike);
  CHECK(type(3, 4, 12, -12) == CausalType::kSpaceLike);
  CHECK(type(3, 4, 12, 14) == CausalType::kTimeLike);
}

TEST_CASE("A plane has as many isotropic directions as its type says", "[minkowski]") {
  // Spanned by an isotropic w and x: w is one, and 2 <w, x> x - <x, x> w the only other one.
  RandomRationals random(1);
  for (int i = 0; i < 20; ++i) {
    const auto w = RandomRationals::isotropic(random(), random());
    auto x = random.vector();
    CHECK(causal_type(gram_determinant(w, x)) ==
          (minkowski(w, x).is_zero() ? CausalType::kLightLike : CausalType::kTimeLike));
    // Moved into the hyperplane of w, the plane keeps w alone.
    const MinkowskiVector<Rational> axis = {0L, 0L, 0L, 1L};
    x = translated(x, -minkowski(w, x) / minkowski(w, axis), axis);
    CHECK(causal_type(gram_determinant(w, x)) == CausalType::kLightLike);
  }
  const MinkowskiVector<Rational> e1 = {1L, 0L, 0L, 0L}, e2 = {2L, 1L, 0L, 0L};
  CHECK(causal_type(gram_determinant(e1, e2)) == CausalType::kSpaceLike);
}
