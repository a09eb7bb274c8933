// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/shell.hpp"

#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <map>
#include <stdexcept>

#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/occt_error.hpp"
#include "pn/occt/shared_edges.hpp"

namespace pn {
namespace {

// OpenCASCADE reads every smaller tolerance as this one, in millimetres.
const double kTolerance = Precision::Confusion();

// Along a smooth joint the normals of both faces differ by rounding only; any corner that a
// designer means is far above this angle, in radians.
constexpr double kSmoothAngle = 1e-9;

// A face that runs an edge, and in which direction.
struct EdgeUse {
  std::size_t face;
  TopAbs_Orientation orientation;
};

// The uses of every edge.
std::vector<std::vector<EdgeUse>> edge_uses(const std::vector<BoundedSurface>& faces,
                                            std::size_t edge_count) {
  std::vector<std::vector<EdgeUse>> uses(edge_count);
  for (std::size_t face = 0; face < faces.size(); ++face) {
    for (const Run& run : runs(faces[face].boundary))
      uses[run.edge].push_back({face, run.orientation});
  }
  for (const auto& use : uses) {
    if (use.size() > 2) throw std::invalid_argument("More than two faces meet at one edge.");
  }
  return uses;
}

// Faces that hang together, each with its orientation.
using Part = std::map<std::size_t, TopAbs_Orientation>;

// The faces that hang together with `first`, which is forward, such that neighbours run their
// common edge in opposite directions. Walks from face to face over the edges.
Part part_around(std::size_t first, const std::vector<BoundedSurface>& faces,
                 const std::vector<std::vector<EdgeUse>>& uses) {
  Part part = {{first, TopAbs_FORWARD}};
  std::vector<std::size_t> reached = {first};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const std::size_t face = reached[next];
    for (const Run& run : runs(faces[face].boundary)) {
      const auto& use = uses[run.edge];
      if (use.size() < 2) continue;
      const std::size_t neighbour = use[0].face == face ? use[1].face : use[0].face;
      const bool opposite = use[0].orientation != use[1].orientation;
      const TopAbs_Orientation needed = opposite ? part[face] : TopAbs::Reverse(part[face]);
      const auto [entry, is_new] = part.emplace(neighbour, needed);
      if (is_new) reached.push_back(neighbour);
      if (entry->second != needed) {
        throw std::invalid_argument("The faces form a one-sided surface.");
      }
    }
  }
  return part;
}

// Every face belongs to one part.
std::vector<Part> separate_parts(const std::vector<BoundedSurface>& faces,
                                 const std::vector<std::vector<EdgeUse>>& uses) {
  std::vector<Part> parts;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const auto contains_face = [face](const Part& part) { return part.count(face) > 0; };
    if (std::none_of(parts.begin(), parts.end(), contains_face)) {
      parts.push_back(part_around(face, faces, uses));
    }
  }
  return parts;
}

// Hands the p-curves of a face to its edges. An edge that the face runs twice is a seam:
// OpenCASCADE wants the p-curves of both runs at once, that of the forward run first.
void add_p_curves(const TopoDS_Face& face, const FaceBoundary& boundary,
                  const std::vector<TopoDS_Edge>& edges) {
  const BRep_Builder builder;
  const std::vector<Run> around = runs(boundary);
  for (const Run& run : around) {
    const TopoDS_Edge& edge = edges[run.edge];
    const auto runs_back = [&](const Run& other) {
      return other.edge == run.edge && other.orientation != run.orientation;
    };
    const auto back = std::find_if(around.begin(), around.end(), runs_back);
    if (back == around.end()) {
      builder.UpdateEdge(edge, run.p_curve, face, kTolerance);
    } else {
      const Run& forward = run.orientation == TopAbs_FORWARD ? run : *back;
      const Run& backward = run.orientation == TopAbs_FORWARD ? *back : run;
      builder.UpdateEdge(edge, forward.p_curve, backward.p_curve, face, kTolerance);
    }
    builder.Range(edge, face, run.first, run.last);
  }
}

TopoDS_Face make_face(const BoundedSurface& bounded, const std::vector<TopoDS_Edge>& edges) {
  const BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, bounded.geometry, kTolerance);
  add_p_curves(face, bounded.boundary, edges);
  for (const std::vector<Run>& loop : bounded.boundary) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const Run& run : loop) builder.Add(wire, edges[run.edge].Oriented(run.orientation));
    wire.Closed(true);
    builder.Add(face, wire);
  }
  return face;
}

TopoDS_Shell shell_of(const std::vector<TopoDS_Face>& faces) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const TopoDS_Face& face : faces) builder.Add(shell, face);
  shell.Closed(BRep_Tool::IsClosed(shell));
  BRepLib::EncodeRegularity(shell, kSmoothAngle);
  return shell;
}

std::vector<TopoDS_Shell> build_shells(const SharedEdges& shared,
                                       const std::vector<BoundedSurface>& bounded) {
  const std::vector<TopoDS_Edge> edges = shared.topology();
  std::vector<TopoDS_Shell> shells;
  for (const Part& part : separate_parts(bounded, edge_uses(bounded, edges.size()))) {
    std::vector<TopoDS_Face> faces;
    for (const auto& [i, orientation] : part) {
      faces.push_back(TopoDS::Face(make_face(bounded[i], edges).Oriented(orientation)));
    }
    shells.push_back(shell_of(faces));
  }
  return shells;
}

std::vector<TopoDS_Shell> build_shells(const std::vector<BSplineSurface>& surfaces) {
  SharedEdges edges;
  std::vector<BoundedSurface> faces;
  for (const BSplineSurface& surface : surfaces) {
    const auto geometry = to_geometry(surface);
    const TrimImages images = trim_images(surface, {geometry}).front();
    faces.push_back({geometry, edges.add(surface, images)});
  }
  return build_shells(edges, faces);
}

}  // namespace

std::vector<TopoDS_Shell> make_shells(const SharedEdges& edges,
                                      const std::vector<BoundedSurface>& faces) {
  return with_occt_errors([&] { return build_shells(edges, faces); });
}

std::vector<TopoDS_Shell> make_shells(const std::vector<BSplineSurface>& surfaces) {
  if (surfaces.empty()) throw std::invalid_argument("A shell needs at least one surface.");
  return with_occt_errors([&] { return build_shells(surfaces); });
}

TopoDS_Shell make_shell(const std::vector<BSplineSurface>& surfaces) {
  const std::vector<TopoDS_Shell> shells = make_shells(surfaces);
  if (shells.size() > 1) {
    throw std::invalid_argument("The faces do not hang together by common edges.");
  }
  return shells.front();
}

}  // namespace pn
