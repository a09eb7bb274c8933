// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/caps.hpp"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <catch2/catch.hpp>

#include "pn/occt/mass.hpp"
#include "pn/occt/shape_check.hpp"
#include "pn/occt/shell.hpp"
#include "trimmed_surfaces.hpp"

using pn::make_capped_solid;
using pn::make_shell;
using pn::volume;
using pn::test::kPi;

namespace {

TopoDS_Solid capped(const std::vector<pn::BSplineSurface>& surfaces) {
  return make_capped_solid(make_shell(surfaces));
}

void check_clean(const TopoDS_Shape& shape) {
  CHECK(pn::faults(shape) == std::vector<std::string>());
  CHECK(pn::boolean_faults(shape) == std::vector<std::string>());
}

}  // namespace

TEST_CASE("A capped tube is a cylinder") {
  const TopoDS_Solid solid = capped({pn::test::tube(2, 0, 2, 5)});
  check_clean(solid);
  CHECK(volume(solid) == Approx(20 * kPi).epsilon(1e-12));
  CHECK(pn::area(solid) == Approx(28 * kPi).epsilon(1e-12));
}

TEST_CASE("A chain of tubes, capped, holds the volume of its frusta") {
  const TopoDS_Solid solid = capped(pn::test::three_tubes());
  check_clean(solid);
  CHECK(volume(solid) == Approx(pn::test::three_tubes_volume()).epsilon(1e-12));
}

TEST_CASE("A cap may have several edges") {
  std::vector<pn::BSplineSurface> quarters;
  for (int arc = 0; arc < 4; ++arc) {
    quarters.push_back(
        pn::test::revolve(pn::test::line({2, 0}, {2, 5}), pn::test::circle_arcs(arc, arc + 1)));
  }
  const TopoDS_Solid solid = capped(quarters);
  check_clean(solid);
  CHECK(volume(solid) == Approx(20 * kPi).epsilon(1e-12));
}

TEST_CASE("Caps use the edges of the tube: no edge is free or doubled") {
  const TopoDS_Solid solid = capped({pn::test::tube(2, 0, 2, 5)});
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  CHECK(faces_of_edge.Extent() == 3);
  for (int i = 1; i <= faces_of_edge.Extent(); ++i) CHECK(faces_of_edge(i).Extent() == 2);
  CHECK(TopExp_Explorer(solid, TopAbs_SHELL).Current().Closed());
}

TEST_CASE("A shell that points inwards still makes a solid that points outwards") {
  const auto inwards = pn::test::turned_round(pn::test::tube(2, 0, 2, 5));
  const TopoDS_Solid solid = capped({inwards});
  check_clean(solid);
  CHECK(volume(solid) == Approx(20 * kPi).epsilon(1e-12));
}

TEST_CASE("A cap closes a trimmed end") {
  SECTION("a spherical cap") {
    const TopoDS_Solid solid = capped(pn::test::up_to(pn::test::sphere_halves(), 0.7));
    check_clean(solid);
    const double h = 1 + pn::test::height(0.7);
    CHECK(volume(solid) == Approx(kPi * h * h * (3 - h) / 3).epsilon(1e-10));
    CHECK(pn::area(solid) == Approx(2 * kPi * h + kPi * h * (2 - h)).epsilon(1e-10));
  }
  SECTION("an ellipsoid cut in two") {
    const TopoDS_Solid solid = capped(pn::test::up_to(pn::test::ellipsoid_halves(3, 2, 1), 0.5));
    check_clean(solid);
    CHECK(volume(solid) == Approx(4 * kPi).epsilon(1e-10));
  }
}

