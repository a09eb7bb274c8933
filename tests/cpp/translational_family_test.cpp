// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/translational_family.hpp"

#include <catch2/catch.hpp>

#include "random_sphere_families.hpp"
#include "random_translational_families.hpp"

using namespace pn;
using namespace pn::test;

namespace {

Rational ratio(long a, long b) { return Rational(a) / Rational(b); }

MinkowskiVector<Rational> at(const SphereParabola& c, const Rational& t) {
  MinkowskiVector<Rational> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] = c.second[i] * t * t / Rational(2L) + c.first[i] * t + c.start[i];
  }
  return result;
}

MinkowskiVector<Rational> sum(MinkowskiVector<Rational> a, const MinkowskiVector<Rational>& b) {
  for (std::size_t i = 0; i < 4; ++i) a[i] += b[i];
  return a;
}

const std::array<std::array<double, 4>, 3>
    kAlongX = {{{0, 0, 0, 1}, {2, 0, 1, 1.25}, {4, 0, 0, 1}}},
    kAlongY = {{{0, 0, 0, 1}, {0, 2, -1, 1}, {0, 4, 0, 1.5}}},
    kLineX = {{{0, 0, 0, 1}, {2, 0, 0, 1.5}, {4, 0, 0, 2}}},
    kLineY = {{{0, 0, 0, 1}, {0, 2, 0, 1}, {0, 4, 0, 1}}};

}  // namespace

TEST_CASE("f is the sum of both curves, on both triangles of the square",
          "[translational_family]") {
  const TranslationalFamily family = family_of(kAlongX, kAlongY);
  const auto [low, high] = triangles(family);
  for (const auto& [u, v] : {std::array{ratio(1, 3), ratio(2, 7)}, {ratio(5, 2), ratio(-1, 9)}}) {
    const auto expected = sum(at(family.c, u), at(family.d, v));
    CHECK(jet(quadratic_family(family), u, v).value == expected);
    CHECK(jet(low, u, v).value == expected);
    CHECK(jet(high, Rational(1L) - u, Rational(1L) - v).value == expected);
    CHECK(jet(low, u, v).by_u == family.c.slope(u));
    CHECK(jet(low, u, v).by_v == family.d.slope(v));
  }
}

TEST_CASE("Parts and halves of a curve are the same curve", "[translational_family]") {
  const SphereParabola c = family_of(kAlongX, kAlongY).c;
  const SphereParabola part = c.part(ratio(1, 5), ratio(3, 7));
  for (const Rational& t : {ratio(0, 1), ratio(2, 3), ratio(1, 1)}) {
    CHECK(at(part, t) == at(c, ratio(1, 5) + ratio(3, 7) * t));
  }
  const SphereParabolas curve{{Rational(2L), Rational(3L), Rational(7L)}, {c, part}};
  const SphereParabolas halved = curve.halved(1);
  CHECK(halved.breaks ==
        std::vector<Rational>{Rational(2L), Rational(3L), Rational(5L), Rational(7L)});
  REQUIRE(halved.spans.size() == 3);
  CHECK(at(halved.spans[0], ratio(1, 3)) == at(c, ratio(1, 3)));
  CHECK(at(halved.spans[1], ratio(1, 3)) == at(part, ratio(1, 6)));
  CHECK(at(halved.spans[2], ratio(1, 3)) == at(part, ratio(2, 3)));
}

TEST_CASE("Where the envelope is not real is found on either triangle", "[translational_family]") {
  CHECK_FALSE(unreal_place(family_of(kAlongX, kAlongY)));
  auto steep = kAlongX;
  steep[2][3] = 8;  // from 1.25 to 8 over a step of 2
  const auto at_end = unreal_place(family_of(steep, kAlongY));
  REQUIRE(at_end);
  CHECK((*at_end)[0] > 0.5);
  auto both = kAlongY;  // together too steep at (1, 1) only
  both[2][3] = 3;
  auto other = kAlongX;
  other[2][3] = 3.25;
  const auto corner = unreal_place(family_of(other, both));
  REQUIRE(corner);
  CHECK((*corner)[0] + (*corner)[1] > 1);
}
