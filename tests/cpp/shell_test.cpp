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
#include <TopoDS_Vertex.hxx>
#include <array>
#include <catch2/catch.hpp>

#include "pn/occt/mass.hpp"
#include "pn/occt/shape_check.hpp"
#include "surfaces_of_revolution.hpp"
#include "trimmed_surfaces.hpp"

using pn::make_shell;
using pn::test::circle_arcs;
using pn::test::kPi;
using pn::test::line;
using pn::test::oval;
using pn::test::paraboloid;
using pn::test::polygon;
using pn::test::revolve;
using pn::test::within;

// What the fit of an edge along a trim may be off.
constexpr double kFitError = 1e-9;

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

std::vector<TopAbs_Orientation> orientations_of_faces(const TopoDS_Shape& shape) {
  std::vector<TopAbs_Orientation> orientations;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    orientations.push_back(face.Current().Orientation());
  }
  return orientations;
}

void check_clean(const TopoDS_Shape& shape) {
  CHECK(pn::faults(shape) == std::vector<std::string>());
  CHECK(pn::boolean_faults(shape) == std::vector<std::string>());
}

// Greatest distance between an edge's curve and its p-curves on their surfaces, at equal
// parameters, and between its ends and its vertices.
double greatest_gap(const TopoDS_Shape& shape) {
  double gap = 0;
  for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next()) {
    const TopoDS_Face face = TopoDS::Face(f.Current());
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(e.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      double first, last;
      const auto curve = BRep_Tool::Curve(edge, first, last);
      const auto end_gap = [&](const TopoDS_Vertex& vertex, double t) {
        return BRep_Tool::Pnt(vertex).Distance(curve->Value(t));
      };
      gap = std::max({gap, end_gap(TopExp::FirstVertex(edge), first),
                      end_gap(TopExp::LastVertex(edge), last)});
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
  CHECK(orientations_of_faces(shell) ==
        std::vector{TopAbs_FORWARD, TopAbs_REVERSED, TopAbs_FORWARD});
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

TEST_CASE("A face within a loop of trims") {
  const TopoDS_Shell shell = make_shell({within(paraboloid(), {oval({0.1, 0}, 0.8, 0.6)})});
  CHECK(counts(shell) == std::array{1, 4, 4});
  CHECK_FALSE(shell.Closed());
  CHECK(greatest_gap(shell) < kFitError);
  check_clean(shell);
}

TEST_CASE("A face with holes has a wire for each") {
  const TopoDS_Shell shell = make_shell(
      {within(paraboloid(), {polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}),
                             pn::test::reversed(oval({0.4, 0}, 0.3, 0.5)),
                             pn::test::reversed(polygon({{-0.5, 0}, {-0.2, 0}, {-0.3, 0.4}}))})});
  CHECK(counts(shell) == std::array{1, 11, 11});
  CHECK(count(shell, TopAbs_WIRE) == 3);
  CHECK(greatest_gap(shell) < kFitError);
  check_clean(shell);
}

TEST_CASE("A trim that closes in itself is one edge with one vertex") {
  const pn::ParameterCurve drop = {
      3,
      {0, 1, 2, 3},
      {4, 1, 1, 4},
      {{-0.5, 0}, {0, -0.4}, {0.6, -0.5}, {0.6, 0.5}, {0, 0.4}, {-0.5, 0}}};
  const TopoDS_Shell shell = make_shell({within(paraboloid(), {{drop}})});
  CHECK(counts(shell) == std::array{1, 1, 1});
  check_clean(shell);
}

TEST_CASE("A trim with corners has an edge for each smooth piece") {
  pn::ParameterCurve triangle{1, {0, 1, 2, 3}, {2, 1, 1, 2}, {}};
  triangle.poles = {{-0.5, -0.5}, {0.5, -0.4}, {0, 0.6}, {-0.5, -0.5}};
  const TopoDS_Shell shell = make_shell({within(paraboloid(), {{triangle}})});
  CHECK(counts(shell) == std::array{1, 3, 3});
  check_clean(shell);
}

