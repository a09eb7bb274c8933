// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/brep.hpp"

#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <catch2/catch.hpp>
#include <set>

#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/caps.hpp"
#include "pn/occt/shell.hpp"
#include "pn/occt/thick_solid.hpp"
#include "trimmed_surfaces.hpp"

using pn::from_brep;
using pn::to_brep;

namespace {

std::set<std::array<double, 3>> vertices(const TopoDS_Shape& shape) {
  std::set<std::array<double, 3>> points;
  for (TopExp_Explorer vertex(shape, TopAbs_VERTEX); vertex.More(); vertex.Next()) {
    const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current()));
    points.insert({p.X(), p.Y(), p.Z()});
  }
  return points;
}

}  // namespace

TEST_CASE("Surfaces and vertices come back from BREP text bit for bit") {
  const std::vector<pn::BSplineSurface> surfaces = {pn::test::tube(1. / 3, 0.1, 2. / 3, 0.7),
                                                    pn::test::tube(2. / 3, 0.7, 1. / 7, 0.9)};
  const TopoDS_Shell shell = pn::make_shell(surfaces);
  const TopoDS_Shape back = from_brep(to_brep(shell));
  const auto found = pn::bspline_surfaces(back);
  REQUIRE(found.size() == 2);
  CHECK(pn::test::same_surface(found[0], surfaces[0]));
  CHECK(pn::test::same_surface(found[1], surfaces[1]));
  CHECK(vertices(back) == vertices(shell));
}

TEST_CASE("Writing what was read gives the same text") {
  const std::string text = to_brep(pn::make_capped_solid(pn::make_shell(pn::test::three_tubes())));
  CHECK(to_brep(from_brep(text)) == text);
}

TEST_CASE("Trimmed faces, poles and voids come back from BREP text") {
  const auto text_again = [](const TopoDS_Shape& shape) {
    const std::string text = to_brep(shape);
    CHECK(to_brep(from_brep(text)) == text);
  };
  const auto neighbours = pn::test::trimmed_neighbours();
  const TopoDS_Shell shell = pn::make_shell(neighbours);
  text_again(shell);
  const auto found = pn::bspline_surfaces(from_brep(to_brep(shell)));
  REQUIRE(found.size() == 2);
  for (int i = 0; i < 2; ++i) CHECK(pn::test::same_surface(found[i], neighbours[i]));
  text_again(pn::make_shell({pn::test::tube_with_hole_across_seam()}));
  text_again(pn::make_thick_solid(pn::make_shell(pn::test::ellipsoid_halves(3, 2, 1)),
                                  pn::make_shell(pn::test::ellipsoid_halves(4, 3, 2))));
}

TEST_CASE("Other text is refused") {
  CHECK_THROWS_AS(from_brep(""), std::invalid_argument);
  CHECK_THROWS_AS(from_brep("no shape"), std::invalid_argument);
}
