// SPDX-License-Identifier: LGPL-2.1-or-later
// Planar triangulations: triangles that meet in whole edges and common corners only, over Q.
//
// Two triangles have no inner point in common exactly when the line through an edge of one of them
// has the other one on its outer side (separating axes of convex polygons).
#pragma once

#include <array>
#include <vector>

#include "pn/algebra/directed_edges.hpp"
#include "pn/isotropic/family_spline.hpp"

namespace pn {

class PlanarTriangulation {
 public:
  /// Throws GeometryError: no triangle, a number of no point, a point that is not finite, a
  /// triangle without area or that runs clockwise, an edge of three triangles, triangles that
  /// overlap, a corner on the edge of another triangle. Points of no triangle take no part.
  PlanarTriangulation(const std::vector<std::array<double, 2>>& points,
                      std::vector<Triangle> triangles);

  const std::vector<PlanePoint>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  std::array<PlanePoint, 3> corners(std::size_t triangle) const;

 private:
  void check_triangles() const;
  void check_edges() const;
  void check_pairs() const;
  void check_pair(std::size_t a, std::size_t b) const;

  std::vector<PlanePoint> points_;
  std::vector<Triangle> triangles_;
};

}  // namespace pn
