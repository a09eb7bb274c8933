// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/thick_solid.hpp"

#include <BRepClass3d_SolidClassifier.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <catch2/catch.hpp>

#include "pn/occt/curve_on_surface.hpp"
#include "pn/occt/mass.hpp"
#include "pn/occt/shape_check.hpp"
#include "pn/occt/shell.hpp"
#include "trimmed_surfaces.hpp"

using pn::make_shell;
using pn::make_thick_solid;
using pn::volume;
using pn::test::kPi;
using pn::test::torus;
using pn::test::turned_round;

namespace {

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

void check_clean(const TopoDS_Shape& shape) {
  CHECK(pn::faults(shape) == std::vector<std::string>());
  CHECK(pn::boolean_faults(shape) == std::vector<std::string>());
}

// The x and y of the poles times `factor`.
void widen(pn::BSplineSurface& surface, double factor) {
  for (auto& [x, y, z] : surface.poles) {
    x *= factor;
    y *= factor;
  }
}

// `wavy_tube` with a wave that is smooth at the seam, `wave_factor` as high, and another radius.
// (In a closed wall with a corner OpenCASCADE's Boolean check sees an intersection that is none.)
pn::BSplineSurface smooth_wavy_tube(double radius, double wave_factor = 1) {
  auto tube = pn::test::wavy_tube();
  widen(tube, radius / 2);
  tube.trims[0][1].poles[5] = {0.4, 3.5};
  for (auto& trim : tube.trims.front()) {
    for (auto& [u, v] : trim.poles) u *= wave_factor;
  }
  return tube;
}

TopAbs_State state(const TopoDS_Shape& solid, const gp_Pnt& point) {
  return BRepClass3d_SolidClassifier(solid, point, 1e-7).State();
}

}  // namespace

TEST_CASE("Between two ellipsoids") {
  const TopoDS_Solid solid = make_thick_solid(make_shell(pn::test::ellipsoid_halves(3, 2, 1)),
                                              make_shell(pn::test::ellipsoid_halves(4, 3, 2)));
  check_clean(solid);
  CHECK(count(solid, TopAbs_SHELL) == 2);
  CHECK(count(solid, TopAbs_FACE) == 4);
  CHECK(volume(solid) == Approx(4 * kPi / 3 * (24 - 6)).epsilon(1e-13));
  CHECK(state(solid, {0, 0, 0}) == TopAbs_OUT);
  CHECK(state(solid, {3.5, 0, 0}) == TopAbs_IN);
  CHECK(state(solid, {4.5, 0, 0}) == TopAbs_OUT);
}

TEST_CASE("Between two tori, whichever way their faces point") {
  const double exact = 2 * kPi * kPi * 5 * (4 - 1);
  for (const auto& inner : {torus(5, 1), turned_round(torus(5, 1))}) {
    for (const auto& outer : {torus(5, 2), turned_round(torus(5, 2))}) {
      const TopoDS_Solid solid = make_thick_solid(make_shell({inner}), make_shell({outer}));
      CHECK(pn::faults(solid).empty());
      CHECK(volume(solid) == Approx(exact).epsilon(1e-13));
      CHECK(pn::area(solid) == Approx(4 * kPi * kPi * 5 * (1 + 2)).epsilon(1e-13));
    }
  }
}

TEST_CASE("The shells stay as they are") {
  const TopoDS_Shell inner = make_shell({torus(5, 1)});
  const double before = volume(inner);
  make_thick_solid(inner, make_shell({torus(5, 2)}));
  CHECK(volume(inner) == before);
}

TEST_CASE("Closed faces make a void, as their shells do") {
  const TopoDS_Solid solid =
      make_thick_solid(pn::test::ellipsoid_halves(3, 2, 1), pn::test::ellipsoid_halves(4, 3, 2));
  CHECK(count(solid, TopAbs_SHELL) == 2);
  CHECK(volume(solid) == Approx(4 * kPi / 3 * (24 - 6)).epsilon(1e-13));
}

TEST_CASE("A pipe: two tubes and two flat rings") {
  const TopoDS_Solid solid =
      make_thick_solid({pn::test::tube(2, 0, 2, 5)}, {pn::test::tube(3, 0, 3, 5)});
  check_clean(solid);
  CHECK(count(solid, TopAbs_SHELL) == 1);
  CHECK(count(solid, TopAbs_FACE) == 4);
  CHECK(count(solid, TopAbs_EDGE) == 4 + 2 + 2);
  CHECK(volume(solid) == Approx(kPi * (9 - 4) * 5).epsilon(1e-13));
  CHECK(pn::trim_deviation(solid) < 1e-14);
}

