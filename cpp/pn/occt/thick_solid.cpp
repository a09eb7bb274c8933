// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/thick_solid.hpp"

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <stdexcept>

#include "pn/occt/boundary.hpp"
#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/occt_error.hpp"
#include "pn/occt/shared_edges.hpp"
#include "pn/occt/shell.hpp"

namespace pn {
namespace {

// The solid inside a closed shell, its faces pointing outwards.
TopoDS_Solid solid_inside(const TopoDS_Shell& shell) {
  if (!BRep_Tool::IsClosed(shell)) {
    throw std::invalid_argument("A thick solid needs closed shells, and one of the two is open.");
  }
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TopoDS_Shape shell_of(const TopoDS_Solid& solid) {
  return TopExp_Explorer(solid, TopAbs_SHELL).Current();
}

bool contains_vertices(const TopoDS_Solid& outer, const TopoDS_Shape& inner) {
  BRepClass3d_SolidClassifier classifier(outer);
  for (TopExp_Explorer vertex(inner, TopAbs_VERTEX); vertex.More(); vertex.Next()) {
    classifier.Perform(BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current())), Precision::Confusion());
    if (classifier.State() != TopAbs_IN) return false;
  }
  return true;
}

TopoDS_Solid build_thick_solid(const TopoDS_Shell& inner, const TopoDS_Shell& outer) {
  const TopoDS_Solid filled = solid_inside(outer);
  const TopoDS_Solid hollow = solid_inside(inner);
  if (!contains_vertices(filled, hollow)) {
    throw std::invalid_argument("The inner shell does not lie inside the outer one.");
  }
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell_of(filled));
  builder.Add(solid, shell_of(hollow).Reversed());
  return solid;
}

bool have_equal_structure(const BoundaryCurve& a, const BoundaryCurve& b) {
  return a.degree == b.degree && a.knots == b.knots && a.multiplicities == b.multiplicities;
}

// The ruled surface between two curves over the same knots.
BSplineSurface ruled_surface(const BoundaryCurve& a, const BoundaryCurve& b) {
  BSplineSurface surface{a.degree, 1, a.knots, {0, 1}, a.multiplicities, {2, 2}, {}, {}, {}};
  for (std::size_t i = 0; i < a.poles.size(); ++i) {
    surface.poles.insert(surface.poles.end(), {a.poles[i], b.poles[i]});
    surface.weights.insert(surface.weights.end(), {a.weights[i], b.weights[i]});
  }
  return surface;
}

// The whole side of a face that has no trims.
BoundaryCurve side_curve(const BSplineSurface& surface, std::size_t side) {
  return std::get<SidePiece>(boundary_loops(surface).front()[side]).curve;
}

// The sides of untrimmed faces that belong to one face only: of every first side those in the order
// of the faces, then of every second. So the ends of a pipe come in the same order, however many
// faces it has.
std::vector<BoundaryCurve> free_sides(const std::vector<BSplineSurface>& surfaces) {
  SharedEdges edges;
  std::vector<std::vector<Run>> faces;
  for (const BSplineSurface& surface : surfaces) {
    faces.push_back(edges.add(surface, to_geometry(surface)).front());
  }
  std::vector<int> counts(edges.topology().size());
  for (const auto& face : faces) {
    for (const Run& run : face) ++counts[run.edge];
  }
  std::vector<BoundaryCurve> result;
  for (std::size_t side = 0; side < 4; ++side) {
    for (std::size_t face = 0; face < faces.size(); ++face) {
      if (counts[faces[face][side].edge] == 1) result.push_back(side_curve(surfaces[face], side));
    }
  }
  return result;
}

// The ruled surfaces along the free sides. Between two points there is none.
std::vector<BSplineSurface> walls(const std::vector<BSplineSurface>& inner,
                                  const std::vector<BSplineSurface>& outer) {
  const std::vector<BoundaryCurve> starts = free_sides(inner);
  const std::vector<BoundaryCurve> ends = free_sides(outer);
  if (!std::equal(starts.begin(), starts.end(), ends.begin(), ends.end(), have_equal_structure)) {
    throw std::invalid_argument("The free sides of the two open shells do not correspond.");
  }
  std::vector<BSplineSurface> result;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (is_degenerate(starts[i]) && is_degenerate(ends[i])) continue;
    result.push_back(ruled_surface(starts[i], ends[i]));
  }
  return result;
}

TopoDS_Solid walled_solid(const std::vector<BSplineSurface>& inner,
                          const std::vector<BSplineSurface>& outer) {
  const auto is_trimmed = [](const BSplineSurface& surface) { return !surface.trims.empty(); };
  if (std::any_of(inner.begin(), inner.end(), is_trimmed) ||
      std::any_of(outer.begin(), outer.end(), is_trimmed)) {
    throw std::invalid_argument("Trimmed faces cannot be joined by walls.");
  }
  std::vector<BSplineSurface> faces = inner;
  faces.insert(faces.end(), outer.begin(), outer.end());
  const std::vector<BSplineSurface> between = walls(inner, outer);
  faces.insert(faces.end(), between.begin(), between.end());
  return solid_inside(make_shell(faces));
}

}  // namespace

TopoDS_Solid make_thick_solid(const TopoDS_Shell& inner, const TopoDS_Shell& outer) {
  return with_occt_errors([&] { return build_thick_solid(inner, outer); });
}

TopoDS_Solid make_thick_solid(const std::vector<BSplineSurface>& inner,
                              const std::vector<BSplineSurface>& outer) {
  const TopoDS_Shell inner_shell = make_shell(inner);
  const TopoDS_Shell outer_shell = make_shell(outer);
  if (inner_shell.Closed() || outer_shell.Closed()) {
    return make_thick_solid(inner_shell, outer_shell);
  }
  return with_occt_errors([&] { return walled_solid(inner, outer); });
}

}  // namespace pn
