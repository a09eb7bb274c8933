// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/shell.hpp"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <catch2/catch.hpp>

#include "pn/occt/mass.hpp"
#include "pn/occt/shape_check.hpp"
#include "surfaces_of_revolution.hpp"

using pn::make_shell;
using pn::test::circle_arcs;
using pn::test::kPi;
using pn::test::line;
using pn::test::revolve;

namespace {

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

// Faces, edges (degenerate ones too) and vertices.
std::array<int, 3> counts(const TopoDS_Shape& shape) {
  return {count(shape, TopAbs_FACE), count(shape, TopAbs_EDGE), count(shape, TopAbs_VERTEX)};
}

void check_clean(const TopoDS_Shape& shape) {
  CHECK(pn::faults(shape) == std::vector<std::string>());
  CHECK(pn::boolean_faults(shape) == std::vector<std::string>());
}

// Greatest distance between an edge's curve and its p-curves on their surfaces, at equal
// parameters.
double greatest_gap(const TopoDS_Shape& shape) {
  double gap = 0;
  for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next()) {
    const TopoDS_Face face = TopoDS::Face(f.Current());
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(e.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      double first, last;
      const auto curve = BRep_Tool::Curve(edge, first, last);
      const auto p_curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
      for (int i = 0; i <= 40; ++i) {
        const double t = first + i * (last - first) / 40;
        const gp_Pnt2d uv = p_curve->Value(t);
        const gp_Pnt on_surface = BRep_Tool::Surface(face)->Value(uv.X(), uv.Y());
        gap = std::max(gap, on_surface.Distance(curve->Value(t)));
      }
    }
  }
  return gap;
}

std::vector<pn::BSplineSurface> grid_of_patches(int pieces) {
  std::vector<pn::BSplineSurface> patches;
  for (int i = 0; i < pieces; ++i) {
    for (int arc = 0; arc < 4; ++arc) {
      patches.push_back(revolve(line({2., 1. * i}, {2., 1. * i + 1}), circle_arcs(arc, arc + 1)));
    }
  }
  return patches;
}

}  // namespace

TEST_CASE("One tube: a seam and two circles") {
  const TopoDS_Shell shell = make_shell({pn::test::tube(2, 0, 2, 5)});
  CHECK(counts(shell) == std::array{1, 3, 2});
  CHECK_FALSE(shell.Closed());
  CHECK(greatest_gap(shell) < 1e-14);
  check_clean(shell);
}

TEST_CASE("A torus has two seams and one vertex, and is closed") {
  const TopoDS_Shell shell = make_shell({pn::test::torus(5, 2)});
  CHECK(counts(shell) == std::array{1, 2, 1});
  CHECK(shell.Closed());
  CHECK(greatest_gap(shell) < 1e-14);
  check_clean(shell);
}

TEST_CASE("A torus of nine by nine poles, only C0, is valid too") {
  const auto circle = pn::test::quadratic_circle();
  const TopoDS_Shell shell = make_shell({revolve(pn::test::scaled(circle, 2, 5), circle)});
  CHECK(counts(shell) == std::array{1, 2, 1});
  CHECK(shell.Closed());
  CHECK(pn::faults(shell).empty());
}

TEST_CASE("A closed chain of four quarter tubes closes") {
  const auto profile = pn::test::scaled(pn::test::circle(), 2, 5);
  std::vector<pn::BSplineSurface> quarters;
  for (int arc = 0; arc < 4; ++arc) {
    quarters.push_back(revolve(profile, circle_arcs(arc, arc + 1)));
  }
  const TopoDS_Shell shell = make_shell(quarters);
  CHECK(counts(shell) == std::array{4, 8, 4});
  CHECK(shell.Closed());
  check_clean(shell);
}

TEST_CASE("A sphere of two halves: two meridians, four degenerate edges, two poles") {
  const TopoDS_Shell shell = make_shell(pn::test::sphere_halves());
  CHECK(counts(shell) == std::array{2, 6, 2});
  CHECK(shell.Closed());
  CHECK(greatest_gap(shell) < 1e-14);
  check_clean(shell);
}

TEST_CASE("A chain of tubes shares its inner circles") {
  const TopoDS_Shell shell = make_shell(pn::test::three_tubes());
  CHECK(counts(shell) == std::array{3, 7, 4});
  CHECK_FALSE(shell.Closed());
  check_clean(shell);
}

