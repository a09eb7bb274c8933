// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections of quadrics in standard position: the conics in the planes of bounds, and the points
// that a quadric has in common with two of these planes.
//
// A plane x_i = value meets x.(S x) + 2 h z + k = 0 in an ellipse, a hyperbola, a parabola or two
// lines, by the signs of what remains of S. Each branch is a curve over [0, 1] of which the inverse
// is known as well, so that a point computed once has its place on every conic through it. All
// this is in doubles: it says where the edges of faces are, never where the surface is.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

namespace pn {

/// An interval of a coordinate, in millimetres or radians.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool is_bounded() const { return low > -HUGE_VAL && high < HUGE_VAL; }
};

using Box = std::array<Interval, 3>;

/// x.(S x) + 2 half_linear z + constant = 0 with diagonal S.
struct QuadricEquation {
  Eigen::Vector3d square;
  double half_linear, constant;
  bool is_upper_sheet;  ///< only the part z > 0

  Eigen::Vector3d half_gradient(const Eigen::Vector3d& p) const {
    return square.cwiseProduct(p) + Eigen::Vector3d(0, 0, half_linear);
  }
};

/// The plane x_axis = value.
struct CoordinatePlane {
  std::size_t axis;
  double value;
};

/// The half-plane from the z-axis at this angle.
struct HalfPlane {
  double angle;
};

using BoundingPlane = std::variant<CoordinatePlane, HalfPlane>;

/// A curve on a surface over [0, 1], and the parameter of a point on it.
struct BoundaryConic {
  std::function<Eigen::Vector3d(double)> point;
  std::function<double(const Eigen::Vector3d&)> parameter;
  bool is_closed;
};

/// Planes that rise above a tangent plane by no more than this part of a surface's size touch it:
/// far above rounding, and not to be seen.
inline constexpr double kTouching = 1e-10;

/// The branches of the section by a plane; infinite ones as far as a box reaches, and a little
/// beyond. None where the plane misses the surface or touches it.
std::vector<BoundaryConic> section(const QuadricEquation& quadric, const BoundingPlane& plane,
                                   const Box& reach);

/// The point in which a plane touches the surface, if it does: two lines of its section may cross
/// there.
std::optional<Eigen::Vector3d> touching_point(const QuadricEquation& quadric,
                                              const BoundingPlane& plane, const Box& reach);

/// The points on two planes; none where the line in which they meet touches the surface or is the
/// same plane.
std::vector<Eigen::Vector3d> common_points(const QuadricEquation& quadric, const BoundingPlane& a,
                                           const BoundingPlane& b, double size);

}  // namespace pn
