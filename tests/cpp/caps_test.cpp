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
#include "surfaces_of_revolution.hpp"

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

TEST_CASE("A closed shell becomes a solid as it is") {
  const TopoDS_Shell shell = make_shell({pn::test::torus(5, 2)});
  const TopoDS_Solid solid = make_capped_solid(shell);
  check_clean(solid);
  CHECK(volume(solid) == Approx(2 * kPi * kPi * 5 * 4).epsilon(1e-12));
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
    CHECK_THROWS_AS(capped({half}), std::invalid_argument);
  }
  SECTION("a circle with one pole out of its plane") {
    auto tube = pn::test::tube(2, 0, 2, 5);
    tube.poles[5][2] += 1e-5;
    CHECK_THROWS_AS(capped({tube}), std::invalid_argument);
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