TEST_CASE("A grid of patches shares edges in both directions") {
  const TopoDS_Shell shell = make_shell(grid_of_patches(3));
  CHECK(counts(shell) == std::array{12, 12 + 16, 16});
  check_clean(shell);
  CHECK(pn::area(shell) == Approx(12 * kPi).epsilon(1e-12));
}

TEST_CASE("Neighbours may run their common edge at different speeds") {
  auto tubes = pn::test::three_tubes();
  for (double& knot : tubes[1].v_knots) knot = 3.3 + 7 * knot;
  const TopoDS_Shell shell = make_shell(tubes);
  CHECK(counts(shell) == std::array{3, 7, 4});
  CHECK(greatest_gap(shell) < 1e-13);
  check_clean(shell);
}

TEST_CASE("Neighbours may run their common edge in opposite directions") {
  auto tubes = pn::test::three_tubes();
  tubes[1] = pn::test::turned_round(tubes[1]);
  const TopoDS_Shell shell = make_shell(tubes);
  CHECK(counts(shell) == std::array{3, 7, 4});
  CHECK(greatest_gap(shell) < 1e-14);
  check_clean(shell);
  std::vector<TopAbs_Orientation> orientations;
  for (TopExp_Explorer face(shell, TopAbs_FACE); face.More(); face.Next()) {
    orientations.push_back(face.Current().Orientation());
  }
  CHECK(orientations == std::vector{TopAbs_FORWARD, TopAbs_REVERSED, TopAbs_FORWARD});
}

TEST_CASE("Edges are as smooth as the surface is") {
  const TopoDS_Shell shell = make_shell(
      {pn::test::tube(2, 0, 2, 5), pn::test::tube(2, 5, 2, 7), pn::test::tube(2, 7, 3, 8)});
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
  TopExp::MapShapesAndAncestors(shell, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
  int corners = 0;
  int smooth_joints = 0;
  int seams = 0;
  for (int i = 1; i <= faces_of_edge.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(faces_of_edge.FindKey(i));
    const auto& faces = faces_of_edge(i);
    if (faces.Extent() < 2) continue;
    const TopoDS_Face one = TopoDS::Face(faces.First());
    const TopoDS_Face other = TopoDS::Face(faces.Last());
    const bool smooth = BRep_Tool::Continuity(edge, one, other) > GeomAbs_C0;
    if (one.IsSame(other)) {
      ++seams;
      CHECK(smooth);
    } else {
      ++(smooth ? smooth_joints : corners);
    }
  }
  CHECK(seams == 3);
  CHECK(smooth_joints == 1);
  CHECK(corners == 1);
}

TEST_CASE("Wires are marked closed") {
  const TopoDS_Shell shell = make_shell(pn::test::three_tubes());
  for (TopExp_Explorer wire(shell, TopAbs_WIRE); wire.More(); wire.Next()) {
    CHECK(wire.Current().Closed());
  }
}

TEST_CASE("What is no shell is refused") {
  using pn::test::tube;
  CHECK_THROWS_WITH(make_shell({}), Catch::Contains("at least one"));
  CHECK_THROWS_WITH(make_shell({tube(2, 0, 2, 1), tube(2, 3, 2, 5)}),
                    Catch::Contains("do not hang together"));
  CHECK_THROWS_WITH(make_shell({tube(2, 0, 2, 1), tube(2, 1, 2, 2), tube(2, 1, 3, 2)}),
                    Catch::Contains("More than two"));
  const pn::BSplineSurface half_twist = {
      2,
      1,
      {0, 1},
      {0, 1},
      {3, 3},
      {2, 2},
      {{0, 0, 0}, {0, 0, 1}, {5, 5, 0}, {6, 6, 1}, {0, 0, 1}, {0, 0, 0}},
      {1, 1, 1, 1, 1, 1}};
  CHECK_THROWS_WITH(make_shell({half_twist}), Catch::Contains("one-sided"));
  auto without_a_pole = tube(2, 0, 2, 1);
  without_a_pole.poles.pop_back();
  CHECK_THROWS_AS(make_shell({without_a_pole}), std::invalid_argument);
}
