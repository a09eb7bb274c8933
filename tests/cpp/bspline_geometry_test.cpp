// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/bspline_geometry.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "pn/occt/caps.hpp"
#include "pn/occt/occt_error.hpp"
#include "pn/occt/shell.hpp"
#include "surfaces_of_revolution.hpp"

using pn::from_geometry;
using pn::to_geometry;
using pn::test::same_surface;

TEST_CASE("A surface comes back from OpenCASCADE bit for bit") {
  for (const auto& surface :
       {pn::test::torus(5, 2), pn::test::tube(2, 0, 3, 5), pn::test::sphere_halves()[1]}) {
    CHECK(same_surface(from_geometry(*to_geometry(surface)), surface));
  }
}

TEST_CASE("A periodic surface comes back clamped, bit for bit") {
  const auto torus = pn::test::torus(5, 2);
  const auto geometry = to_geometry(torus);
  geometry->SetUPeriodic();
  geometry->SetVPeriodic();
  REQUIRE(geometry->NbUPoles() < static_cast<int>(torus.u_count()));
  CHECK(same_surface(from_geometry(*geometry), torus));
}

TEST_CASE("OpenCASCADE evaluates the torus that the poles mean") {
  const auto geometry = to_geometry(pn::test::torus(5, 2));
  for (double u = 0; u <= 4; u += 0.37) {
    for (double v = 0; v <= 4; v += 0.37) {
      const gp_Pnt p = geometry->Value(u, v);
      CHECK(std::hypot(std::hypot(p.X(), p.Y()) - 5, p.Z()) == Approx(2).epsilon(1e-14));
    }
  }
}

TEST_CASE("Arrays that are no surface are refused") {
  auto surface = pn::test::tube(2, 0, 3, 5);
  SECTION("a pole too few") { surface.poles.pop_back(); }
  SECTION("a weight too many") { surface.weights.push_back(1); }
  SECTION("a knot without multiplicity") { surface.u_knots.push_back(9); }
  SECTION("no knots") {
    surface.u_knots.clear();
    surface.u_multiplicities.clear();
  }
  SECTION("not clamped") { surface.v_multiplicities.front() = 4; }
  SECTION("a pole at infinity") { surface.poles[2][1] = std::numeric_limits<double>::infinity(); }
  CHECK_THROWS_AS(to_geometry(surface), std::invalid_argument);
}

TEST_CASE("What OpenCASCADE refuses is reported in its words") {
  auto surface = pn::test::tube(2, 0, 3, 5);
  surface.weights[1] = -1;
  CHECK_THROWS_WITH(to_geometry(surface), Catch::Contains("Standard_ConstructionError"));
}

TEST_CASE("Surfaces of a shape are those of its faces, in order") {
  const auto tubes = pn::test::three_tubes();
  const auto found = pn::bspline_surfaces(pn::make_shell(tubes));
  REQUIRE(found.size() == 3);
  for (int i = 0; i < 3; ++i) CHECK(same_surface(found[i], tubes[i]));
}

TEST_CASE("A planar cap has no B-spline surface") {
  const auto solid = pn::make_capped_solid(pn::make_shell(pn::test::three_tubes()));
  CHECK_THROWS_AS(pn::bspline_surfaces(solid), std::invalid_argument);
}
