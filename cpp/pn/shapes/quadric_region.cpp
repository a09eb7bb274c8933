// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric_region.hpp"

#include <algorithm>
#include <cmath>

#include "pn/geometry_error.hpp"
#include "pn/shapes/sphere_spans.hpp"

namespace pn {
namespace {

using Eigen::Vector3d;
using Curve = std::function<Vector3d(double)>;

/// The sides of an arc are looked at this near to it, as a part of the size: well below the height
/// at which a bound no longer touches, well above rounding.
constexpr double kAside = 1e-12;
/// For the direction of an arc at its middle.
constexpr double kStep = 1e-6;

double angle_from(double start, const Vector3d& p) {
  const double turn = std::remainder(std::atan2(p.y(), p.x()) - start, 2 * M_PI);
  return turn < 0 ? turn + 2 * M_PI : turn;
}

Curve part(const Curve& curve, double begin, double end) {
  return [=](double t) { return curve(begin + t * (end - begin)); };
}

/// Where a conic passes through a corner.
struct Cut {
  double at;
  std::size_t corner;
};

/// A part of a conic between two corners, or all of a closed one that has none.
struct Arc {
  Curve curve;
  std::optional<std::size_t> start, finish;
};

/// The arcs of a conic between its cuts. A closed one runs on through its start; the ends of an
/// open one lie outside of the region or are cuts.
std::vector<Arc> arcs_between(const BoundaryConic& conic, std::vector<Cut> cuts) {
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.at < b.at; });
  std::vector<Arc> arcs;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    arcs.push_back(
        {part(conic.point, cuts[i].at, cuts[i + 1].at), cuts[i].corner, cuts[i + 1].corner});
  }
  if (!conic.is_closed) return arcs;
  if (cuts.empty()) return {{conic.point, {}, {}}};
  const Curve around = [point = conic.point](double t) { return point(t - std::floor(t)); };
  arcs.push_back(
      {part(around, cuts.back().at, cuts.front().at + 1), cuts.back().corner, cuts.front().corner});
  return arcs;
}

std::vector<BoundingPlane> planes_of(const QuadricBounds& bounds) {
  std::vector<BoundingPlane> planes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double value : {bounds.box[axis].low, bounds.box[axis].high}) {
      if (std::isfinite(value)) planes.push_back(CoordinatePlane{axis, value});
    }
  }
  if (!bounds.angle) return planes;
  for (const double angle : {bounds.angle->low, bounds.angle->high}) {
    planes.push_back(HalfPlane{angle});
  }
  return planes;
}