TEST_CASE("A patch: six faces, twelve edges, eight vertices") {
  const auto quarter = [](double r) {
    return pn::test::revolve(pn::test::line({r, 0}, {r, 5}), pn::test::circle_arcs(1, 2));
  };
  for (const auto& [inner, outer] :
       {std::pair(quarter(2), quarter(3)), std::pair(quarter(3), quarter(2)),
        std::pair(turned_round(quarter(2)), turned_round(quarter(3)))}) {
    const TopoDS_Solid solid = make_thick_solid({inner}, {outer});
    check_clean(solid);
    CHECK(count(solid, TopAbs_FACE) == 6);
    CHECK(count(solid, TopAbs_EDGE) == 12);
    CHECK(count(solid, TopAbs_VERTEX) == 8);
    CHECK(volume(solid) == Approx(kPi * (9 - 4) * 5 / 4).epsilon(1e-13));
  }
}

TEST_CASE("A chain has walls at its ends only") {
  auto wider = pn::test::three_tubes();
  for (auto& tube : wider) {
    for (auto& [x, y, z] : tube.poles) {
      x *= 1.5;
      y *= 1.5;
    }
  }
  const TopoDS_Solid solid = make_thick_solid(pn::test::three_tubes(), wider);
  check_clean(solid);
  CHECK(count(solid, TopAbs_FACE) == 8);
  CHECK(volume(solid) == Approx(1.25 * pn::test::three_tubes_volume()).epsilon(1e-13));
}

TEST_CASE("A patch with a pole has no wall there") {
  const auto sector = [](double r) {
    auto half = pn::test::revolve(pn::test::half_circle(), pn::test::circle_arcs(0, 1));
    for (auto& pole : half.poles) {
      for (double& x : pole) x *= r;
    }
    return half;
  };
  // The two poles of the inner and outer sector are joined by an edge of both walls.
  const TopoDS_Solid solid = make_thick_solid({sector(1)}, {sector(2)});
  check_clean(solid);
  CHECK(count(solid, TopAbs_FACE) == 4);
  CHECK(volume(solid) == Approx(kPi / 3 * (8 - 1)).epsilon(1e-13));
}

TEST_CASE("A pole may lie opposite an arc") {
  using pn::test::half_circle;
  const auto arc = pn::test::circle_arcs(0, 1);
  const auto inner = pn::test::revolve(half_circle(), arc);
  const auto outer = pn::test::revolve(pn::test::scaled(half_circle(), 1.5, 1), arc);
  const TopoDS_Solid solid = make_thick_solid({inner}, {outer});
  check_clean(solid);
  CHECK(count(solid, TopAbs_FACE) == 6);
  // Inside the outer surface, less a ball and two cones.
  const double whole = kPi * (7.5 + 2.25 * kPi) - 4 * kPi / 3 - 2 * kPi * 0.5 / 3;
  CHECK(volume(solid) == Approx(whole / 4).epsilon(1e-13));
}

TEST_CASE("A trimmed pipe has a wall along its wave") {
  const TopoDS_Solid solid = make_thick_solid({smooth_wavy_tube(2)}, {smooth_wavy_tube(3)});
  check_clean(solid);
  CHECK(count(solid, TopAbs_FACE) == 4);
  CHECK(count(solid, TopAbs_EDGE) == 4 + 2 + 2);
  CHECK(count(solid, TopAbs_VERTEX) == 4);
  CHECK(pn::trim_deviation(solid) < 2e-9);
  // The tubes are cylinders of height 5 u: both areas are cut off alike, as sectors are.
  const double inner = pn::area(make_shell({smooth_wavy_tube(2)}));
  CHECK(volume(solid) == Approx(inner / 2 * (9 - 4) / 2).epsilon(1e-9));
}

TEST_CASE("A hole has a wall around it") {
  auto wide = pn::test::tube_with_hole_across_seam();
  widen(wide, 1.5);
  const auto tube = pn::test::tube_with_hole_across_seam();
  const TopoDS_Solid solid = make_thick_solid({tube}, {wide});
  check_clean(solid);
  CHECK(volume(solid) == Approx(pn::area(make_shell({tube})) / 2 * (9 - 4) / 2).epsilon(1e-9));
}

TEST_CASE("Walls along pieces of sides, where neighbours share the rest") {
  const auto inner = pn::test::trimmed_neighbours();
  const auto between = [&inner](double factor) {
    auto outer = inner;
    for (auto& face : outer) widen(face, factor);
    return make_thick_solid(inner, outer);
  };
  const TopoDS_Solid solid = between(1.5);
  check_clean(solid);
  // Two faces of four edges each have one in common.
  CHECK(count(solid, TopAbs_FACE) == 4 + 6);
  CHECK(count(solid, TopAbs_EDGE) == 2 * 7 + 6);
  // The volume is that of sectors, and goes with the square of the factor.
  CHECK(volume(solid) / volume(between(2)) == Approx(1.25 / 3).epsilon(1e-9));
}

