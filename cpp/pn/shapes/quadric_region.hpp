// SPDX-License-Identifier: LGPL-2.1-or-later
// Regions of quadrics: the part inside a box and a sector, and the arcs that bound it.
//
// The faces of the box and the half-planes of the sector meet a quadric in conics. Every conic is
// cut where it meets the other ones, and the arcs inside all other bounds, end to end, are the
// boundary. All this is done in doubles: it says where the edges of faces are, never where the
// surface is.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pn {

/// Points so near, relative to the region, are one: far above rounding, far below what is drawn.
inline constexpr double kSamePoint = 1e-9;

/// An interval of a coordinate, in millimetres or radians.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool is_bounded() const { return low > -HUGE_VAL && high < HUGE_VAL; }
};

/// Bounds of a base surface in standard position: a box, and a sector about the z-axis.
struct QuadricBounds {
  std::array<Interval, 3> box;
  std::optional<Interval> angle;
};

/// Throws GeometryError for bounds that are empty, inverted or not numbers.
void require_bounds(const QuadricBounds& bounds);

/// Whether a point is inside all bounds.
bool is_inside(const QuadricBounds& bounds, const Eigen::Vector3d& point);

/// A curve on a surface over [0, 1].
struct BoundaryConic {
  std::function<Eigen::Vector3d(double)> point;
  bool is_closed;
};

/// How a quadric meets planes: x_axis = value in a conic, if it does, and the half-plane at an
/// angle about the z-axis in half a conic that starts on the axis.
struct QuadricSections {
  std::function<std::optional<BoundaryConic>(std::size_t axis, double value)> plane;
  std::function<BoundaryConic(double angle)> half_plane;
};

using BoundaryLoop = std::vector<std::function<Eigen::Vector3d(double)>>;

/// The loops around the region inside the bounds; none where the bounds do not cut the surface.
/// `size` is that of the region [mm], for what counts as one point; arcs end at the `stops` that
/// they pass through.
std::vector<BoundaryLoop> boundary_loops(const QuadricBounds& bounds,
                                         const QuadricSections& sections, double size,
                                         const std::vector<Eigen::Vector3d>& stops);

}  // namespace pn
