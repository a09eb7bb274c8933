// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/thick_solid.hpp"

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <stdexcept>

#include "pn/occt/boundary.hpp"
#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/free_boundary.hpp"
#include "pn/occt/occt_error.hpp"
#include "pn/occt/shared_edges.hpp"
#include "pn/occt/shell.hpp"

namespace pn {
namespace {

TopoDS_Shape shell_of(const TopoDS_Solid& solid) {
  return TopExp_Explorer(solid, TopAbs_SHELL).Current();
}

bool contains_vertices(const TopoDS_Solid& outer, const TopoDS_Shape& inner) {
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(inner, TopAbs_VERTEX, vertices);
  BRepClass3d_SolidClassifier classifier(outer);
  return std::all_of(vertices.cbegin(), vertices.cend(), [&](const TopoDS_Shape& vertex) {
    classifier.Perform(BRep_Tool::Pnt(TopoDS::Vertex(vertex)), Precision::Confusion());
    return classifier.State() == TopAbs_IN;
  });
}

TopoDS_Solid build_thick_solid(const TopoDS_Shell& inner, const TopoDS_Shell& outer) {
  if (!BRep_Tool::IsClosed(inner) || !BRep_Tool::IsClosed(outer)) {
    throw std::invalid_argument("A thick solid needs closed shells, and one of the two is open.");
  }
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

bool have_equal_structure(const ParameterCurve& a, const ParameterCurve& b) {
  return a.degree == b.degree && a.knots == b.knots && a.multiplicities == b.multiplicities &&
         a.poles == b.poles;
}

bool have_equal_trims(const TrimLoop& a, const TrimLoop& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return have_equal_structure(x, y); });
}

bool have_equal_structure(const BSplineSurface& a, const BSplineSurface& b) {
  return a.u_degree == b.u_degree && a.v_degree == b.v_degree && a.u_knots == b.u_knots &&
         a.v_knots == b.v_knots && a.u_multiplicities == b.u_multiplicities &&
         a.v_multiplicities == b.v_multiplicities &&
         std::equal(a.trims.begin(), a.trims.end(), b.trims.begin(), b.trims.end(),
                    have_equal_trims);
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

// A point as a curve over the knots of another one.
BoundaryCurve standing_still(BoundaryCurve curve, const std::array<double, 3>& point) {
  std::fill(curve.poles.begin(), curve.poles.end(), point);
  return curve;
}

// The faces of two offsets and, one after the other, the walls between them.
class WalledFaces {
 public:
  WalledFaces(const std::vector<BSplineSurface>& inner, const std::vector<BSplineSurface>& outer) {
    add_offsets(inner, outer);
    for (const auto& [start, end] : free_edges()) add_wall(start, end);
    has_walls_ = faces_.size() > inner.size() + outer.size();
  }

  bool has_walls() const { return has_walls_; }

  std::vector<TopoDS_Shell> shells() const { return make_shells(edges_, faces_); }

 private:
  void add_offsets(const std::vector<BSplineSurface>& inner,
                   const std::vector<BSplineSurface>& outer) {
    std::vector<BoundedSurface> outer_faces;
    std::vector<TrimImages> outer_images;
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const auto inner_geometry = to_geometry(inner[i]);
      const auto outer_geometry = to_geometry(outer[i]);
      const auto images = trim_images(inner[i], {inner_geometry, outer_geometry});
      faces_.push_back({inner_geometry, edges_.add(inner[i], images.front())});
      outer_faces.push_back({outer_geometry, {}});
      outer_images.push_back(images.back());
    }
    for (std::size_t i = 0; i < outer.size(); ++i) {
      outer_faces[i].boundary = edges_.add(outer[i], outer_images[i]);
      faces_.push_back(outer_faces[i]);
    }
  }

  // The edges of one face only, with their counterparts. Between two points there is no wall.
  std::vector<std::pair<std::size_t, std::size_t>> free_edges() const {
    const std::size_t half = faces_.size() / 2;
    std::vector<int> uses(edges_.size());
    for (std::size_t face = 0; face < half; ++face) {
      for (const Run& run : runs(faces_[face].boundary)) ++uses[run.edge];
    }
    std::vector<std::pair<std::size_t, std::size_t>> result;
    for (std::size_t face = 0; face < half; ++face) {
      const std::vector<Run> inner = runs(faces_[face].boundary);
      const std::vector<Run> outer = runs(faces_[half + face].boundary);
      for (std::size_t i = 0; i < inner.size(); ++i) {
        const std::size_t start = inner[i].edge;
        const std::size_t end = outer[i].edge;
        const bool are_points = edges_.is_degenerate(start) && edges_.is_degenerate(end);
        if (uses[start] == 1 && !are_points) result.emplace_back(start, end);
      }
    }
    return result;
  }

  void add_wall(std::size_t start, std::size_t end) {
    const BoundaryCurve known = edges_.side_along(edges_.is_degenerate(start) ? end : start);
    const auto side = [&](std::size_t edge) {
      return edges_.is_degenerate(edge) ? standing_still(known, edges_.start_of(edge))
                                        : edges_.side_along(edge);
    };
    const BSplineSurface wall = ruled_surface(side(start), side(end));
    faces_.push_back({to_geometry(wall), edges_.add(wall, {})});
  }

  SharedEdges edges_;
  std::vector<BoundedSurface> faces_;
  bool has_walls_ = false;
};

bool correspond(const std::vector<BSplineSurface>& inner,
                const std::vector<BSplineSurface>& outer) {
  return std::equal(inner.begin(), inner.end(), outer.begin(), outer.end(),
                    [](const auto& a, const auto& b) { return have_equal_structure(a, b); });
}

// The solids with voids between as many closed shells.
std::vector<TopoDS_Solid> solids_with_voids(const std::vector<TopoDS_Shell>& inner,
                                            const std::vector<TopoDS_Shell>& outer) {
  if (inner.size() != outer.size()) {
    throw std::invalid_argument("The two surfaces do not have as many parts.");
  }
  std::vector<TopoDS_Solid> solids;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    solids.push_back(build_thick_solid(inner[i], outer[i]));
  }
  return solids;
}

