// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/shell.hpp"

#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "pn/occt/boundary.hpp"
#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

using Point = std::array<double, 3>;
using SurfaceHandle = Handle(Geom_BSplineSurface);

// OpenCASCADE reads every smaller tolerance as this one, in millimetres.
const double kTolerance = Precision::Confusion();

// Along a smooth joint the normals of both faces differ by rounding only; any corner that a
// designer means is far above this angle, in radians.
constexpr double kSmoothAngle = 1e-9;

// How the counterclockwise wire of a face runs its sides, in the order of `boundaries`.
constexpr std::array<TopAbs_Orientation, 4> kCounterclockwise = {TopAbs_FORWARD, TopAbs_FORWARD,
                                                                 TopAbs_REVERSED, TopAbs_REVERSED};

Handle(Geom_BSplineCurve) to_geometry(const BoundaryCurve& curve) {
  const int pole_count = static_cast<int>(curve.poles.size());
  const int knot_count = static_cast<int>(curve.knots.size());
  TColgp_Array1OfPnt poles(1, pole_count);
  for (int i = 0; i < pole_count; ++i) {
    const auto& [x, y, z] = curve.poles[i];
    poles.SetValue(i + 1, gp_Pnt(x, y, z));
  }
  return new Geom_BSplineCurve(poles, TColStd_Array1OfReal(curve.weights.front(), 1, pole_count),
                               TColStd_Array1OfReal(curve.knots.front(), 1, knot_count),
                               TColStd_Array1OfInteger(curve.multiplicities.front(), 1, knot_count),
                               curve.degree);
}

// The straight p-curve from `start` at the parameter `first` to `end` at `last`; both points agree
// in one coordinate. OpenCASCADE knows a Geom2d_Line for isoparametric, but it runs at unit speed
// only.
Handle(Geom2d_Curve) straight_p_curve(const std::array<double, 2>& start,
                                      const std::array<double, 2>& end, double first, double last) {
  const gp_Pnt2d from(start[0], start[1]);
  const gp_Pnt2d to(end[0], end[1]);
  const gp_Vec2d step(from, to);
  if (std::abs(step.X()) + std::abs(step.Y()) == last - first) {
    const gp_Dir2d direction(step);
    return new Geom2d_Line(from.Translated(-first * gp_Vec2d(direction)), direction);
  }
  const std::array<gp_Pnt2d, 2> poles = {from, to};
  const std::array<double, 2> knots = {first, last};
  const std::array<int, 2> multiplicities = {2, 2};
  return new Geom2d_BSplineCurve(TColgp_Array1OfPnt2d(poles.front(), 1, 2),
                                 TColStd_Array1OfReal(knots.front(), 1, 2),
                                 TColStd_Array1OfInteger(multiplicities.front(), 1, 2), 1);
}

// A side of a face: the number of its edge, how the counterclockwise wire runs the edge, and where
// the edge lies in the (u, v) plane.
struct Side {
  std::size_t edge;
  TopAbs_Orientation orientation;
  Handle(Geom2d_Curve) p_curve;
};

// The edges of a shell, each made once and found again by its poles.
class SharedEdges {
 public:
  Side side(const Boundary& boundary, TopAbs_Orientation orientation) {
    if (const auto edge = find(boundary.curve)) {
      return side_on(*edge, orientation, boundary.start, boundary.end);
    }
    if (const auto edge = find(reversed(boundary.curve))) {
      return side_on(*edge, TopAbs::Reverse(orientation), boundary.end, boundary.start);
    }
    return side_on(make(boundary.curve), orientation, boundary.start, boundary.end);
  }

  std::size_t count() const { return edges_.size(); }
  const TopoDS_Edge& operator[](std::size_t edge) const { return edges_[edge].topology; }
  const BoundaryCurve& curve(std::size_t edge) const { return edges_[edge].curve; }

 private:
  struct Edge {
    BoundaryCurve curve;
    TopoDS_Edge topology;
  };

  std::optional<std::size_t> find(const BoundaryCurve& curve) const {
    const auto [begin, end] = edge_with_poles_.equal_range(curve.poles);
    for (auto entry = begin; entry != end; ++entry) {
      if (coincide(edges_[entry->second].curve, curve)) return entry->second;
    }
    return std::nullopt;
  }

  Side side_on(std::size_t edge, TopAbs_Orientation orientation, const std::array<double, 2>& start,
               const std::array<double, 2>& end) const {
    const auto& knots = curve(edge).knots;
    return {edge, orientation, straight_p_curve(start, end, knots.front(), knots.back())};
  }

  // A degenerate edge has no curve, and every face has its own.
  std::size_t make(const BoundaryCurve& curve) {
    TopoDS_Edge edge;
    if (is_degenerate(curve)) {
      builder_.MakeEdge(edge);
      builder_.Degenerated(edge, true);
    } else {
      builder_.MakeEdge(edge, to_geometry(curve), kTolerance);
      builder_.Range(edge, curve.knots.front(), curve.knots.back());
      edge_with_poles_.emplace(curve.poles, edges_.size());
    }
    builder_.Add(edge, vertex(curve.poles.front()).Oriented(TopAbs_FORWARD));
    builder_.Add(edge, vertex(curve.poles.back()).Oriented(TopAbs_REVERSED));
    edges_.push_back({curve, edge});
    return edges_.size() - 1;
  }

