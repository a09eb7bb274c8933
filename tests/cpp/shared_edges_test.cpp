// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/shared_edges.hpp"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>
#include <catch2/catch.hpp>

#include "pn/occt/bspline_geometry.hpp"
#include "trimmed_surfaces.hpp"

using pn::SharedEdges;
using pn::SharedVertices;

namespace {

pn::FaceBoundary add(SharedEdges& edges, const pn::BSplineSurface& surface) {
  return edges.add(surface, pn::trim_images(surface, {pn::to_geometry(surface)}).front());
}

}  // namespace

TEST_CASE("Equal points are one vertex, points an ulp apart are two until they are united") {
  SharedVertices vertices;
  const std::size_t a = vertices.at({1, 2, 3});
  const std::size_t b = vertices.at({1, 2, std::nextafter(3, 4)});
  const std::size_t c = vertices.at({4, 5, 6});
  CHECK(vertices.at({1, 2, 3}) == a);
  CHECK(vertices.root(a) != vertices.root(b));
  vertices.unite(b, c);
  vertices.unite(a, b);
  CHECK(vertices.root(c) == vertices.root(a));
  CHECK(vertices.point(c) == std::array<double, 3>{1, 2, 3});
  vertices.unite(c, a);
  CHECK(vertices.root(b) == a);
}

TEST_CASE("Runs of a face along one edge, and of two faces") {
  SharedEdges edges;
  const auto tubes = pn::test::three_tubes();
  const auto first = add(edges, tubes[0]).at(0);
  const auto second = add(edges, tubes[1]).at(0);
  CHECK(first[0].edge == first[2].edge);
  CHECK(first[0].orientation != first[2].orientation);
  CHECK(first[1].edge == second[3].edge);
  CHECK(first[1].orientation != second[3].orientation);
  CHECK(edges.topology().size() == 5);
}

TEST_CASE("Runs follow each other in the parameter plane, loop by loop") {
  const auto disc = pn::test::within(
      pn::test::wavy_tube(),
      {pn::test::wavy_tube().trims[0], pn::test::reversed(pn::test::oval({0.2, 1}, 0.1, 0.2))});
  SharedEdges edges;
  const auto loops = add(edges, disc);
  REQUIRE(loops.size() == 2);
  for (const auto& loop : loops) {
    REQUIRE(loop.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& [edge, orientation, p_curve, first, last] = loop[i];
      const auto& next = loop[(i + 1) % 4];
      const gp_Pnt2d end = p_curve->Value(orientation == TopAbs_FORWARD ? last : first);
      const gp_Pnt2d start =
          next.p_curve->Value(next.orientation == TopAbs_FORWARD ? next.first : next.last);
      CHECK(end.Distance(start) < 1e-15);
    }
  }
}

TEST_CASE("A trim that ends on a side ends at the vertex of the side") {
  SharedEdges edges;
  const auto runs = add(edges, pn::test::wavy_tube()).at(0);
  const auto topology = edges.topology();
  const TopoDS_Edge& seam = topology[runs[0].edge];
  const TopoDS_Edge& trim = topology[runs[1].edge];
  CHECK(TopExp::LastVertex(seam).IsSame(TopExp::FirstVertex(trim)));
  CHECK(TopExp::LastVertex(seam).IsSame(TopExp::LastVertex(trim)));
  const gp_Pnt end = BRep_Tool::Pnt(TopExp::LastVertex(trim));
  // Half way up the tube's seam.
  CHECK(end.Distance(gp_Pnt(0.5 * (pn::test::tube(2, 0, 2, 5).poles.front()[0] +
                                   pn::test::tube(2, 0, 2, 5).poles[14][0]),
                            pn::test::tube(2, 0, 2, 5).poles.front()[1], 2.5)) < 1e-14);
}

TEST_CASE("Vertices at the corners of surfaces are their poles, bit for bit") {
  for (int i = 1; i < 40; ++i) {
    const auto tube = pn::test::tube(i / 7., i / 11., i / 13., i);
    SharedEdges edges;
    const auto runs = add(edges, tube).at(0);
    const TopoDS_Edge seam = edges.topology()[runs[0].edge];
    const gp_Pnt first = BRep_Tool::Pnt(TopExp::FirstVertex(seam));
    const gp_Pnt last = BRep_Tool::Pnt(TopExp::LastVertex(seam));
    CHECK(std::array{first.X(), first.Y(), first.Z()} == tube.poles.front());
    CHECK(std::array{last.X(), last.Y(), last.Z()} == tube.poles.back());
  }
}

