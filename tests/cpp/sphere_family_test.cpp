// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/sphere_family.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "error_code.hpp"
#include "random_sphere_families.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const ControlSpheres kPlate = {
    {{10, 0, 0, 1}, {5, 5, 1, 1.5}, {0, 10, 0, 1}, {5, 0, 1, 1.25}, {0, 5, 1, 1.25}, {0, 0, 0, 1}}};

std::optional<ErrorCode> refusal(const ControlSpheres& spheres) {
  return code_of([&] { sphere_family(spheres); });
}

}  // namespace

TEST_CASE("A plate is accepted as it is", "[sphere_family]") {
  const SphereFamily plate = sphere_family(kPlate);
  CHECK(plate.family.control() == family_of(kPlate).control());
  CHECK(plate.notes.empty());
}

TEST_CASE("Equal radii are said to be an offset of the mid-surface", "[sphere_family]") {
  ControlSpheres spheres = kPlate;
  for (auto& sphere : spheres) sphere[3] = 1;
  REQUIRE(sphere_family(spheres).notes.size() == 1);
  CHECK(sphere_family(spheres).notes[0].find("offsets of the mid-surface") != std::string::npos);
}

TEST_CASE("What has no skins is refused with a reason", "[sphere_family]") {
  for (const double bad : {double(NAN), double(INFINITY)}) {
    ControlSpheres spheres = kPlate;
    spheres[3][2] = bad;
    CHECK(refusal(spheres) == ErrorCode::kNotFinite);
  }
  ControlSpheres point = kPlate, line = kPlate, swallowed = kPlate, folded = kPlate;
  for (auto& sphere : point) sphere = {1, 2, 3, sphere[3]};
  CHECK(refusal(point) == ErrorCode::kZeroLength);
  for (std::size_t i = 0; i < 6; ++i) {
    const double at = static_cast<double>(i * i);
    line[i] = {1 + at, 2 - at, 3 * at, 1};
  }
  CHECK(refusal(line) == ErrorCode::kZeroLength);
  swallowed[0][3] = 30;
  CHECK(refusal(swallowed) == ErrorCode::kRadiusTooSteep);
  // The corners of a flat triangle on one line: the mid-surface is singular along it.
  folded[1] = {5, 0, 0, 1};
  folded[2] = {0, 0, 0, 1};
  CHECK(refusal(folded));
}
