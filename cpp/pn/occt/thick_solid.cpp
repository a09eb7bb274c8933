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

// A point as a curve over the knots of another one.
BoundaryCurve standing_still(BoundaryCurve curve, const std::array<double, 3>& point) {
  std::fill(curve.poles.begin(), curve.poles.end(), point);
  return curve;
}

bool correspond(const std::vector<BSplineSurface>& inner,
                const std::vector<BSplineSurface>& outer) {
  return std::equal(inner.begin(), inner.end(), outer.begin(), outer.end(),
                    [](const auto& a, const auto& b) { return have_equal_structure(a, b); });
}

// The images of the trims of each face.
using Images = std::vector<TrimImages>;

Images images_of(const std::vector<BSplineSurface>& surfaces) {
  Images images;
  for (const BSplineSurface& surface : surfaces) {
    images.push_back(trim_images(surface, {to_geometry(surface)}).front());
  }
  return images;
}

// The same for two offsets: over the same knots where trims correspond.
std::pair<Images, Images> images_of(const std::vector<BSplineSurface>& inner,
                                    const std::vector<BSplineSurface>& outer) {
  if (!correspond(inner, outer)) return {images_of(inner), images_of(outer)};
  std::pair<Images, Images> images;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const auto both = trim_images(inner[i], {to_geometry(inner[i]), to_geometry(outer[i])});
    images.first.push_back(both.front());
    images.second.push_back(both.back());
  }
  return images;
}

// The faces of two shells and, one after the other, the walls between them.
class WalledFaces {
 public:
  WalledFaces(const std::vector<BSplineSurface>& inner, const std::vector<BSplineSurface>& outer) {
    const auto [inner_images, outer_images] = images_of(inner, outer);
    const std::vector<std::size_t> starts = free_edges(add(inner, inner_images));
    const std::vector<std::size_t> ends = free_edges(add(outer, outer_images));
    has_walls_ = is_open(starts);
    if (has_walls_ != is_open(ends)) {
      throw std::invalid_argument("A thick solid needs closed shells, and one of the two is open.");
    }
    if (has_walls_) add_walls(starts, ends);
  }

  bool has_walls() const { return has_walls_; }

  std::vector<TopoDS_Shell> shells() const { return make_shells(edges_, faces_); }

 private:
  // The boundaries of the faces.
  std::vector<FaceBoundary> add(const std::vector<BSplineSurface>& surfaces, const Images& images) {
    std::vector<FaceBoundary> boundaries;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      boundaries.push_back(edges_.add(surfaces[i], images[i]));
      faces_.push_back({to_geometry(surfaces[i]), boundaries.back()});
    }
    return boundaries;
  }

  // The edges that one face only runs: of every first run those in the order of the faces, then of
  // every second. So the ends of a pipe come in the same order, however many faces it has.
  std::vector<std::size_t> free_edges(const std::vector<FaceBoundary>& boundaries) const {
    std::vector<std::pair<std::size_t, std::size_t>> edges_at;
    std::vector<int> uses(edges_.size());
    for (const FaceBoundary& boundary : boundaries) {
      const std::vector<Run> around = runs(boundary);
      for (std::size_t i = 0; i < around.size(); ++i) {
        edges_at.emplace_back(i, around[i].edge);
        ++uses[around[i].edge];
      }
    }
    std::stable_sort(edges_at.begin(), edges_at.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::size_t> result;
    for (const auto& [place, edge] : edges_at) {
      if (uses[edge] == 1) result.push_back(edge);
    }
    return result;
  }

  // Points leave no shell open.
  bool is_open(const std::vector<std::size_t>& free_edges) const {
    return std::any_of(free_edges.begin(), free_edges.end(),
                       [&](std::size_t edge) { return !edges_.is_degenerate(edge); });
  }

  void add_walls(const std::vector<std::size_t>& starts, const std::vector<std::size_t>& ends) {
    if (starts.size() != ends.size()) {
      throw std::invalid_argument("The two open shells do not have as many free edges.");
    }
    for (std::size_t i = 0; i < starts.size(); ++i) {
      // Between two points there is no wall.
      if (!edges_.is_degenerate(starts[i]) || !edges_.is_degenerate(ends[i])) {
        add_wall(starts[i], ends[i]);
      }
    }
  }

  void add_wall(std::size_t start, std::size_t end) {
    const BoundaryCurve known = edges_.side_along(edges_.is_degenerate(start) ? end : start);
    const auto side = [&](std::size_t edge) {
      return edges_.is_degenerate(edge) ? standing_still(known, edges_.start_of(edge))
                                        : edges_.side_along(edge);
    };
    const BoundaryCurve from = side(start);
    const BoundaryCurve to = side(end);
    if (!have_equal_structure(from, to)) {
      throw std::invalid_argument("The free edges of the two open shells do not correspond.");
    }
    const BSplineSurface wall = ruled_surface(from, to);
    faces_.push_back({to_geometry(wall), edges_.add(wall, {})});
  }

  SharedEdges edges_;
  std::vector<BoundedSurface> faces_;
  bool has_walls_ = false;
};

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

std::vector<TopoDS_Solid> solids_between(const std::vector<BSplineSurface>& inner,
                                         const std::vector<BSplineSurface>& outer) {
  const WalledFaces faces(inner, outer);
  if (!faces.has_walls()) return solids_with_voids(make_shells(inner), make_shells(outer));
  std::vector<TopoDS_Solid> solids;
  for (const TopoDS_Shell& shell : faces.shells()) solids.push_back(solid_inside(shell));
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
