// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/knot_insertion.hpp"

#include <catch2/catch.hpp>

#include "enclosures.hpp"

using namespace pn;
using namespace pn::test;

namespace {

Rational value(const SplineColumns<Rational>& spline, const Rational& x, std::size_t component) {
  const auto p = static_cast<std::size_t>(spline.degree);
  std::size_t last = p;
  while (last + p + 2 < spline.knots.size() && !(x < spline.knots[last + 1])) ++last;
  std::vector<Rational> active;
  for (std::size_t i = last - p; i <= last; ++i) active.push_back(spline.points[i][component]);
  return de_boor(spline.degree, spline.knots, last, std::move(active), x);
}

SplineColumns<Rational> spline() {
  SplineColumns<Rational> s{3, {}, {}};
  for (const long knot : {0L, 0L, 0L, 0L, 2L, 5L, 5L, 6L, 6L, 6L, 6L}) s.knots.emplace_back(knot);
  for (const long i : {1L, 4L, -2L, 0L, 7L, 3L, 5L})
    s.points.push_back({Rational(i), Rational(i * i)});
  return s;
}

const auto kSame = [](const Rational& x) { return x; };

}  // namespace

TEST_CASE("One more knot leaves every value, exactly", "[knot_insertion]") {
  const SplineColumns<Rational> before = spline();
  for (const long quarters : {1L, 8L, 11L, 20L, 21L}) {
    const Rational knot = Rational(quarters) / Rational(4L);
    const SplineColumns<Rational> after = with_knot(before, knot, kSame);
    REQUIRE(after.points.size() == before.points.size() + 1);
    REQUIRE(after.knots.size() == before.knots.size() + 1);
    CHECK(std::is_sorted(after.knots.begin(), after.knots.end()));
    for (long eighths = 0; eighths <= 47; ++eighths) {
      const Rational x = Rational(eighths) / Rational(8L);
      for (const std::size_t component : {0, 1}) {
        CHECK(value(after, x, component) == value(before, x, component));
      }
    }
  }
}

TEST_CASE("A knot inserted to full multiplicity gives the value as a control point",
          "[knot_insertion]") {
  const Rational knot = Rational(7L) / Rational(2L);
  SplineColumns<Rational> s = spline();
  for (int i = 0; i < s.degree; ++i) s = with_knot(s, knot, kSame);
  const Rational expected = value(spline(), knot, 1);
  CHECK(std::any_of(s.points.begin(), s.points.end(),
                    [&](const auto& point) { return point[1] == expected; }));
}
