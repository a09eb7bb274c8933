// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/spherical_caps.hpp"

#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <catch2/catch.hpp>
#include <cmath>

#include "pn/occt/curve_on_surface.hpp"
#include "pn/occt/mass.hpp"
#include "pn/occt/shape_check.hpp"
#include "pn/occt/shell.hpp"
#include "trimmed_surfaces.hpp"

using pn::make_domed_solid;
using pn::make_shell;
using pn::volume;
using pn::test::kPi;

namespace {

TopoDS_Solid domed(const std::vector<pn::BSplineSurface>& surfaces) {
  return make_domed_solid(make_shell(surfaces));
}

void check_clean(const TopoDS_Shape& shape) {
  CHECK(pn::faults(shape) == std::vector<std::string>());
  CHECK(pn::boolean_faults(shape) == std::vector<std::string>());
  CHECK(pn::trim_deviation(shape) < 1e-13);
}

double segment_volume(double radius, double height) {
  return kPi * height * height * (3 * radius - height) / 3;
}

// The envelope of the spheres of radius r0 at the origin to r1 at the height `length`.
struct ConeOfSpheres {
  double r0, r1, length;

  double sine() const { return (r1 - r0) / length; }
  double cosine() const { return std::sqrt(1 - sine() * sine()); }
  pn::BSplineSurface side() const {
    return pn::test::tube(r0 * cosine(), -r0 * sine(), r1 * cosine(), length - r1 * sine());
  }
  // Of the convex hull of the two balls.
  double volume() const {
    const double a = r0 * cosine();
    const double b = r1 * cosine();
    const double height = length - (r1 - r0) * sine();
    return kPi * height * (a * a + a * b + b * b) / 3 + segment_volume(r0, r0 - r0 * sine()) +
           segment_volume(r1, r1 + r1 * sine());
  }
};

}  // namespace

TEST_CASE("A domed cylinder is a capsule") {
  const TopoDS_Solid solid = domed({pn::test::tube(2, 0, 2, 5)});
  check_clean(solid);
  CHECK(volume(solid) == Approx(20 * kPi + 32 * kPi / 3).epsilon(1e-13));
  CHECK(pn::area(solid) == Approx(20 * kPi + 16 * kPi).epsilon(1e-13));
}

TEST_CASE("A domed cone is the hull of its end spheres, from steep to nearly flat") {
  for (const auto& cone : {ConeOfSpheres{2, 3, 10}, {3, 2, 10}, {1, 8, 10}, {0.5, 9.9, 10}}) {
    CAPTURE(cone.r0, cone.r1);
    const TopoDS_Solid solid = domed({cone.side()});
    check_clean(solid);
    CHECK(volume(solid) == Approx(cone.volume()).epsilon(1e-12));
  }
}

TEST_CASE("Domes are smooth with the tube and use its edges") {
  const TopoDS_Solid solid = domed({pn::test::tube(2, 0, 2, 5)});
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  CHECK(faces_of_edge.Extent() == 3);
  int smooth = 0;
  for (int i = 1; i <= faces_of_edge.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(faces_of_edge.FindKey(i));
    const TopoDS_Face& first = TopoDS::Face(faces_of_edge(i).First());
    const TopoDS_Face& last = TopoDS::Face(faces_of_edge(i).Last());
    CHECK(faces_of_edge(i).Extent() == 2);
    CHECK(BRep_Tool::Tolerance(edge) == 1e-7);
    if (!first.IsSame(last) && BRep_Tool::Continuity(edge, first, last) >= GeomAbs_G1) ++smooth;
  }
  CHECK(smooth == 2);
}

TEST_CASE("A dome lies on its sphere, without pole and seam") {
  const ConeOfSpheres cone{1, 8, 10};
  const TopoDS_Solid solid = domed({cone.side()});
  int domes = 0;
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
    const auto surface =
        Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(face.Current())));
    if (surface->UDegree() != 2 || surface->VDegree() != 2) continue;
    ++domes;
    CHECK_FALSE(surface->IsUClosed());
    CHECK_FALSE(surface->IsVClosed());
    const bool at_start = surface->Value(0, 0).Z() < 0;
    const gp_Pnt centre(0, 0, at_start ? 0 : cone.length);
    for (double x = -1.25; x <= 1.25; x += 0.3125) {
      for (double y = -1.25; y <= 1.25; y += 0.3125) {
        CHECK(surface->Value(x, y).Distance(centre) ==
              Approx(at_start ? cone.r0 : cone.r1).epsilon(1e-13));
      }
    }
  }
  CHECK(domes == 2);
}

TEST_CASE("A dome may have several edges") {
  std::vector<pn::BSplineSurface> quarters;
  for (int arc = 0; arc < 4; ++arc) {
    quarters.push_back(
        pn::test::revolve(pn::test::line({2, 0}, {2, 5}), pn::test::circle_arcs(arc, arc + 1)));
  }
  const TopoDS_Solid solid = domed(quarters);
  check_clean(solid);
  CHECK(volume(solid) == Approx(20 * kPi + 32 * kPi / 3).epsilon(1e-13));
}

TEST_CASE("Faces that point inwards are domed outwards all the same") {
  const TopoDS_Solid solid = domed({pn::test::turned_round(pn::test::tube(2, 0, 2, 5))});
  check_clean(solid);
  CHECK(volume(solid) == Approx(20 * kPi + 32 * kPi / 3).epsilon(1e-13));
}

TEST_CASE("A ball that was cut is whole again") {
  const TopoDS_Solid solid = domed(pn::test::up_to(pn::test::sphere_halves(), 0.7));
  CHECK(pn::faults(solid).empty());
  CHECK(pn::boolean_faults(solid).empty());
  CHECK(volume(solid) == Approx(4 * kPi / 3).epsilon(1e-9));
}

TEST_CASE("The shell that is domed stays as it is") {
  const TopoDS_Shell shell = make_shell({pn::test::tube(2, 0, 2, 5)});
  const auto curves = [&shell] {
    int count = 0;
    for (TopExp_Explorer edge(shell, TopAbs_EDGE); edge.More(); edge.Next()) {
      const auto representations =
          Handle(BRep_TEdge)::DownCast(edge.Current().TShape())->Curves().Size();
      count += representations;
    }
    return count;
  };
  const int before = curves();
  make_domed_solid(shell);
  CHECK_FALSE(BRep_Tool::IsClosed(shell));
  CHECK(curves() == before);
}

TEST_CASE("A closed shell needs no dome") {
  CHECK(volume(domed({pn::test::torus(5, 2)})) == Approx(2 * kPi * kPi * 5 * 4).epsilon(1e-12));
}

TEST_CASE("Ends that no sphere touches are refused") {
  SECTION("an ellipsoid cut off") {
    CHECK_THROWS_WITH(domed(pn::test::up_to(pn::test::ellipsoid_halves(3, 2, 1), 0.7)),
                      Catch::Contains("No sphere touches"));
  }
  SECTION("a flat ring") {
    CHECK_THROWS_WITH(domed({pn::test::tube(2, 0, 3, 0)}), Catch::Contains("No sphere touches"));
  }
}
