// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/round_trip.hpp"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <catch2/catch.hpp>
#include <cmath>

#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/caps.hpp"
#include "pn/occt/shell.hpp"
#include "trimmed_surfaces.hpp"

using pn::compare_round_trip;
using pn::make_shell;
using pn::RoundTrip;
using Differences = std::vector<std::string>;

namespace {

const pn::BSplineSurface kTorus = pn::test::torus(10 / 3., 1.);

RoundTrip of_surfaces(const pn::BSplineSurface& written, const pn::BSplineSurface& read) {
  return compare_round_trip({make_shell({written})}, {make_shell({read})});
}

Handle(Geom_BSplineSurface) surface_of(const TopoDS_Shape& shape) {
  const TopoDS_Face face = TopoDS::Face(TopExp_Explorer(shape, TopAbs_FACE).Current());
  return Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face));
}

TopoDS_Shape moved(const TopoDS_Shape& shape, double angle, const gp_Vec& way) {
  gp_Trsf rotation, translation;
  rotation.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2)), angle);
  translation.SetTranslation(way);
  return shape.Moved(TopLoc_Location(translation * rotation));
}

}  // namespace

TEST_CASE("What is the same has come back, and is counted") {
  const TopoDS_Shape solid = pn::make_capped_solid(make_shell(pn::test::three_tubes()));
  const TopoDS_Shape torus = make_shell({kTorus});
  const RoundTrip found = compare_round_trip({solid, torus}, {solid, torus});
  CHECK(found.differences == Differences());
  CHECK(found.faces == 6);
  CHECK(found.bspline_faces == 4);
  std::size_t poles = kTorus.poles.size();
  for (const auto& tube : pn::test::three_tubes()) poles += tube.poles.size();
  CHECK(found.poles == poles);
  const double torus_volume = 2 * pn::test::kPi * pn::test::kPi * 10 / 3.;
  CHECK(found.volume == Approx(pn::test::three_tubes_volume() + torus_volume).epsilon(1e-12));
}

TEST_CASE("A periodic surface is the closed one that it was made of") {
  const TopoDS_Shape periodic = make_shell({kTorus});
  surface_of(periodic)->SetUPeriodic();
  surface_of(periodic)->SetVPeriodic();
  CHECK(compare_round_trip({make_shell({kTorus})}, {periodic}).differences == Differences());
}

TEST_CASE("The last place of any number is seen") {
  const Differences other = {"Face 1 comes back with other poles, weights or knots."};
  const pn::BSplineSurface patch = pn::test::paraboloid();
  REQUIRE(of_surfaces(patch, patch).differences == Differences());
  for (int axis = 0; axis < 3; ++axis) {
    pn::BSplineSurface changed = patch;
    changed.poles[4][axis] = std::nextafter(changed.poles[4][axis], 100);
    CHECK(of_surfaces(patch, changed).differences == other);
  }
  pn::BSplineSurface weighted = patch;
  weighted.weights[4] = std::nextafter(1., 2.);
  CHECK(of_surfaces(patch, weighted).differences == other);
  pn::BSplineSurface tube = pn::test::tube(1, 0, 1, 5);
  pn::BSplineSurface knotted = tube;
  knotted.v_knots[1] = std::nextafter(knotted.v_knots[1], 0.);
  CHECK(of_surfaces(tube, knotted).differences == other);
}

TEST_CASE("A face that is cut elsewhere has another area") {
  const auto cut = [](double size) {
    return pn::test::within(pn::test::paraboloid(), {pn::test::oval({0.1, 0}, size, size)});
  };
  const RoundTrip found = of_surfaces(cut(0.5), cut(0.500001));
  REQUIRE(found.differences.size() == 1);
  CHECK(found.differences[0].find("Face 1 has the area 0.") == 0);
  // An edge within the confusion of where it was is the same edge.
  CHECK(of_surfaces(cut(0.5), cut(0.5 + Precision::Confusion() / 4)).differences == Differences());
}

TEST_CASE("A lost face and an opened shell are seen") {
  const auto halves = pn::test::sphere_halves();
  const TopoDS_Shape sphere = make_shell(halves);
  const Differences one_lost = {"2 faces were written, 1 come back."};
  CHECK(compare_round_trip({sphere}, {make_shell({halves[0]})}).differences == one_lost);
  BRep_Builder builder;
  TopoDS_Compound loose;
  builder.MakeCompound(loose);
  for (TopExp_Explorer face(sphere, TopAbs_FACE); face.More(); face.Next()) {
    builder.Add(loose, face.Current());
  }
  const Differences opened = compare_round_trip({sphere}, {loose}).differences;
  REQUIRE(opened.size() == 1);
  CHECK(opened[0].find("What was written has the volume 4.18879") == 0);
}

TEST_CASE("A placement may come back as one, but no other") {
  const TopoDS_Shape torus = make_shell({kTorus});
  const gp_Vec way(7. / 3, 100, -1e3);
  CHECK(compare_round_trip({moved(torus, 0.3, way)}, {moved(torus, 0.3, way)}).differences ==
        Differences());
  CHECK(
      compare_round_trip({moved(torus, 0.3, way)}, {moved(torus, 0.3 + 1e-16, way)}).differences ==
      Differences());
  const Differences other = {"Face 1 comes back with other poles, weights or knots."};
  CHECK(
      compare_round_trip({moved(torus, 0.3, way)}, {moved(torus, 0.3 + 1e-12, way)}).differences ==
      other);
  CHECK(compare_round_trip({moved(torus, 0.3, way)}, {torus}).differences == other);
}

TEST_CASE("An offset surface is a difference by itself") {
  const Handle(Geom_OffsetSurface) offset =
      new Geom_OffsetSurface(pn::to_geometry(pn::test::paraboloid()), 0.1);
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(offset, Precision::Confusion()).Shape();
  const Differences named = {"Face 1 is an offset surface, which other programs lose."};
  CHECK(compare_round_trip({face}, {face}).differences == named);
}
