// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/free_boundary.hpp"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <catch2/catch.hpp>
#include <stdexcept>

#include "pn/occt/mass.hpp"
#include "pn/occt/shell.hpp"
#include "trimmed_surfaces.hpp"

using pn::make_shell;
using pn::test::kPi;

namespace {

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  int found = 0;
  for (TopExp_Explorer part(shape, kind); part.More(); part.Next()) ++found;
  return found;
}

}  // namespace

TEST_CASE("Every free boundary gets one cap") {
  const TopoDS_Shell tube = make_shell({pn::test::tube(2, 0, 2, 5)});
  int caps = 0;
  const auto plane = [&caps](const TopoDS_Wire& wire) {
    ++caps;
    CHECK(count(wire, TopAbs_EDGE) == 1);
    return BRepBuilderAPI_MakeFace(wire, true).Face();
  };
  const TopoDS_Shell closed = pn::closed_by(plane, tube);
  CHECK(caps == 2);
  CHECK(count(closed, TopAbs_FACE) == 3);
  CHECK(BRep_Tool::IsClosed(closed));
  CHECK_FALSE(BRep_Tool::IsClosed(tube));
}

TEST_CASE("A closed shell gets none") {
  const auto none = [](const TopoDS_Wire&) -> TopoDS_Face { throw std::logic_error("no end"); };
  CHECK(BRep_Tool::IsClosed(pn::closed_by(none, make_shell({pn::test::torus(5, 2)}))));
}

TEST_CASE("The solid inside a shell points outwards, whichever way the shell does") {
  const TopoDS_Shell shell = make_shell({pn::test::torus(5, 2)});
  for (const TopoDS_Shape& turned : {TopoDS_Shape(shell), shell.Reversed()}) {
    CHECK(pn::volume(pn::solid_inside(TopoDS::Shell(turned))) ==
          Approx(2 * kPi * kPi * 5 * 4).epsilon(1e-12));
  }
}
