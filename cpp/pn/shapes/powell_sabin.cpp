// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/powell_sabin.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "pn/algebra/parallel.hpp"
#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"
#include "pn/shapes/sphere_spans.hpp"

namespace pn {
namespace {

using Vector = MinkowskiVector<Rational>;

/// The weights of an inner point are rounded to this part of their sum, so that the numbers stay
/// short.
constexpr double kWeightUnits = 1 << 12;

/// The weighted sum of points or of vectors.
template <class Point, std::size_t Count>
Point combined(const std::array<Point, Count>& points, const std::array<Rational, Count>& weights) {
  Point sum;
  for (std::size_t i = 0; i < Count; ++i) {
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += weights[i] * points[i][c];
  }
  return sum;
}

/// The barycentric coordinates of a short point near the centre of the inscribed circle.
std::array<Rational, 3> inner_weights(const std::array<PlanePoint, 3>& corners) {
  std::array<double, 3> opposite;
  for (std::size_t i = 0; i < 3; ++i) {
    const PlanePoint &a = corners[(i + 1) % 3], &b = corners[(i + 2) % 3];
    opposite[i] = std::hypot((b[0] - a[0]).to_double(), (b[1] - a[1]).to_double());
  }
  const double sum = opposite[0] + opposite[1] + opposite[2];
  std::array<Rational, 3> weights;
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = Rational::exactly(std::max(1.0, std::round(opposite[i] / sum * kWeightUnits)));
  }
  const Rational total = weights[0] + weights[1] + weights[2];
  for (Rational& weight : weights) weight /= total;
  return weights;
}

/// T((P + Q) / 2) for the tangent plane T at P.
Vector towards(const VertexJet& jet, const PlanePoint& from, const PlanePoint& to) {
  const Rational half = Rational(1L) / Rational(2L);
  return combined(std::array{jet.value, jet.by_s, jet.by_t},
                  std::array{Rational(1L), half * (to[0] - from[0]), half * (to[1] - from[1])});
}

/// A split of all triangles into six.
class Split {
 public:
  explicit Split(const PlanarTriangulation& triangulation)
      : triangulation_(triangulation),
        edges_(triangulation.triangles()),
        corners_(triangulation.points()) {
    for (std::size_t t = 0; t < triangulation.triangles().size(); ++t) {
      weights_.push_back(inner_weights(triangulation.corners(t)));
      corners_.push_back(combined(triangulation.corners(t), weights_.back()));
    }
    for (std::size_t t = 0; t < triangulation.triangles().size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) add_edge_point({t, k});
    }
  }

  const std::vector<PlanePoint>& corners() const { return corners_; }

  /// The barycentric coordinates and the number of the inner point of a triangle.
  const std::array<Rational, 3>& inner_weights_of(std::size_t triangle) const {
    return weights_[triangle];
  }
  std::size_t inner_point(std::size_t triangle) const {
    return triangulation_.points().size() + triangle;
  }

  /// The number of the point on an edge, and how far it is from the first end to the second one.
  std::size_t edge_point(const TriangleEdge& edge) const {
    return edge_points_.at({edge.triangle, edge.edge});
  }
  Rational part(const TriangleEdge& edge) const {
    const auto [a, b] = ends(edge);
    const auto neighbour = edges_.opposite(edge);
    if (!neighbour) return Rational(1L) / Rational(2L);
    const PlanePoint &z = corners_[inner_point(edge.triangle)],
                     &other = corners_[inner_point(neighbour->triangle)];
    // Both are positive where a and b lie on either side of the line.
    const Rational at_a = orientation(z, other, a), at_b = -orientation(z, other, b);
    if (at_a.sign() * at_b.sign() <= 0) {
      throw GeometryError(ErrorCode::kNotATriangulation,
                          "The triangles " + std::to_string(edge.triangle) + " and " +
                              std::to_string(neighbour->triangle) +
                              " are too thin: the line between their middles misses the common "
                              "edge.");
    }
    return at_a / (at_a + at_b);
  }

 private:
  std::array<PlanePoint, 2> ends(const TriangleEdge& edge) const {
    const auto corners = triangulation_.corners(edge.triangle);
    return {corners[edge.edge], corners[(edge.edge + 1) % 3]};
  }

  void add_edge_point(const TriangleEdge& edge) {
    const auto neighbour = edges_.opposite(edge);
    if (neighbour && neighbour->triangle < edge.triangle) {
      edge_points_[{edge.triangle, edge.edge}] = edge_point(*neighbour);
      return;
    }
    const Rational at = part(edge);
    edge_points_[{edge.triangle, edge.edge}] = corners_.size();
    corners_.push_back(combined(ends(edge), std::array{Rational(1L) - at, at}));
  }

  const PlanarTriangulation& triangulation_;
  DirectedEdges edges_;
  std::vector<PlanePoint> corners_;
  std::vector<std::array<Rational, 3>> weights_;
  std::map<std::array<std::size_t, 2>, std::size_t> edge_points_;
};

