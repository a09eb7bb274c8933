// SPDX-License-Identifier: LGPL-2.1-or-later
// Normal patches: the Bezier pieces of a surface together with its unit normals, in doubles.
//
// A section of the isotropic hypersurface and its normals have the same weights, so both are one
// rational map (w x : w n : w) into R^6. A piece of it is bounded by its control points:
//
//   - x is in the convex hull of the poles P, and n in that of the poles N of the normals. Since
//   |n|
//     = 1, n is at most acos(min N.e) from a unit vector e.
//   - With A = w (P - c) for any point c, w x_u = A_u - w_u (x - c), so w x_u is at most p max|dw|
//     max|P - c| from the convex hull of the differences p dA of neighbouring A; and so for v.
//
// The second bound is as near as the first: halving a piece halves dw and |P - c|.
//
// The normals of a surface that has no rational ones are those of its derivatives, in the cone of
// direction_cone.hpp around the cross products.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <vector>

#include "pn/algebra/multivariate_polynomial.hpp"
#include "pn/bezier/bspline_surface.hpp"
#include "pn/bezier/direction_cone.hpp"

namespace pn {

/// A point of a surface with its derivatives and its unit normal.
struct SurfaceJet {
  Eigen::Vector3d point, u, v, normal;
};

/// What the normals of a patch are.
enum class Normals {
  kRational,       ///< those in its control points
  kOfDerivatives,  ///< x_u x x_v; the control points hold none
};

class NormalPatch {
 public:
  /// For each row along the control points (w x, w n, w), one after the other.
  using Net = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  static constexpr Eigen::Index kComponents = 7;

  NormalPatch(Net net, Normals normals);

  int degree(Variable variable) const;
  /// At parameters in [0, 1]; nearby ones continue the polynomials.
  SurfaceJet at(double u, double v) const;
  std::array<NormalPatch, 2> halved(Variable variable) const;

  /// The poles P, one a column.
  const Eigen::Matrix3Xd& poles() const { return poles_; }
  /// Cones that contain the normals, and the derivatives; none where the control points give none.
  std::optional<DirectionCone> normal_cone() const;
  std::optional<DirectionCone> tangent_cone(Variable variable) const;
  /// How long the lines of this variable are, and how far [rad] the normals turn along them, at
  /// most: by their control polygons. Zero for normals of derivatives.
  double length(Variable variable) const { return longest_line(poles_, variable); }
  double turn(Variable variable) const { return longest_line(normals_, variable); }

 private:
  Eigen::Index rows() const { return net_.rows(); }
  Eigen::Index columns() const { return net_.cols() / kComponents; }
  Eigen::Index count(Variable variable) const {
    return variable == Variable::kU ? rows() : columns();
  }
  /// Where the pole (i, j) is among all of them, and how far away its neighbour along a variable.
  Eigen::Index place(Eigen::Index i, Eigen::Index j) const { return i * columns() + j; }
  Eigen::Index stride(Variable variable) const { return variable == Variable::kU ? columns() : 1; }
  double longest_line(const Eigen::Matrix3Xd& points, Variable variable) const;
  double weight(Eigen::Index i, Eigen::Index j) const { return net_(i, kComponents * j + 6); }

  Net net_;
  Normals normals_are_;
  Eigen::Matrix3Xd poles_, normals_;
};

/// The pieces between neighbouring knots, row by row along u. `normal` has the knots and weights of
/// `surface`, and unit vectors as its points.
std::vector<NormalPatch> normal_patches(const BSplineSurface& surface,
                                        const BSplineSurface& normal);
/// The same with the normals of the derivatives.
std::vector<NormalPatch> normal_patches(const BSplineSurface& surface);

}  // namespace pn
