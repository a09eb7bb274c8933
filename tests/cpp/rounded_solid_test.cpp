// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/rounded_solid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "error_code.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "random_sphere_families.hpp"

using namespace pn;
using namespace pn::test;
using Eigen::Vector3d;

TEST_CASE("A solid has two skins, three strips and three lunes", "[rounded_solid]") {
  const QuadraticFamily family = family_of(RandomSphereFamily(1).spheres());
  const auto source = std::make_shared<const RoundedSolid>(family, std::vector<std::string>{});
  CHECK(source->patches().size() == 8);
  const PNSurface solid = PNSurface(source).offset(0.01);
  CHECK(solid.faces(Lines::kEven).size() == 8);
  CHECK(solid.certificate(Lines::kEven).exact);
  const OffsetRange range = source->regular_range();
  double least = INFINITY;
  for (const auto& sphere : family.control()) least = std::min(least, -sphere[3].to_double());
  CHECK(range.lower == Approx(-least));
  CHECK(range.upper > 0);
}

TEST_CASE("A solid needs positive radii", "[rounded_solid]") {
  ControlSpheres spheres = RandomSphereFamily(1).spheres();
  spheres[3][3] = 0;
  CHECK(code_of([&] { RoundedSolid(family_of(spheres), {}); }) == ErrorCode::kNegativeRadius);
}