  TopoDS_Vertex vertex(const Point& point) {
    TopoDS_Vertex& vertex = vertices_[point];
    if (vertex.IsNull()) {
      builder_.MakeVertex(vertex, gp_Pnt(point[0], point[1], point[2]), kTolerance);
    }
    return vertex;
  }

  BRep_Builder builder_;
  std::vector<Edge> edges_;
  std::multimap<std::vector<Point>, std::size_t> edge_with_poles_;
  std::map<Point, TopoDS_Vertex> vertices_;
};

using Sides = std::array<Side, 4>;

Sides sides(const BSplineSurface& surface, SharedEdges& edges) {
  const std::array<Boundary, 4> boundary = boundaries(surface);
  Sides result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = edges.side(boundary[i], kCounterclockwise[i]);
  return result;
}

// A face that runs an edge, and in which direction.
struct EdgeUse {
  std::size_t face;
  TopAbs_Orientation orientation;
};

// The uses of every edge.
std::vector<std::vector<EdgeUse>> edge_uses(const std::vector<Sides>& faces,
                                            std::size_t edge_count) {
  std::vector<std::vector<EdgeUse>> uses(edge_count);
  for (std::size_t face = 0; face < faces.size(); ++face) {
    for (const Side& side : faces[face]) uses[side.edge].push_back({face, side.orientation});
  }
  for (const auto& use : uses) {
    if (use.size() > 2) throw std::invalid_argument("More than two faces meet at one edge.");
  }
  return uses;
}

// Orientations of the faces such that neighbours run their common edge in opposite directions; the
// first face is forward. Walks from face to face over the edges.
std::vector<TopAbs_Orientation> consistent_orientations(
    const std::vector<Sides>& faces, const std::vector<std::vector<EdgeUse>>& uses) {
  std::vector<std::optional<TopAbs_Orientation>> orientations(faces.size());
  orientations[0] = TopAbs_FORWARD;
  std::vector<std::size_t> reached = {0};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const std::size_t face = reached[next];
    for (const Side& side : faces[face]) {
      const auto& use = uses[side.edge];
      if (use.size() < 2) continue;
      const std::size_t neighbour = use[0].face == face ? use[1].face : use[0].face;
      const bool opposite = use[0].orientation != use[1].orientation;
      const TopAbs_Orientation needed =
          opposite ? *orientations[face] : TopAbs::Reverse(*orientations[face]);
      if (!orientations[neighbour]) {
        orientations[neighbour] = needed;
        reached.push_back(neighbour);
      } else if (*orientations[neighbour] != needed) {
        throw std::invalid_argument("The faces form a one-sided surface.");
      }
    }
  }
  if (reached.size() < faces.size()) {
    throw std::invalid_argument("The faces do not hang together by common edges.");
  }
  std::vector<TopAbs_Orientation> result;
  for (const auto& orientation : orientations) result.push_back(*orientation);
  return result;
}

// Hands the p-curves of a face to its edges. An edge that the face runs twice is a seam:
// OpenCASCADE wants the p-curve of the forward run first.
void add_p_curves(const TopoDS_Face& face, const Sides& sides, const SharedEdges& edges) {
  const BRep_Builder builder;
  for (const Side& side : sides) {
    const TopoDS_Edge& edge = edges[side.edge];
    const auto runs_back = [&](const Side& other) {
      return other.edge == side.edge && other.orientation != side.orientation;
    };
    const auto back = std::find_if(sides.begin(), sides.end(), runs_back);
    if (back == sides.end()) {
      builder.UpdateEdge(edge, side.p_curve, face, kTolerance);
    } else if (side.orientation == TopAbs_FORWARD) {
      builder.UpdateEdge(edge, side.p_curve, back->p_curve, face, kTolerance);
    }
    const auto& knots = edges.curve(side.edge).knots;
    builder.Range(edge, face, knots.front(), knots.back());
  }
}

TopoDS_Face make_face(const SurfaceHandle& surface, const Sides& sides, const SharedEdges& edges) {
  const BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, surface, kTolerance);
  add_p_curves(face, sides, edges);
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const Side& side : sides) builder.Add(wire, edges[side.edge].Oriented(side.orientation));
  wire.Closed(true);
  builder.Add(face, wire);
  return face;
}

TopoDS_Shell build_shell(const std::vector<BSplineSurface>& surfaces) {
  // P-curves belong to a surface handle: every face has its own.
  std::vector<SurfaceHandle> geometries;
  for (const BSplineSurface& surface : surfaces) geometries.push_back(to_geometry(surface));
  SharedEdges edges;
  std::vector<Sides> faces;
  for (const BSplineSurface& surface : surfaces) faces.push_back(sides(surface, edges));
  const auto orientations = consistent_orientations(faces, edge_uses(faces, edges.count()));

  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    builder.Add(shell, make_face(geometries[i], faces[i], edges).Oriented(orientations[i]));
  }
  shell.Closed(BRep_Tool::IsClosed(shell));
  BRepLib::EncodeRegularity(shell, kSmoothAngle);
  return shell;
}

}  // namespace

TopoDS_Shell make_shell(const std::vector<BSplineSurface>& surfaces) {
  if (surfaces.empty()) throw std::invalid_argument("A shell needs at least one surface.");
  return with_occt_errors([&] { return build_shell(surfaces); });
}

}  // namespace pn