TEST_CASE("Several parts make several solids") {
  const auto pair = [](double factor, std::vector<pn::BSplineSurface> faces) {
    for (auto& face : faces) widen(face, factor);
    auto upper = faces;
    for (auto& face : upper) {
      for (auto& [x, y, z] : face.poles) z += 20;
    }
    faces.insert(faces.end(), upper.begin(), upper.end());
    return faces;
  };
  SECTION("open ones") {
    const auto solids =
        pn::make_thick_solids(pair(1, {smooth_wavy_tube(2)}), pair(1.5, {smooth_wavy_tube(2)}));
    REQUIRE(solids.size() == 2);
    check_clean(solids[0]);
    CHECK(volume(solids[1]) == Approx(volume(solids[0])).epsilon(1e-12));
    CHECK_THROWS_WITH(
        make_thick_solid(pair(1, {smooth_wavy_tube(2)}), pair(1.5, {smooth_wavy_tube(2)})),
        Catch::Contains("hang together"));
  }
  SECTION("closed ones") {
    const auto inner = pair(1, pn::test::ellipsoid_halves(3, 2, 1));
    const auto outer = pair(1, pn::test::ellipsoid_halves(4, 3, 2));
    const auto solids = pn::make_thick_solids(inner, outer);
    REQUIRE(solids.size() == 2);
    for (const TopoDS_Solid& solid : solids) {
      CHECK(count(solid, TopAbs_SHELL) == 2);
      CHECK(volume(solid) == Approx(4 * kPi / 3 * (24 - 6)).epsilon(1e-13));
    }
  }
}

TEST_CASE("Closed shells of other structure make a void as well") {
  auto slow = torus(5, 2);
  for (double& knot : slow.v_knots) knot *= 2;
  const TopoDS_Solid solid = make_thick_solid({torus(5, 1)}, {slow});
  CHECK(volume(solid) == Approx(2 * kPi * kPi * 5 * (4 - 1)).epsilon(1e-13));
}

TEST_CASE("Only the free sides of two pipes need to correspond") {
  const auto tube = pn::test::tube(2, 0, 2, 7);
  const std::vector wide = {pn::test::tube(3, 0, 3, 5), pn::test::tube(3, 5, 3, 7)};
  const double wall = kPi * (9 - 4) * 7;
  for (const TopoDS_Solid& solid :
       {make_thick_solid({tube}, wide), make_thick_solid({tube}, {wide[1], wide[0]})}) {
    check_clean(solid);
    CHECK(count(solid, TopAbs_FACE) == 5);
    CHECK(volume(solid) == Approx(wall).epsilon(1e-13));
  }
}

TEST_CASE("Open faces that do not correspond are refused") {
  const auto tube = pn::test::tube(2, 0, 2, 5);
  const auto wide = pn::test::tube(3, 0, 3, 5);
  auto slow = wide;
  for (double& knot : slow.u_knots) knot *= 2;
  for (double& knot : slow.v_knots) knot *= 2;
  CHECK_THROWS_WITH(make_thick_solid({tube}, {slow}), Catch::Contains("correspond"));
  const auto quarter =
      pn::test::revolve(pn::test::line({3, 0}, {3, 5}), pn::test::circle_arcs(1, 2));
  CHECK_THROWS_WITH(make_thick_solid({tube}, {quarter}), Catch::Contains("correspond"));
  CHECK_THROWS_WITH(make_thick_solid({tube}, {torus(5, 2)}), Catch::Contains("open"));
  CHECK_THROWS_WITH(make_thick_solid({smooth_wavy_tube(2)}, {smooth_wavy_tube(3, 0.7)}),
                    Catch::Contains("correspond"));
  CHECK_THROWS_WITH(make_thick_solid({smooth_wavy_tube(2)}, {wide}), Catch::Contains("correspond"));
}

TEST_CASE("Shells without a solid between them are refused") {
  const TopoDS_Shell thin = make_shell({torus(5, 1)});
  const TopoDS_Shell thick = make_shell({torus(5, 2)});
  const TopoDS_Shell open = make_shell({pn::test::tube(2, 0, 2, 5)});
  CHECK_THROWS_WITH(make_thick_solid(thick, thin), Catch::Contains("does not lie inside"));
  CHECK_THROWS_WITH(make_thick_solid(thin, thin), Catch::Contains("does not lie inside"));
  CHECK_THROWS_WITH(make_thick_solid(open, thick), Catch::Contains("open"));
  CHECK_THROWS_WITH(make_thick_solid(thin, open), Catch::Contains("open"));
  CHECK_THROWS_AS(make_thick_solid(make_shell({torus(50, 1)}), thick), std::invalid_argument);
}
