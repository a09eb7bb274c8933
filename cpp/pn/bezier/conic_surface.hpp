// SPDX-License-Identifier: LGPL-2.1-or-later
// Conic surfaces: what a moving ellipse covers, as one exact rational B-spline surface.
//
// THEOREM. Let three points b_i(t) of degrees f_i in homogeneous coordinates span the plane of the
// conic with the matrix C(t). With B(t) of rational_conic_family.hpp,
//
//     x(t, u) = b(t) B(t) (u0^2, u0 u1, u1^2)^T
//
// has bidegree (n, 2) and runs once through all points of all conics. (M. Peternell, dissertation
// TU Wien 1997, 1.1 to 1.5, where the degree in t is (12, 2) in the example for which (4, 2)
// suffices.)
//
// A conic with the matrix C is an ellipse, or a point, exactly if w^T adj(C) w > 0 for its line at
// infinity w.y = 0, decided over Q. The unit normals are not rational in general, so there are no
// exact offsets.
#pragma once

#include <array>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"
#include "pn/conics/moving_conic.hpp"

namespace pn {

class ConicSurface {
 public:
  /// Of the conics for t in [0, 1]. Throws GeometryError: kSingularConics, kNoRealPoints,
  /// kRegionUnbounded when a conic is no ellipse, kDegreeTooHigh, kWeightsNotPositive.
  explicit ConicSurface(const MovingConic& conic);

  /// (n, 2).
  std::array<int, 2> degree() const { return degree_; }
  /// In the order of t: u along t, over [0, 1] in all; v once around the ellipses over [0, 1]. One
  /// face unless the ellipses change so much that no even lines fit them all.
  const std::vector<BSplineSurface>& faces() const { return faces_; }
  /// Proven bound [mm] on the distance of the faces to the conics.
  double deviation() const { return deviation_; }

 private:
  std::array<int, 2> degree_;
  std::vector<BSplineSurface> faces_;
  double deviation_ = 0;
};

}  // namespace pn
