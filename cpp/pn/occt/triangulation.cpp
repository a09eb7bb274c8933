// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/triangulation.hpp"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

// Steps between two knots, as the header says, and the nodes of all faces, about.
constexpr int kFewestSteps = 2;
constexpr int kMostSteps = 9;
constexpr double kNodes = 40'000;

// A side of the parameter rectangle as an edge runs it: nodes with the edge's parameters, which
// rise.
struct SideOfGrid {
  TopoDS_Edge edge;
  std::vector<int> nodes;
  std::vector<double> parameters;
};

std::vector<double> divided(const std::vector<double>& knots, int steps) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    for (int k = 0; k < steps; ++k) {
      result.push_back(knots[i] + (knots[i + 1] - knots[i]) * k / steps);
    }
  }
  result.push_back(knots.back());
  return result;
}

// The parameters of a grid on a surface, and the numbers of its nodes, from 1 on as Poly wants
// them.
class Grid {
 public:
  Grid(const Geom_BSplineSurface& surface, int steps)
      : u_(divided(knots(surface, &Geom_BSplineSurface::UKnot, surface.NbUKnots()),
                   surface.UDegree() == 1 ? 1 : steps)),
        v_(divided(knots(surface, &Geom_BSplineSurface::VKnot, surface.NbVKnots()),
                   surface.VDegree() == 1 ? 1 : steps)) {}

  const std::vector<double>& u() const { return u_; }
  const std::vector<double>& v() const { return v_; }
  int node(std::size_t i, std::size_t j) const { return static_cast<int>(i * v_.size() + j) + 1; }

  // The nodes along a side from one corner of the rectangle to another; none when the two points
  // are not the ends of a side.
  std::vector<int> side(const gp_Pnt2d& from, const gp_Pnt2d& to) const {
    std::vector<int> nodes;
    if (from.X() == to.X() && is_end(from.X(), u_)) {
      const std::size_t i = from.X() == u_.front() ? 0 : u_.size() - 1;
      for (std::size_t j = 0; j < v_.size(); ++j) nodes.push_back(node(i, j));
      return between(nodes, from.Y(), to.Y(), v_);
    }
    if (from.Y() == to.Y() && is_end(from.Y(), v_)) {
      const std::size_t j = from.Y() == v_.front() ? 0 : v_.size() - 1;
      for (std::size_t i = 0; i < u_.size(); ++i) nodes.push_back(node(i, j));
      return between(nodes, from.X(), to.X(), u_);
    }
    return {};
  }

 private:
  using Knot = Standard_Real (Geom_BSplineSurface::*)(Standard_Integer) const;

  static std::vector<double> knots(const Geom_BSplineSurface& surface, Knot knot, int count) {
    std::vector<double> result;
    for (int i = 1; i <= count; ++i) result.push_back((surface.*knot)(i));
    return result;
  }

  static bool is_end(double parameter, const std::vector<double>& line) {
    return parameter == line.front() || parameter == line.back();
  }

  static std::vector<int> between(std::vector<int> nodes, double from, double to,
                                  const std::vector<double>& line) {
    if (from == line.front() && to == line.back()) return nodes;
    if (from != line.back() || to != line.front()) return {};
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

  std::vector<double> u_, v_;
};

// A p-curve that is off by no more, in parameters, runs where a side does.
constexpr double kSameParameter = 1e-9;

// The side that an edge of a face runs along with one speed; nothing when it is no whole side, or a
// trim along it with a speed of its own.
std::optional<SideOfGrid> side_of(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                  const Grid& grid) {
  double first, last;
  const auto p_curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (p_curve.IsNull()) return std::nullopt;
  const gp_Pnt2d start = p_curve->Value(first), end = p_curve->Value(last);
  SideOfGrid side{edge, grid.side(start, end), {}};
  if (side.nodes.empty()) return std::nullopt;
  const bool along_u = start.Y() == end.Y();
  for (const int node : side.nodes) {
    const std::size_t i = (node - 1) / grid.v().size(), j = (node - 1) % grid.v().size();
    const double part = along_u ? (grid.u()[i] - start.X()) / (end.X() - start.X())
                                : (grid.v()[j] - start.Y()) / (end.Y() - start.Y());
    side.parameters.push_back(first + (last - first) * part);
    const gp_Pnt2d place(grid.u()[i], grid.v()[j]);
    if (p_curve->Value(side.parameters.back()).Distance(place) > kSameParameter) {
      return std::nullopt;
    }
  }
  return side;
}

// The four sides of a face that is the whole of its surface, else nothing.
std::optional<std::vector<SideOfGrid>> sides_of(const TopoDS_Face& face, const Grid& grid) {
  std::vector<SideOfGrid> sides;
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
    const auto side = side_of(TopoDS::Edge(edge.Current()), face, grid);
    if (!side) return std::nullopt;
    sides.push_back(*side);
  }
  return sides.size() == 4 ? std::optional(sides) : std::nullopt;
}

