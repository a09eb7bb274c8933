// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/shared_edges.hpp"

#include <BRep_Builder.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>

#include "pn/occt/curve_on_surface.hpp"

namespace pn {
namespace {

using Point = std::array<double, 3>;
using ParameterPoint = std::array<double, 2>;

// OpenCASCADE reads every smaller tolerance as this one, in millimetres.
const double kTolerance = Precision::Confusion();

Point coordinates(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

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

// A curve of OpenCASCADE as plain data.
BoundaryCurve from_geometry(const Geom_BSplineCurve& geometry) {
  BoundaryCurve curve{geometry.Degree(), {}, {}, {}, {}};
  for (int k = 1; k <= geometry.NbKnots(); ++k) {
    curve.knots.push_back(geometry.Knot(k));
    curve.multiplicities.push_back(geometry.Multiplicity(k));
  }
  for (int i = 1; i <= geometry.NbPoles(); ++i) {
    curve.poles.push_back(coordinates(geometry.Pole(i)));
    curve.weights.push_back(geometry.Weight(i));
  }
  return curve;
}

// Images of trims are compared at so many places: between them they are smooth.
constexpr int kComparedSteps = 16;

// The part of a curve between two parameters.
Handle(Geom_BSplineCurve)
    segment(const Handle(Geom_BSplineCurve) & whole, double first, double last) {
  if (first == whole->FirstParameter() && last == whole->LastParameter()) return whole;
  const auto part = Handle(Geom_BSplineCurve)::DownCast(whole->Copy());
  part->Segment(first, last);
  return part;
}

// The straight p-curve from `start` at the parameter `first` to `end` at `last`; both points agree
// in one coordinate. OpenCASCADE knows a Geom2d_Line for isoparametric, but it runs at unit speed
// only.
Handle(Geom2d_Curve) straight_p_curve(const ParameterPoint& start, const ParameterPoint& end,
                                      double first, double last) {
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

// A point of a side; at its ends the pole itself.
Point point_at(const BoundaryCurve& curve, const Geom_BSplineCurve& geometry, double parameter) {
  if (parameter == curve.knots.front()) return curve.poles.front();
  if (parameter == curve.knots.back()) return curve.poles.back();
  return coordinates(geometry.Value(parameter));
}

}  // namespace

std::size_t SharedVertices::at(const Point& point) {
  const auto [entry, is_new] = vertex_at_.emplace(point, points_.size());
  if (is_new) {
    points_.push_back(point);
    parents_.push_back(entry->second);
  }
  return entry->second;
}

void SharedVertices::unite(std::size_t kept, std::size_t joined) {
  parents_[root(joined)] = root(kept);
}

std::size_t SharedVertices::root(std::size_t vertex) const {
  while (parents_[vertex] != vertex) vertex = parents_[vertex];
  return vertex;
}

std::vector<Run> runs(const FaceBoundary& boundary) {
  std::vector<Run> result;
  for (const auto& loop : boundary) result.insert(result.end(), loop.begin(), loop.end());
  return result;
}

std::vector<TrimImages> trim_images(const BSplineSurface& face,
                                    const std::vector<Handle(Geom_BSplineSurface)>& surfaces) {
  std::vector<TrimImages> result(surfaces.size());
  for (const BoundaryLoop& loop : boundary_loops(face)) {
    for (const BoundaryPiece& piece : loop) {
      const auto* trim = std::get_if<ParameterCurve>(&piece);
      if (!trim) continue;
      const TrimImages images = curves_on_surfaces(pn::to_geometry(*trim), surfaces);
      for (std::size_t i = 0; i < images.size(); ++i) result[i].push_back(images[i]);
    }
  }
  return result;
}

FaceBoundary SharedEdges::add(const BSplineSurface& surface, const TrimImages& images) {
  Corners corners;
  FaceBoundary boundary;
  auto image = images.begin();
  for (const BoundaryLoop& loop : boundary_loops(surface)) {
    auto& runs = boundary.emplace_back();
    for (const BoundaryPiece& piece : loop) {
      const auto* side = std::get_if<SidePiece>(&piece);
      runs.push_back(side ? run_side(*side, corners)
                          : run_trim(std::get<ParameterCurve>(piece), *image++, corners));
    }
  }
  return boundary;
}

bool SharedEdges::is_degenerate(std::size_t edge) const { return edges_[edge].curve.IsNull(); }

const Point& SharedEdges::start_of(std::size_t edge) const {
  return vertices_.point(edges_[edge].start);
}

BoundaryCurve SharedEdges::side_along(std::size_t edge) {
  const Edge& e = edges_[edge];
  BoundaryCurve curve = from_geometry(*segment(e.curve, e.first, e.last));
  curve.poles.front() = vertices_.point(e.start);
  curve.poles.back() = vertices_.point(e.end);
  const SidePiece piece{curve, e.first, e.last, {}, {}, true};
  sides_with_poles_.emplace(curve.poles, SharedSide{piece, edge});
  return curve;
}

Run SharedEdges::run_side(const SidePiece& piece, Corners& corners) {
  if (const auto edge = find(piece)) return run_along(*edge, piece, corners);
  const SidePiece turned = reversed(piece);
  if (const auto edge = find(turned)) return run_along(*edge, turned, corners);
  return run_along(make(piece), piece, corners);
}

// `piece` lies on the edge in the edge's own direction.
Run SharedEdges::run_along(std::size_t edge, const SidePiece& piece, Corners& corners) {
  const Edge& e = edges_[edge];
  vertices_.unite(e.start, corners.emplace(piece.start, e.start).first->second);
  vertices_.unite(e.end, corners.emplace(piece.end, e.end).first->second);
  return {edge, piece.rising ? TopAbs_FORWARD : TopAbs_REVERSED,
          straight_p_curve(piece.start, piece.end, e.first, e.last), e.first, e.last};
}

Run SharedEdges::run_trim(const ParameterCurve& trim, const Handle(Geom_BSplineCurve) & image,
                          Corners& corners) {
  const double first = trim.knots.front();
  const double last = trim.knots.back();
  const Handle(Geom2d_Curve) p_curve = pn::to_geometry(trim);
  const auto join = [&](const ParameterPoint& corner, std::size_t vertex) {
    vertices_.unite(corners.emplace(corner, vertex).first->second, vertex);
  };
  if (const auto match = find_trim(image)) {
    const Edge& e = edges_[match->edge];
    const bool is_forward = match->orientation == TopAbs_FORWARD;
    join(trim.poles.front(), is_forward ? e.start : e.end);
    join(trim.poles.back(), is_forward ? e.end : e.start);
    if (!is_forward) p_curve->Reverse();
    return {match->edge, match->orientation, p_curve, first, last};
  }
  const std::size_t start = vertices_.at(coordinates(image->StartPoint())),
                    end = vertices_.at(coordinates(image->EndPoint()));
  join(trim.poles.front(), start);
  join(trim.poles.back(), end);
  trims_.push_back(edges_.size());
  edges_.push_back({image, first, last, start, end});
  return {edges_.size() - 1, TopAbs_FORWARD, p_curve, first, last};
}

std::optional<SharedEdges::TrimMatch> SharedEdges::find_trim(const Handle(Geom_BSplineCurve) &
                                                             image) const {
  const double first = image->FirstParameter();
  const double last = image->LastParameter();
  for (const std::size_t edge : trims_) {
    const Edge& e = edges_[edge];
    if (e.first != first || e.last != last) continue;
    const auto coincides = [&](double from, double to) {
      for (int k = 0; k <= kComparedSteps; ++k) {
        const double part = static_cast<double>(k) / kComparedSteps;
        const gp_Pnt own = image->Value(first + part * (last - first));
        if (own.Distance(e.curve->Value(from + part * (to - from))) > kTolerance) return false;
      }
      return true;
    };
    if (coincides(first, last)) return TrimMatch{edge, TopAbs_FORWARD};
    if (coincides(last, first)) return TrimMatch{edge, TopAbs_REVERSED};
  }
  return std::nullopt;
}

std::optional<std::size_t> SharedEdges::find(const SidePiece& piece) const {
  const auto [begin, end] = sides_with_poles_.equal_range(piece.curve.poles);
  for (auto entry = begin; entry != end; ++entry) {
    if (coincide(entry->second.piece, piece)) return entry->second.edge;
  }
  return std::nullopt;
}

// A degenerate edge has no curve, and every face has its own.
std::size_t SharedEdges::make(const SidePiece& piece) {
  const auto& [curve, first, last, start, end, rising] = piece;
  if (pn::is_degenerate(curve)) {
    const std::size_t pole = vertices_.at(curve.poles.front());
    edges_.push_back({nullptr, first, last, pole, pole});
    return edges_.size() - 1;
  }
  const auto geometry = to_geometry(curve);
  edges_.push_back({geometry, first, last, vertices_.at(point_at(curve, *geometry, first)),
                    vertices_.at(point_at(curve, *geometry, last))});
  sides_with_poles_.emplace(curve.poles, SharedSide{piece, edges_.size() - 1});
  return edges_.size() - 1;
}

std::vector<TopoDS_Edge> SharedEdges::topology() const {
  const BRep_Builder builder;
  std::map<std::size_t, TopoDS_Vertex> made;
  const auto vertex = [&](std::size_t v) {
    TopoDS_Vertex& topology = made[vertices_.root(v)];
    const auto& [x, y, z] = vertices_.point(v);
    if (topology.IsNull()) builder.MakeVertex(topology, gp_Pnt(x, y, z), kTolerance);
    return topology;
  };
  std::vector<TopoDS_Edge> result;
  for (const Edge& e : edges_) {
    TopoDS_Edge& edge = result.emplace_back();
    if (e.curve.IsNull()) {
      builder.MakeEdge(edge);
      builder.Degenerated(edge, true);
    } else {
      builder.MakeEdge(edge, e.curve, kTolerance);
      builder.Range(edge, e.first, e.last);
    }
    builder.Add(edge, vertex(e.start).Oriented(TopAbs_FORWARD));
    builder.Add(edge, vertex(e.end).Oriented(TopAbs_REVERSED));
  }
  return result;
}

}  // namespace pn