TEST_CASE("Trims along the four sides, from any corner on, are no trims") {
  std::vector<std::array<double, 2>> corners = {{0, 0}, {1, 0}, {1, 4}, {0, 4}};
  for (int turn = 0; turn < 4; ++turn) {
    const TopoDS_Shell shell = make_shell({within(pn::test::tube(2, 0, 2, 5), {polygon(corners)})});
    CHECK(counts(shell) == std::array{1, 3, 2});
    CHECK(greatest_gap(shell) < 1e-14);
    check_clean(shell);
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
}

TEST_CASE("A trimmed tube keeps what is left of its seam") {
  SECTION("cut off") {
    const TopoDS_Shell shell = make_shell({pn::test::wavy_tube()});
    CHECK(counts(shell) == std::array{1, 3, 2});
    CHECK(greatest_gap(shell) < kFitError);
    check_clean(shell);
  }
  SECTION("with a hole across the seam") {
    const TopoDS_Shell shell = make_shell({pn::test::tube_with_hole_across_seam()});
    CHECK(counts(shell) == std::array{1, 6, 4});
    CHECK(greatest_gap(shell) < kFitError);
    check_clean(shell);
  }
}

TEST_CASE("Trimmed neighbours share a piece of a side and its ends") {
  const TopoDS_Shell shell = make_shell(pn::test::trimmed_neighbours());
  CHECK(counts(shell) == std::array{2, 7, 6});
  CHECK(greatest_gap(shell) < kFitError);
  check_clean(shell);
}

TEST_CASE("Pieces with other ends are other edges") {
  auto neighbours = pn::test::trimmed_neighbours();
  auto& loop = neighbours[0].trims[0];
  loop[0].poles[0][1] = loop[3].poles[1][1] = 0.5 + 1e-9;
  CHECK_THROWS_WITH(make_shell(neighbours), Catch::Contains("do not hang together"));
}

TEST_CASE("Trimmed and whole faces join") {
  auto upper = pn::test::turned_round(pn::test::tube(2, 5, 3, 7));
  // Everything below u = 1/2.
  upper.trims = {polygon({{0, 0}, {0.5, 0}, {0.5, 4}, {0, 4}})};
  const TopoDS_Shell shell = make_shell({pn::test::tube(2, 0, 2, 5), upper});
  CHECK(counts(shell) == std::array{2, 5, 3});
  check_clean(shell);
}

TEST_CASE("Faces around a point in the middle of a side share it in spite of rounding") {
  using pn::test::straight;
  // The end circle of one tube is cut where two pieces of the next tube, which run it differently,
  // meet.
  const double cut = 1. / 3;
  const auto below =
      within(pn::test::tube(2, 0, 2, 5),
             {{straight({0, 0}, {1, 0}), straight({1, 0}, {1, cut}), straight({1, cut}, {1, 4}),
               straight({1, 4}, {0, 4}), straight({0, 4}, {0, 0})}});
  const auto upper = pn::test::tube(2, 5, 3, 7);
  const auto left = within(upper, {polygon({{0, 0}, {1, 0}, {1, cut}, {0, cut}})});
  auto right = upper;
  const auto at = [](double v) { return 100.1 + v / 7; };
  for (double& knot : right.v_knots) knot = at(knot);
  right.trims = {polygon({{0, at(cut)}, {1, at(cut)}, {1, at(4)}, {0, at(4)}})};
  const TopoDS_Shell shell = make_shell({left, right, below});
  CHECK(greatest_gap(shell) < kFitError);
  CHECK(pn::faults(shell).empty());
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(shell, TopAbs_VERTEX, vertices);
  int on_the_circle = 0;
  for (int i = 1; i <= vertices.Extent(); ++i) {
    const double z = BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))).Z();
    if (std::abs(z - 5) < 1e-9) ++on_the_circle;
  }
  CHECK(on_the_circle == 2);
}

TEST_CASE("A trimmed half of a sphere may keep its pole") {
  const TopoDS_Shell shell = make_shell(pn::test::up_to(pn::test::sphere_halves(), 0.7));
  CHECK(counts(shell) == std::array{2, 6, 3});
  CHECK_FALSE(shell.Closed());
  CHECK(greatest_gap(shell) < kFitError);
  check_clean(shell);
}

TEST_CASE("A piece of a pole is a degenerate edge") {
  // A triangle in parameters: a sector around the pole with a wavy end.
  const TopoDS_Shell shell = make_shell(
      {within(pn::test::sphere_halves()[0],
              {{pn::test::straight({0, 1.5}, {0, 0.5}), pn::test::straight({0, 0.5}, {0.4, 0.5}),
                pn::test::bezier({{0.4, 0.5}, {0.7, 0.8}, {0.5, 1.5}}),
                pn::test::straight({0.5, 1.5}, {0, 1.5})}})});
  CHECK(counts(shell) == std::array{1, 4, 3});
  CHECK(greatest_gap(shell) < kFitError);
  check_clean(shell);
}

TEST_CASE("A closed ellipsoid of two halves") {
  const TopoDS_Shell shell = make_shell(pn::test::ellipsoid_halves(3, 2, 1));
  CHECK(counts(shell) == std::array{2, 6, 2});
  CHECK(shell.Closed());
  CHECK(greatest_gap(shell) < 1e-14);
  check_clean(shell);
}

TEST_CASE("Surfaces of several parts have a shell for each, in their order") {
  using pn::test::tube;
  const auto halves = pn::test::sphere_halves();
  // The second and the last tube hang together, as do the two halves of the sphere.
  const auto shells = pn::make_shells(
      {halves[0], tube(3, 10, 3, 12), tube(3, 20, 3, 21), halves[1], tube(3, 12, 2, 14)});
  REQUIRE(shells.size() == 3);
  CHECK(counts(shells[0]) == std::array{2, 6, 2});
  CHECK(shells[0].Closed());
  CHECK(counts(shells[1]) == std::array{2, 5, 3});
  CHECK_FALSE(shells[1].Closed());
  CHECK(counts(shells[2]) == std::array{1, 3, 2});
  for (const TopoDS_Shell& shell : shells) check_clean(shell);
  CHECK(pn::area(shells[2]) == Approx(6 * kPi).epsilon(1e-12));
}

TEST_CASE("Each part has its own orientation") {
  using pn::test::tube;
  using pn::test::turned_round;
  const auto shells = pn::make_shells({tube(2, 0, 2, 1), turned_round(tube(2, 5, 2, 6)),
                                       turned_round(tube(2, 1, 2, 2)), tube(2, 6, 2, 7)});
  REQUIRE(shells.size() == 2);
  for (const TopoDS_Shell& shell : shells) {
    CHECK(orientations_of_faces(shell) == std::vector{TopAbs_FORWARD, TopAbs_REVERSED});
  }
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
      {1, 1, 1, 1, 1, 1},
      {}};
  CHECK_THROWS_WITH(make_shell({half_twist}), Catch::Contains("one-sided"));
  auto without_a_pole = tube(2, 0, 2, 1);
  without_a_pole.poles.pop_back();
  CHECK_THROWS_AS(make_shell({without_a_pole}), std::invalid_argument);
}