TEST_CASE("A cap may run pieces of sides") {
  SECTION("whole rims in two pieces each") {
    const TopoDS_Solid solid = capped({pn::test::within(
        pn::test::tube(2, 0, 2, 5),
        {pn::test::polygon({{0, 0}, {1, 0}, {1, 1.3}, {1, 4}, {0, 4}, {0, 2.7}})})});
    check_clean(solid);
    CHECK(volume(solid) == Approx(20 * kPi).epsilon(1e-12));
  }
  SECTION("a piece whose side leaves the plane elsewhere") {
    // z = 2 u (1 - u) 2 v (1 - v) up to v = 1; beyond, the sides rise.
    pn::BSplineSurface surface{2, 2, {0, 1}, {0, 1, 2}, {3, 3}, {3, 1, 3}, {}, {}, {}};
    const std::array<double, 4> y = {0, 0.5, 1.5, 2};
    const std::array<double, 4> bump = {0, 1, -1, 5};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j) {
        const double z = i == 1 || j == 3 ? bump[j] : 0;
        surface.poles.push_back({i / 2., y[j], z});
        surface.weights.push_back(1);
      }
    }
    const TopoDS_Solid solid =
        capped({pn::test::within(surface, {pn::test::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})})});
    CHECK(pn::faults(solid).empty());
    CHECK(volume(solid) == Approx(1. / 9).epsilon(1e-9));
  }
}

TEST_CASE("A closed shell becomes a solid as it is") {
  const TopoDS_Shell shell = make_shell({pn::test::torus(5, 2)});
  const TopoDS_Solid solid = make_capped_solid(shell);
  check_clean(solid);
  CHECK(volume(solid) == Approx(2 * kPi * kPi * 5 * 4).epsilon(1e-12));
  const TopoDS_Solid ellipsoid = capped(pn::test::ellipsoid_halves(3, 2, 1));
  check_clean(ellipsoid);
  CHECK(volume(ellipsoid) == Approx(8 * kPi).epsilon(1e-13));
}

TEST_CASE("The shell that is capped stays open") {
  const TopoDS_Shell shell = make_shell({pn::test::tube(2, 0, 2, 5)});
  make_capped_solid(shell);
  CHECK_FALSE(BRep_Tool::IsClosed(shell));
  CHECK_THROWS_AS(volume(shell), std::invalid_argument);
}

TEST_CASE("A cap far away from the origin is as flat") {
  auto far_tube = pn::test::tube(2, 0, 2, 5);
  for (auto& pole : far_tube.poles) {
    for (double& x : pole) x += 1e5;
  }
  CHECK(volume(capped({far_tube})) == Approx(20 * kPi).epsilon(1e-9));
}

TEST_CASE("A free boundary that is not planar cannot be capped") {
  SECTION("the rim of a half tube") {
    const auto half =
        pn::test::revolve(pn::test::line({2, 0}, {2, 5}), pn::test::circle_arcs(0, 2));
    CHECK_THROWS_WITH(capped({half}), Catch::Contains("leaves its plane by up to"));
  }
  SECTION("a circle with one pole out of its plane") {
    auto tube = pn::test::tube(2, 0, 2, 5);
    tube.poles[5][2] += 1e-5;
    CHECK_THROWS_WITH(capped({tube}), Catch::Contains("e-06 mm"));
  }
}

TEST_CASE("Cut and common with a box add up") {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0.1, 0.2, 0.3), 20, 20, 20).Shape();
  for (const TopoDS_Solid& solid :
       {capped(pn::test::three_tubes()), capped({pn::test::torus(5, 2)}),
        capped(pn::test::sphere_halves())}) {
    const TopoDS_Shape cut = BRepAlgoAPI_Cut(solid, box).Shape();
    const TopoDS_Shape common = BRepAlgoAPI_Common(solid, box).Shape();
    CHECK(pn::faults(cut).empty());
    CHECK(pn::faults(common).empty());
    CHECK(volume(cut) < volume(solid));
    // OpenCASCADE fits intersection curves to about 1e-6.
    CHECK(volume(cut) + volume(common) == Approx(volume(solid)).epsilon(1e-6));
  }
}
