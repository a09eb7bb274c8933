// SPDX-License-Identifier: LGPL-2.1-or-later
// The edges of a shell, each made once however many faces run it.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopAbs_Orientation.hxx>
#include <TopoDS_Edge.hxx>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"
#include "pn/occt/boundary.hpp"

namespace pn {

/// One run of a face along an edge.
struct Run {
  std::size_t edge;                ///< Number of the edge.
  TopAbs_Orientation orientation;  ///< How a wire with the face to its left runs the edge.
  Handle(Geom2d_Curve) p_curve;    ///< Where the edge lies in the (u, v) plane,
  double first;                    ///< between these of its parameters.
  double last;
};

/// The runs around a face, loop by loop.
using FaceBoundary = std::vector<std::vector<Run>>;

/// All runs around a face.
std::vector<Run> runs(const FaceBoundary& boundary);

/// The curves in space along the trims of a face, in the order of its boundary.
using TrimImages = std::vector<Handle(Geom_BSplineCurve)>;

/// The images of the trims of a face on several surfaces, those of one trim over the same knots:
/// one TrimImages for each surface (curve_on_surface.hpp).
std::vector<TrimImages> trim_images(const BSplineSurface& face,
                                    const std::vector<Handle(Geom_BSplineSurface)>& surfaces);

/// Vertices of edges that are found to be one become one.
class SharedVertices {
 public:
  /// The vertex at a point: the same for points that are equal bit for bit.
  std::size_t at(const std::array<double, 3>& point);

  /// Makes one vertex of two, at the point of the first.
  void unite(std::size_t kept, std::size_t joined);

  /// The vertex that this one has become a part of.
  std::size_t root(std::size_t vertex) const;

  const std::array<double, 3>& point(std::size_t vertex) const { return points_[root(vertex)]; }

 private:
  std::vector<std::array<double, 3>> points_;
  std::vector<std::size_t> parents_;
  std::map<std::array<double, 3>, std::size_t> vertex_at_;
};

/// Collects the boundaries of faces.
///
/// - Two pieces of sides are one edge when they coincide in either direction (boundary.hpp); both
///   may belong to one face, which then has a seam.
/// - A piece of a side that is a single point is a degenerate edge.
/// - Trims are fitted to 1e-9 mm (curve_on_surface.hpp). Two of them are one edge when their images
///   have the same points at equal parameters, or at opposite ones, to OpenCASCADE's smallest
///   tolerance, 1e-7 mm: trims of different surfaces have no numbers in common.
/// - Edges that meet in one corner (u, v) of a face share a vertex there, and so do edges with ends
///   that are equal bit for bit. The vertex lies on the side where there is one.
class SharedEdges {
 public:
  /// The boundary of one more face, with the images of its trims.
  FaceBoundary add(const BSplineSurface& surface, const TrimImages& images);

  /// How many edges there are.
  std::size_t size() const { return edges_.size(); }

  /// True for a side that is a single point.
  bool is_degenerate(std::size_t edge) const;

  /// Where an edge begins.
  const std::array<double, 3>& start_of(std::size_t edge) const;

  /// Makes an edge the side of a further face: a curve that covers it from vertex to vertex, and by
  /// which `add` finds the edge. Both curves have the same points but for rounding. The edge may
  /// not be degenerate.
  BoundaryCurve side_along(std::size_t edge);

  /// All edges collected, by their numbers, with their vertices and without p-curves.
  std::vector<TopoDS_Edge> topology() const;

 private:
  struct Edge {
    Handle(Geom_BSplineCurve) curve;  // None when degenerate.
    double first;
    double last;
    std::size_t start;  // Vertices.
    std::size_t end;
  };
  struct SharedSide {
    SidePiece piece;
    std::size_t edge;
  };
  // The vertices of one face by their parameters.
  using Corners = std::map<std::array<double, 2>, std::size_t>;

  Run run_side(const SidePiece& piece, Corners& corners);
  Run run_trim(const ParameterCurve& trim, const Handle(Geom_BSplineCurve) & image,
               Corners& corners);
  Run run_along(std::size_t edge, const SidePiece& piece, Corners& corners);
  // The trim that has the same image, and how the new one runs along it.
  struct TrimMatch {
    std::size_t edge;
    TopAbs_Orientation orientation;
  };
  std::optional<TrimMatch> find_trim(const Handle(Geom_BSplineCurve) & image) const;
  std::optional<std::size_t> find(const SidePiece& piece) const;
  std::size_t make(const SidePiece& piece);

  std::vector<Edge> edges_;
  std::vector<std::size_t> trims_;  // Those of the edges that are trims.
  std::multimap<std::vector<std::array<double, 3>>, SharedSide> sides_with_poles_;
  SharedVertices vertices_;
};

}  // namespace pn
