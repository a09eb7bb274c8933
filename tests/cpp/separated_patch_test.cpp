// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/separated_patch.hpp"

#include <catch2/catch.hpp>

#include "special_sphere_families.hpp"

using namespace pn;
using namespace pn::test;

TEST_CASE("Separated patches have the parameters of the family, seen from outside",
          "[separated_patch]") {
  using Parameters = std::array<double, 2>;
  for (const auto& [name, spheres] : separated_spheres()) {
    INFO(name);
    const auto outer = separated_patch(family_of(spheres), Sheet::kOuter),
               inner = separated_patch(family_of(spheres), Sheet::kInner);
    REQUIRE(outer);
    REQUIRE(inner);
    CHECK(outer->place_of({0.25, 0.5}) == Parameters{0.25, 0.5});
    CHECK(inner->place_of({0.25, 0.5}) == Parameters{0.5, 0.25});
    for (const auto& patch : {*outer, *inner}) {
      CHECK(patch.weight_ratio > 0);
      CHECK((patch.degree[0] <= 6 && patch.degree[1] <= 6));
    }
  }
}

TEST_CASE("Sheets that are not separated have no such patch", "[separated_patch]") {
  CHECK_FALSE(separated_patch(family_of(RandomSphereFamily(1).spheres()), Sheet::kOuter));
  CHECK_FALSE(separated_patch(family_of(developable_spheres()[0].spheres), Sheet::kInner));
}