Handle(Poly_Triangulation)
    triangulation_of(const Handle(Geom_BSplineSurface) & geometry, const Grid& grid) {
  const GeomAdaptor_Surface surface(geometry);
  const auto &u = grid.u(), &v = grid.v();
  const int meshes = static_cast<int>((u.size() - 1) * (v.size() - 1));
  Handle(Poly_Triangulation) result =
      new Poly_Triangulation(static_cast<int>(u.size() * v.size()), 2 * meshes, true);
  for (std::size_t i = 0; i < u.size(); ++i) {
    for (std::size_t j = 0; j < v.size(); ++j) {
      result->SetNode(grid.node(i, j), surface.Value(u[i], v[j]));
      result->SetUVNode(grid.node(i, j), {u[i], v[j]});
    }
  }
  int triangle = 0;
  double deflection = 0;
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    for (std::size_t j = 0; j + 1 < v.size(); ++j) {
      const int a = grid.node(i, j), b = grid.node(i + 1, j), c = grid.node(i + 1, j + 1),
                d = grid.node(i, j + 1);
      result->SetTriangle(++triangle, Poly_Triangle(a, b, c));
      result->SetTriangle(++triangle, Poly_Triangle(a, c, d));
      const gp_Pnt middle = surface.Value((u[i] + u[i + 1]) / 2, (v[j] + v[j + 1]) / 2);
      const gp_XYZ chord = (result->Node(a).XYZ() + result->Node(c).XYZ()) / 2;
      deflection = std::max(deflection, (middle.XYZ() - chord).Modulus());
    }
  }
  result->Deflection(deflection);
  return result;
}

Handle(Poly_PolygonOnTriangulation) polygon_of(const SideOfGrid& side) {
  const int count = static_cast<int>(side.nodes.size());
  TColStd_Array1OfInteger nodes(1, count);
  TColStd_Array1OfReal parameters(1, count);
  for (int i = 0; i < count; ++i) {
    nodes(i + 1) = side.nodes[i];
    parameters(i + 1) = side.parameters[i];
  }
  return new Poly_PolygonOnTriangulation(nodes, parameters);
}

// The sides as polygons of their edges; a seam is an edge with two.
void give_polygons(const std::vector<SideOfGrid>& sides,
                   const Handle(Poly_Triangulation) & triangulation,
                   const TopLoc_Location& location) {
  const BRep_Builder builder;
  for (auto side = sides.begin(); side != sides.end(); ++side) {
    const auto again = std::find_if(sides.begin(), sides.end(), [&](const SideOfGrid& other) {
      return &other != &*side && other.edge.IsSame(side->edge);
    });
    if (again == sides.end()) {
      builder.UpdateEdge(side->edge, polygon_of(*side), triangulation, location);
    } else if (side->edge.Orientation() == TopAbs_FORWARD) {
      builder.UpdateEdge(side->edge, polygon_of(*side), polygon_of(*again), triangulation,
                         location);
    }
  }
}

void triangulate(const TopoDS_Face& face, int steps) {
  TopLoc_Location location;
  const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face, location));
  if (surface.IsNull()) return;
  const Grid grid(*surface, steps);
  const auto sides = sides_of(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), grid);
  if (!sides) return;
  const auto triangulation = triangulation_of(surface, grid);
  BRep_Builder().UpdateFace(face, triangulation);
  give_polygons(*sides, triangulation, location);
}

// The steps between two knots that make about kNodes nodes.
int steps_for(const std::vector<TopoDS_Face>& faces) {
  double rectangles = 1;
  for (const TopoDS_Face& face : faces) {
    TopLoc_Location location;
    const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face, location));
    if (surface.IsNull()) continue;
    rectangles += (surface->NbUKnots() - 1.) * (surface->NbVKnots() - 1.);
  }
  const auto steps = static_cast<int>(std::sqrt(kNodes / rectangles));
  return std::clamp(steps, kFewestSteps, kMostSteps);
}

}  // namespace

TopoDS_Shape triangulated(const TopoDS_Shape& shape) {
  return with_occt_errors([&] {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
      faces.push_back(TopoDS::Face(face.Current()));
    }
    const int steps = steps_for(faces);
    for (const TopoDS_Face& face : faces) triangulate(face, steps);
    return shape;
  });
}

}  // namespace pn
