// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/trim_region.hpp"

#include <catch2/catch.hpp>

#include "pn/bezier/parameter_curve.hpp"
#include "trimmed_surfaces.hpp"

using namespace pn;
using namespace pn::test;
using Part = TrimRegion::Part;

TEST_CASE("Without loops all parameters belong to the face", "[trim_region]") {
  const TrimRegion region{{}};
  CHECK(region.contains({7, -3}));
  CHECK(region.part_of({{-1, -1}, {9, 9}}) == Part::kAll);
}

TEST_CASE("A square with an oval hole", "[trim_region]") {
  const TrimRegion region(
      {polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), reversed(oval({2, 2}, 1, 0.5))});
  CHECK(region.contains({0.1, 0.1}));
  CHECK(region.contains({2, 2.6}));
  CHECK_FALSE(region.contains({2, 2.4}));
  CHECK_FALSE(region.contains({4.1, 1}));
  CHECK(region.part_of({{0.1, 0.1}, {0.9, 3.9}}) == Part::kAll);
  CHECK(region.part_of({{1.5, 1.9}, {2.5, 2.1}}) == Part::kNone);
  CHECK(region.part_of({{5, 5}, {6, 6}}) == Part::kNone);
  CHECK(region.part_of({{0.5, 0.5}, {3.5, 3.5}}) == Part::kSome);  // the hole is in it
  CHECK(region.part_of({{3.9, 1}, {4.1, 2}}) == Part::kSome);
  CHECK(region.part_of({{-9, 1}, {9, 2}}) == Part::kSome);  // no corner of either is in the other
}

TEST_CASE("What is nearer to an edge than chords follow it is not claimed", "[trim_region]") {
  const TrimLoop loop = oval({0, 0}, 1, 1);
  const TrimRegion region({loop});
  for (const ParameterCurve& curve : loop) {
    for (int i = 0; i <= 37; ++i) {
      const auto at = evaluate(curve, i / 37.0);
      CHECK_FALSE(region.contains(at));
      CHECK_FALSE(region.contains({1.00001 * at[0], 1.00001 * at[1]}));
      CHECK(region.contains({0.99 * at[0], 0.99 * at[1]}));
    }
  }
}
