// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/triangulation.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "pn/occt/brep.hpp"
#include "pn/occt/caps.hpp"
#include "pn/occt/mass.hpp"
#include "pn/occt/shell.hpp"
#include "trimmed_surfaces.hpp"

using pn::make_shell;
using pn::triangulated;

namespace {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    faces.push_back(TopoDS::Face(face.Current()));
  }
  return faces;
}

Handle(Poly_Triangulation) triangulation_of(const TopoDS_Face& face) {
  TopLoc_Location location;
  return BRep_Tool::Triangulation(face, location);
}

// Area, and volume of the cones from the origin, of the triangles as the faces are turned.
struct Measures {
  double area = 0;
  double volume = 0;
};
Measures measures_of_triangles(const TopoDS_Shape& shape) {
  Measures sum;
  for (const TopoDS_Face& face : faces_of(shape)) {
    const auto triangles = triangulation_of(face);
    REQUIRE(!triangles.IsNull());
    const double sign = face.Orientation() == TopAbs_REVERSED ? -1 : 1;
    for (int k = 1; k <= triangles->NbTriangles(); ++k) {
      int a, b, c;
      triangles->Triangle(k).Get(a, b, c);
      const gp_XYZ p = triangles->Node(a).XYZ(), q = triangles->Node(b).XYZ(),
                   r = triangles->Node(c).XYZ();
      const gp_XYZ normal = (q - p).Crossed(r - p);
      sum.area += normal.Modulus() / 2;
      sum.volume += sign * p.Dot(normal) / 6;
    }
  }
  return sum;
}

// The largest distance of the nodes of an edge, on the triangulations of its faces, from the edge.
double distance_from_edge(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) {
  const BRepAdaptor_Curve curve(edge);
  double distance = 0;
  for (const TopoDS_Shape& face : faces) {
    TopLoc_Location location;
    const auto triangles = BRep_Tool::Triangulation(TopoDS::Face(face), location);
    for (const auto orientation : {TopAbs_FORWARD, TopAbs_REVERSED}) {
      const auto oriented = TopoDS::Edge(edge.Oriented(orientation));
      const auto polygon = BRep_Tool::PolygonOnTriangulation(oriented, triangles, location);
      REQUIRE(!polygon.IsNull());
      for (int i = 1; i <= polygon->NbNodes(); ++i) {
        const gp_Pnt node = triangles->Node(polygon->Node(i));
        distance = std::max(distance, node.Distance(curve.Value(polygon->Parameter(i))));
      }
    }
  }
  return distance;
}

double largest_distance_from_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_at;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_at);
  double distance = 0;
  for (int i = 1; i <= faces_at.Extent(); ++i) {
    const auto edge = TopoDS::Edge(faces_at.FindKey(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    distance = std::max(distance, distance_from_edge(edge, faces_at(i)));
  }
  return distance;
}

// What OpenCASCADE makes of a shape that is to be drawn this coarsely.
constexpr double kCoarse = 10;

}  // namespace

TEST_CASE("The triangles of closed shells enclose their volume, turned outwards") {
  for (const auto& faces : {std::vector{pn::test::torus(5, 2)}, pn::test::sphere_halves()}) {
    const TopoDS_Shape shell = triangulated(make_shell(faces));
    const auto [area, volume] = measures_of_triangles(shell);
    // A half circle in one span is divided by 20 degrees: its polygon lacks 2 % of its area.
    CHECK(area == Approx(pn::area(shell)).epsilon(0.05));
    CHECK(volume == Approx(pn::volume(shell)).epsilon(0.05));
  }
}

TEST_CASE("The nodes along an edge are the same points on all its faces") {
  CHECK(largest_distance_from_edges(triangulated(make_shell(pn::test::three_tubes()))) < 1e-12);
  CHECK(largest_distance_from_edges(triangulated(make_shell(pn::test::sphere_halves()))) < 1e-12);
  CHECK(largest_distance_from_edges(triangulated(make_shell({pn::test::torus(5, 2)}))) < 1e-12);
}

TEST_CASE("OpenCASCADE keeps the triangulation, also through BREP text, and fills the caps") {
  const TopoDS_Solid solid = pn::make_capped_solid(make_shell(pn::test::three_tubes()));
  const TopoDS_Shape shape = pn::from_brep(pn::to_brep(triangulated(solid)));
  std::vector<Handle(Poly_Triangulation)> made;
  for (const TopoDS_Face& face : faces_of(shape)) made.push_back(triangulation_of(face));
  const BRepMesh_IncrementalMesh mesh(shape, kCoarse);
  std::size_t kept = 0;
  for (const TopoDS_Face& face : faces_of(shape)) {
    const auto found = std::find(made.begin(), made.end(), triangulation_of(face));
    kept += found != made.end() ? 1 : 0;
  }
  CHECK(kept == 3);
  CHECK(measures_of_triangles(shape).volume == Approx(pn::volume(shape)).epsilon(0.02));
}

TEST_CASE("OpenCASCADE divides again what is to be drawn more finely") {
  const TopoDS_Shape shell = triangulated(make_shell({pn::test::torus(5, 2)}));
  const int nodes = triangulation_of(faces_of(shell).front())->NbNodes();
  const BRepMesh_IncrementalMesh mesh(shell, 1e-3);
  CHECK(triangulation_of(faces_of(shell).front())->NbNodes() > nodes);
}

TEST_CASE("Faces within trims are left to OpenCASCADE") {
  const TopoDS_Shape shell = triangulated(make_shell({pn::test::wavy_tube()}));
  CHECK(triangulation_of(faces_of(shell).front()).IsNull());
}