TEST_CASE("Trims that differ by more than the tolerance are edges of their own") {
  const auto patch = [](double a) {
    return pn::test::within(pn::test::paraboloid(), {pn::test::oval({0, 0}, a, a)});
  };
  SharedEdges edges;
  add(edges, patch(0.5));
  add(edges, patch(0.5 + 1e-6));
  CHECK(edges.topology().size() == 8);
  add(edges, patch(0.5));
  CHECK(edges.topology().size() == 8);
}

TEST_CASE("The images of a trim on two surfaces have the same knots") {
  const auto wave = pn::test::wavy_tube();
  const auto images =
      pn::trim_images(wave, {pn::to_geometry(wave), pn::to_geometry(pn::test::tube(3, 1, 4, 7))});
  REQUIRE(images.size() == 2);
  REQUIRE(images[0].size() == 1);
  const auto& [near, far] = std::pair(images[0][0], images[1][0]);
  CHECK(near->NbKnots() == far->NbKnots());
  CHECK(near->NbPoles() == far->NbPoles());
  for (int k = 1; k <= near->NbKnots(); ++k) CHECK(near->Knot(k) == far->Knot(k));
}

TEST_CASE("A further face finds an edge by its side, from vertex to vertex") {
  SharedEdges edges;
  const auto runs = add(edges, pn::test::wavy_tube()).at(0);
  // A piece of the seam, a trim, a whole rim.
  for (const int i : {0, 1, 3}) {
    const pn::BoundaryCurve side = edges.side_along(runs[i].edge);
    pn::BSplineSurface wall{side.degree, 1,  side.knots, {0, 1}, side.multiplicities,
                            {2, 2},      {}, {},         {}};
    for (std::size_t k = 0; k < side.poles.size(); ++k) {
      const auto& [x, y, z] = side.poles[k];
      wall.poles.insert(wall.poles.end(), {{x, y, z}, {2 * x, 2 * y, z}});
      wall.weights.insert(wall.weights.end(), 2, side.weights[k]);
    }
    const std::size_t known = edges.size();
    CHECK(add(edges, wall).at(0)[0].edge == runs[i].edge);
    CHECK(edges.size() > known);
  }
}

TEST_CASE("A side that is a point is degenerate") {
  SharedEdges edges;
  const auto runs = add(edges, pn::test::sphere_halves()[0]).at(0);
  int points = 0;
  for (const pn::Run& run : runs) {
    if (!edges.is_degenerate(run.edge)) continue;
    ++points;
    CHECK(std::abs(edges.start_of(run.edge)[2]) == 1);
  }
  CHECK(points == 2);
}

TEST_CASE("Trims of two faces with the same points are one edge, run in opposite directions") {
  // Two triangles of one paraboloid on both sides of a diagonal, on surfaces of their own.
  const auto triangle = [](std::array<double, 2> a, std::array<double, 2> b,
                           std::array<double, 2> c) {
    const auto side = [](std::array<double, 2> p, std::array<double, 2> q) {
      // Of degree 2: a curve of degree 1 with two poles has to lie on a side.
      return pn::ParameterCurve{2, {0, 1}, {3, 3}, {p, {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2}, q}};
    };
    return pn::test::within(pn::test::paraboloid(), {{side(a, b), side(b, c), side(c, a)}});
  };
  const std::array<double, 2> a = {-0.5, -0.5}, b = {0.5, -0.5}, c = {0.5, 0.5}, d = {-0.5, 0.5};
  SharedEdges edges;
  const auto first = pn::runs(add(edges, triangle(a, b, c)));
  const auto second = pn::runs(add(edges, triangle(a, c, d)));
  CHECK(edges.size() == 5);
  CHECK(first[2].edge == second[0].edge);
  CHECK(first[2].orientation != second[0].orientation);
  // The p-curve runs in the direction of the edge.
  const gp_Pnt2d start = second[0].p_curve->Value(second[0].first);
  CHECK(start.Distance(gp_Pnt2d(c[0], c[1])) < 1e-12);
}
