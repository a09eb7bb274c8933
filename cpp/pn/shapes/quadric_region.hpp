// SPDX-License-Identifier: LGPL-2.1-or-later
// Regions of quadrics: the part inside a box and a sector, and the arcs that bound it.
//
// The faces of the box and the half-planes of the sector meet a quadric in conics
// (quadric_sections.hpp). The points that lie on two of them are computed once and cut all conics
// through them. An arc between two cuts bounds the region when just one of its sides is inside all
// bounds: so bounds that touch the surface, each other, or coincide are as good as others. Arcs end
// to end are the loops.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pn/shapes/quadric_sections.hpp"

namespace pn {

/// Points so near, relative to the region, are one: far above rounding, far below what is drawn.
inline constexpr double kSamePoint = 1e-9;

/// Bounds of a base surface in standard position: a box, and a sector about the z-axis.
struct QuadricBounds {
  Box box;
  std::optional<Interval> angle;
};

/// Throws GeometryError for bounds that are empty, inverted or not numbers.
void require_bounds(const QuadricBounds& bounds);

/// Whether a point is inside all bounds.
bool is_inside(const QuadricBounds& bounds, const Eigen::Vector3d& point);

/// A quadric as its regions see it.
struct TracedQuadric {
  QuadricEquation equation;
  Box extent;                          ///< of the whole surface
  Box reach;                           ///< a bounded box that holds the region
  std::vector<Eigen::Vector3d> stops;  ///< arcs end at these points

  double size() const;
};

/// The bounds that cut the surface; the others hold everywhere and are left out. Throws
/// GeometryError for one that leaves nothing.
QuadricBounds effective_bounds(const QuadricBounds& bounds, const TracedQuadric& quadric);

/// Whether they leave the whole surface.
bool are_none(const QuadricBounds& bounds);

using RegionLoop = std::vector<std::function<Eigen::Vector3d(double)>>;

/// The loops around the region inside effective bounds. Throws GeometryError when it touches itself
/// in a point.
std::vector<RegionLoop> region_loops(const QuadricBounds& bounds, const TracedQuadric& quadric);

}  // namespace pn