/// The six pieces of a triangle, two on each edge, counterclockwise.
std::vector<FamilyPiece> pieces_of(const Split& split, const PlanarTriangulation& triangulation,
                                   const std::vector<VertexJet>& jets, std::size_t t) {
  const Triangle& triangle = triangulation.triangles()[t];
  const std::vector<PlanePoint>& place = split.corners();
  const std::size_t z = split.inner_point(t);
  const auto control = [&](std::size_t corner, std::size_t to) {
    return towards(jets[corner], place[corner], place[to]);
  };
  const std::array<Vector, 3> at_z = {control(triangle[0], z), control(triangle[1], z),
                                      control(triangle[2], z)};
  const Vector middle = combined(at_z, split.inner_weights_of(t));
  std::vector<FamilyPiece> pieces;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = triangle[k], b = triangle[(k + 1) % 3], r = split.edge_point({t, k});
    const Rational part = split.part({t, k});
    const std::array<Rational, 2> weights = {Rational(1L) - part, part};
    const Vector &a_z = at_z[k], &b_z = at_z[(k + 1) % 3];
    const Vector a_r = control(a, r), b_r = control(b, r);
    const Vector at_r = combined(std::array{a_r, b_r}, weights),
                 r_z = combined(std::array{a_z, b_z}, weights);
    pieces.push_back({QuadraticFamily({jets[a].value, a_r, at_r, a_z, r_z, middle}), {z, a, r}, t});
    pieces.push_back({QuadraticFamily({at_r, b_r, jets[b].value, r_z, b_z, middle}), {z, r, b}, t});
  }
  return pieces;
}

Vector minkowski_vector(const std::array<double, 4>& sphere) {
  require_input_numbers(sphere, "A number of a point, a radius or a derivative");
  return {Rational::exactly(sphere[0]), Rational::exactly(sphere[1]), Rational::exactly(sphere[2]),
          -Rational::exactly(sphere[3])};
}

std::vector<VertexJet> jets_of(const std::vector<PlacedSphere>& spheres) {
  std::vector<VertexJet> jets;
  for (const PlacedSphere& placed : spheres) {
    jets.push_back({minkowski_vector(placed.sphere), minkowski_vector(placed.derivatives[0]),
                    minkowski_vector(placed.derivatives[1])});
  }
  return jets;
}

void require_envelope(const FamilySpline& spline) {
  for_each_index(spline.pieces.size(), [&](std::size_t i) {
    const FamilyPiece& piece = spline.pieces[i];
    const auto place = unreal_place(piece.family);
    if (!place) return;
    const auto coordinate = [&](std::size_t c) {
      const auto [u, v] = *place;
      const auto [at_w, at_u, at_v] = piece.corners;
      return u * spline.corners[at_u][c].to_double() + v * spline.corners[at_v][c].to_double() +
             (1 - u - v) * spline.corners[at_w][c].to_double();
    };
    throw GeometryError(ErrorCode::kRadiusTooSteep,
                        "The spheres have no envelope over triangle " +
                            std::to_string(piece.designers_triangle) + ", near the parameter (" +
                            show(coordinate(0)) + ", " + show(coordinate(1)) +
                            "): the radius changes at least as fast as the centre moves, or the "
                            "mid-surface has no tangent plane there.");
  });
}

bool has_constant_radius(const FamilySpline& spline) {
  const Rational& first = spline.pieces.front().family.control().front()[3];
  return std::all_of(spline.pieces.begin(), spline.pieces.end(), [&](const FamilyPiece& piece) {
    const auto& control = piece.family.control();
    return std::all_of(control.begin(), control.end(),
                       [&](const Vector& sphere) { return sphere[3] == first; });
  });
}

}  // namespace

FamilySpline powell_sabin(const PlanarTriangulation& triangulation,
                          const std::vector<VertexJet>& jets) {
  const Split split(triangulation);
  FamilySpline spline{split.corners(), {}};
  for (std::size_t t = 0; t < triangulation.triangles().size(); ++t) {
    for (FamilyPiece& piece : pieces_of(split, triangulation, jets, t)) {
      spline.pieces.push_back(std::move(piece));
    }
  }
  return spline;
}

PowellSabinFamily powell_sabin_family(const std::vector<PlacedSphere>& spheres,
                                      const std::vector<Triangle>& triangles) {
  std::vector<std::array<double, 2>> parameters;
  for (const PlacedSphere& placed : spheres) parameters.push_back(placed.parameter);
  const std::vector<VertexJet> jets = jets_of(spheres);
  PowellSabinFamily result{powell_sabin(PlanarTriangulation(parameters, triangles), jets), {}};
  require_envelope(result.spline);
  if (has_constant_radius(result.spline)) {
    result.notes.emplace_back("All radii are equal: the skins are the offsets of the mid-surface.");
  }
  return result;
}

}  // namespace pn