class RegionTracer {
 public:
  RegionTracer(const QuadricBounds& bounds, const TracedQuadric& quadric)
      : bounds_(bounds),
        quadric_(quadric),
        planes_(planes_of(bounds)),
        tolerance_(kSamePoint * quadric.size()) {
    for (const Vector3d& stop : quadric.stops) add_corner(stop);
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (const Vector3d& p :
             common_points(quadric.equation, planes_[i], planes_[j], quadric.size())) {
          add_corner(p);
        }
      }
    }
  }

  std::vector<BoundaryLoop> loops() {
    std::vector<Arc> arcs;
    for (const BoundingPlane& plane : planes_) {
      for (const BoundaryConic& conic : section(quadric_.equation, plane, quadric_.reach)) {
        for (const Arc& arc : arcs_between(conic, cuts(conic))) {
          if (is_boundary(arc) && !is_among(arcs, arc)) arcs.push_back(arc);
        }
      }
    }
    return joined(std::move(arcs));
  }

 private:
  bool is_same(const Vector3d& a, const Vector3d& b) const { return (a - b).norm() < tolerance_; }

  void add_corner(const Vector3d& p) {
    const bool is_known = std::any_of(corners_.begin(), corners_.end(),
                                      [&](const Vector3d& corner) { return is_same(corner, p); });
    if (!is_known) corners_.push_back(p);
  }

  std::vector<Cut> cuts(const BoundaryConic& conic) const {
    std::vector<Cut> cuts;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const double at = conic.parameter(corners_[i]);
      if (is_same(conic.point(at), corners_[i])) cuts.push_back({at, i});
    }
    return cuts;
  }

  /// Just one side of it is in the region.
  bool is_boundary(const Arc& arc) const {
    const Vector3d p = arc.curve(0.5);
    const Vector3d along = arc.curve(0.5 + kStep) - arc.curve(0.5 - kStep);
    const Vector3d aside =
        kAside * quadric_.size() * quadric_.equation.half_gradient(p).cross(along).normalized();
    return is_inside(bounds_, p + aside) != is_inside(bounds_, p - aside);
  }

  /// Bounds that coincide have their arcs in common.
  bool is_among(const std::vector<Arc>& arcs, const Arc& arc) const {
    return std::any_of(arcs.begin(), arcs.end(), [&](const Arc& other) {
      const bool has_same_ends = (other.start == arc.start && other.finish == arc.finish) ||
                                 (other.start == arc.finish && other.finish == arc.start);
      return has_same_ends && is_same(other.curve(0.5), arc.curve(0.5));
    });
  }

  /// The arcs end to end.
  static std::vector<BoundaryLoop> joined(std::vector<Arc> arcs) {
    std::vector<BoundaryLoop> loops;
    while (!arcs.empty()) {
      const auto first = arcs.back().start;
      auto end = arcs.back().finish;
      BoundaryLoop loop = {arcs.back().curve};
      arcs.pop_back();
      while (end != first) {
        const auto goes_on = [&](const Arc& arc) { return arc.start == end || arc.finish == end; };
        const auto next = std::find_if(arcs.begin(), arcs.end(), goes_on);
        require_single(next != arcs.end());
        require_single(std::find_if(next + 1, arcs.end(), goes_on) == arcs.end());
        const bool runs_on = next->start == end;
        loop.push_back(runs_on ? next->curve : part(next->curve, 1, 0));
        end = runs_on ? next->finish : next->start;
        arcs.erase(next);
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  static void require_single(bool goes_on_once) {
    if (goes_on_once) return;
    throw GeometryError(ErrorCode::kRegionUnsupported,
                        "The region touches itself in a point; move one of the bounds there a "
                        "little.");
  }

  const QuadricBounds& bounds_;
  const TracedQuadric& quadric_;
  std::vector<BoundingPlane> planes_;
  double tolerance_;
  std::vector<Vector3d> corners_;
};

void require_interval(const Interval& interval, const char* name) {
  if (std::isnan(interval.low) || std::isnan(interval.high)) {
    throw GeometryError(ErrorCode::kNotFinite,
                        std::string("A bound of ") + name + " is not a number.");
  }
  if (interval.low < interval.high) return;
  throw GeometryError(ErrorCode::kBadBounds, std::string("The bounds of ") + name +
                                                 " are empty: from " + show(interval.low) + " to " +
                                                 show(interval.high) + ".");
}

}  // namespace

void require_bounds(const QuadricBounds& bounds) {
  require_interval(bounds.box[0], "x");
  require_interval(bounds.box[1], "y");
  require_interval(bounds.box[2], "z");
  if (!bounds.angle) return;
  require_interval(*bounds.angle, "the angle");
  if (bounds.angle->is_bounded()) return;
  throw GeometryError(ErrorCode::kBadBounds, "The bounds of the angle must be finite.");
}

bool is_inside(const QuadricBounds& bounds, const Vector3d& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = point(static_cast<Eigen::Index>(axis));
    if (x < bounds.box[axis].low || x > bounds.box[axis].high) return false;
  }
  if (!bounds.angle) return true;
  return angle_from(bounds.angle->low, point) <= bounds.angle->high - bounds.angle->low;
}

double TracedQuadric::size() const {
  double size = 0;
  for (const Interval& interval : reach) {
    size = std::max({size, std::abs(interval.low), std::abs(interval.high)});
  }
  return size;
}

QuadricBounds effective_bounds(const QuadricBounds& bounds, const TracedQuadric& quadric) {
  QuadricBounds result = bounds;
  const double least = kTouching * quadric.size();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Interval& interval = result.box[axis];
    const Interval& extent = quadric.extent[axis];
    if (interval.low >= extent.high - least || interval.high <= extent.low + least) {
      throw GeometryError(ErrorCode::kRegionEmpty, "The bounds miss the surface.");
    }
    if (interval.low <= extent.low + least) interval.low = -HUGE_VAL;
    if (interval.high >= extent.high - least) interval.high = HUGE_VAL;
  }
  if (bounds.angle && bounds.angle->high - bounds.angle->low >= 2 * M_PI - kSamePoint) {
    result.angle.reset();
  }
  return result;
}

bool are_none(const QuadricBounds& bounds) { return !bounds.angle && planes_of(bounds).empty(); }

std::vector<BoundaryLoop> boundary_loops(const QuadricBounds& bounds,
                                         const TracedQuadric& quadric) {
  return RegionTracer(bounds, quadric).loops();
}

}  // namespace pn