std::vector<TopoDS_Solid> solids_between_others(const std::vector<BSplineSurface>& inner,
                                                const std::vector<BSplineSurface>& outer) {
  const auto is_open = [](const TopoDS_Shell& shell) { return !BRep_Tool::IsClosed(shell); };
  const std::vector<TopoDS_Shell> inner_shells = make_shells(inner);
  const std::vector<TopoDS_Shell> outer_shells = make_shells(outer);
  if (std::all_of(inner_shells.begin(), inner_shells.end(), is_open) &&
      std::all_of(outer_shells.begin(), outer_shells.end(), is_open)) {
    throw std::invalid_argument("The faces of the two open shells do not correspond.");
  }
  return solids_with_voids(inner_shells, outer_shells);
}

std::vector<TopoDS_Solid> solids_between(const std::vector<BSplineSurface>& inner,
                                         const std::vector<BSplineSurface>& outer) {
  if (!correspond(inner, outer)) return solids_between_others(inner, outer);
  const WalledFaces faces(inner, outer);
  const std::vector<TopoDS_Shell> shells = faces.shells();
  if (!faces.has_walls()) {
    const auto middle = shells.begin() + shells.size() / 2;
    return solids_with_voids({shells.begin(), middle}, {middle, shells.end()});
  }
  std::vector<TopoDS_Solid> solids;
  for (const TopoDS_Shell& shell : shells) solids.push_back(solid_inside(shell));
  return solids;
}

}  // namespace

TopoDS_Solid make_thick_solid(const TopoDS_Shell& inner, const TopoDS_Shell& outer) {
  return with_occt_errors([&] { return build_thick_solid(inner, outer); });
}

std::vector<TopoDS_Solid> make_thick_solids(const std::vector<BSplineSurface>& inner,
                                            const std::vector<BSplineSurface>& outer) {
  if (inner.empty() || outer.empty()) {
    throw std::invalid_argument("A solid between two surfaces needs both.");
  }
  return with_occt_errors([&] { return solids_between(inner, outer); });
}

TopoDS_Solid make_thick_solid(const std::vector<BSplineSurface>& inner,
                              const std::vector<BSplineSurface>& outer) {
  const std::vector<TopoDS_Solid> solids = make_thick_solids(inner, outer);
  if (solids.size() > 1) {
    throw std::invalid_argument("The faces do not hang together by common edges.");
  }
  return solids.front();
}

}  // namespace pn
