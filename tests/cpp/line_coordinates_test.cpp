// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/line_coordinates.hpp"

#include <catch2/catch.hpp>

#include "minkowski_cases.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Line = LineCoordinates<Rational>;

/// The polar plane of a point.
PlaneAtInfinity<Rational> polar_plane(const MinkowskiVector<Rational>& p) {
  return {p[0], p[1], p[2], -p[3]};
}

Line random_complex(RandomRationals& random) {
  return {random(), random(), random(), random(), random(), random()};
}

}  // namespace

TEST_CASE("The line of two points contains them and satisfies Klein's equation", "[minkowski]") {
  RandomRationals random(4);
  for (int i = 0; i < 10; ++i) {
    const auto p = random.vector(), q = random.vector(), x = random.vector();
    const Line l = join(p, q);
    CHECK(klein(l, l).is_zero());
    CHECK(incident(l, p));
    CHECK(incident(l, translated(p, random(), q)));
    CHECK_FALSE(incident(l, x));
    CHECK(klein(l, join(p, x)).is_zero());
    // The null planes of a line join it with the points.
    const auto e = null_plane(l, x);
    for (const auto& point : {p, q, x}) CHECK(incidence(e, point).is_zero());
    CHECK(proportional(meet(e, null_plane(l, random.vector())), l));
  }
}

TEST_CASE("The null plane of a complex holds its lines through the point", "[minkowski]") {
  RandomRationals random(5);
  for (int i = 0; i < 10; ++i) {
    const Line c = random_complex(random);
    const auto x = random.vector(), y = random.vector();
    const auto e = null_plane(c, x);
    CHECK(incidence(e, x).is_zero());
    CHECK((incidence(e, y) == klein(c, join(x, y)) || incidence(e, y) == -klein(c, join(x, y))));
    CHECK_FALSE(klein(c, join(x, y)).is_zero());
  }
}

TEST_CASE("Polar lines are those of orthogonal planes", "[minkowski]") {
  RandomRationals random(6);
  for (int i = 0; i < 10; ++i) {
    const auto p = random.vector(), q = random.vector();
    const Line l = join(p, q);
    CHECK(proportional(polar(l), meet(polar_plane(p), polar_plane(q))));
    CHECK(proportional(polar(polar(l)), l));
    CHECK(omega(l, l) == gram_determinant(p, q));
    const Line a = random_complex(random), b = random_complex(random);
    CHECK(klein(polar(a), polar(b)) == -klein(a, b));
    CHECK(omega(a, b) == omega(b, a));
  }
}

TEST_CASE("Normal and tangent lines of the worked examples are polar", "[minkowski]") {
  RandomRationals random(7);
  for (const auto& example : minkowski_cases()["families"]) {
    INFO(example["id"]);
    const std::map<std::string, Rational> at = {{"u", random()}, {"v", random()}};
    const Line normal = values<6>(example["normal_lines"], at);
    CHECK(klein(normal, normal).is_zero());
    CHECK(proportional(normal, polar(Line(values<6>(example["tangent_lines"], at)))));
  }
}
