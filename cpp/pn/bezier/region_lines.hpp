// SPDX-License-Identifier: LGPL-2.1-or-later
// Region lines: the lines u = const over a bounded region of one link.
//
// Where the region surrounds or touches a pole of the parametrization, where all circles shrink to
// a point, or goes around between two, the circles are taken whole, by two faces that meet along
// two lines u = const, so that no face has both a seam and a pole: OpenCASCADE's checks take the
// one running into the other for a self-intersection. Such lines are constant, which costs no
// degree. Any other region is a face over an arc of the circles.
//
// On a two-sheet hyperboloid a circle that reaches far enough from its umbilic touches infinity in
// two points and runs on between them over the other sheet. Beyond a `split` before that happens
// the region lies on an arc that narrows from circle to circle, and only the larger of the two
// faces goes on. Its lines have to narrow with the region: they turn with t.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>
#include <vector>

#include "pn/bezier/target_lines.hpp"
#include "pn/isotropic/envelope_chain.hpp"

namespace pn {

/// A point of the boundary: the parameter of its circle, and the angle of its direction (u0, u1) in
/// the columns of A.
struct BoundaryPlace {
  double t, angle;
};

/// What a region takes of the circles of its link.
struct RegionCircles {
  double low, high;             ///< in the link's parameter; 0 or 1 exactly at a pole
  bool is_closed;               ///< the circles are taken whole
  std::optional<double> split;  ///< up to here; beyond, arcs of them
  /// Of the boundary where arcs are taken, densely; all angles within half a turn.
  std::vector<BoundaryPlace> boundary;
};

/// All loops of the region are lines t = const, as parallels on a quadric of revolution are: then
/// the faces end there and need no trims.
bool is_bounded_by_parallels(const BoundedRegion& region);

/// For the link of a region, which carries no rulings. Throws GeometryError for a region that lies
/// on both sides of where circles reach infinity.
RegionCircles region_circles(const BoundedRegion& region,
                             const IsotropicHypersurface<double>& gamma);

/// An arc of a circle that holds what a region has of it: the angles of its ends.
struct CircleArc {
  double low, high;
};

/// The arcs of all circles, by their parameter.
using ArcOf = std::function<CircleArc(double t)>;

/// The same for all circles, for constant lines.
ArcOf constant_arc(const RegionCircles& circles);
/// Between the lines that support the boundary in its middle, for linear lines.
ArcOf tapering_arc(const RegionCircles& circles);
/// What lies a tenth of the region's length ahead and behind, or a thirtieth.
ArcOf following_arc(const RegionCircles& circles);
ArcOf closely_following_arc(const RegionCircles& circles);

class RegionLines : public TargetLines {
 public:
  /// `margin` goes beyond the boundary, as a part of the arc.
  RegionLines(IsotropicHypersurface<double> gamma, RegionCircles circles, ArcOf arc, double margin);

 private:
  Eigen::Matrix2d factor(std::size_t link, double t) const override;

  IsotropicHypersurface<double> gamma_;
  RegionCircles circles_;
  ArcOf arc_;
  double margin_;
};

}  // namespace pn
