// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric_region.hpp"

#include <algorithm>
#include <cmath>

#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"
#include "pn/shapes/sphere_spans.hpp"

namespace pn {
namespace {

using Eigen::Vector3d;
using Curve = std::function<Vector3d(double)>;

/// The sides of an arc are looked at this near to it, as a part of the size: well below the height
/// at which a bound no longer touches, well above rounding.
constexpr double kAside = 1e-12;
/// A sector that leaves out less than a slit of this kind goes all around: its angles were rounded.
constexpr double kFullTurn = 2 * M_PI - 1e-8;
/// For the direction of an arc.
constexpr double kStep = 1e-6;

double angle_from(double start, const Vector3d& p) {
  const double turn = std::remainder(std::atan2(p.y(), p.x()) - start, 2 * M_PI);
  return turn < 0 ? turn + 2 * M_PI : turn;
}

Curve part(const Curve& curve, double begin, double end) {
  return [=](double t) { return curve(begin + t * (end - begin)); };
}

/// The part of a closed curve over [0, 1] that may run on through its start.
Curve around(const Curve& curve, double begin, double end) {
  return part([=](double t) { return curve(t - std::floor(t)); }, begin, end);
}

/// Where on a curve it is nearest to a point.
double nearest(const Curve& curve, const Vector3d& point) {
  constexpr int kSamples = 64;
  const auto distance = [&](double t) { return (curve(t) - point).squaredNorm(); };
  int best = 0;
  for (int i = 1; i <= kSamples; ++i) {
    if (distance(1.0 * i / kSamples) < distance(1.0 * best / kSamples)) best = i;
  }
  double low = std::max(0, best - 1) / (1.0 * kSamples),
         high = std::min(kSamples, best + 1) / (1.0 * kSamples);
  constexpr int kThirds = 60;
  for (int i = 0; i < kThirds; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
  }
  return (low + high) / 2;
}

/// A curve that passes near a point, at a parameter that grows with the distance from it: beside a
/// pole of the parametrization, directions turn as fast as the point goes by.
Curve slowed_beside(const Vector3d& point, const Curve& curve) {
  constexpr double kNear = 0.1;
  const double at = nearest(curve, point);
  const double before = std::max(0.0, at - kStep), after = std::min(1.0, at + kStep);
  const double speed = (curve(after) - curve(before)).norm() / (after - before);
  const double width = (curve(at) - point).norm() / speed;
  if (!(width > kSamePoint && width < kNear)) return curve;
  const double first = std::asinh(-at / width), last = std::asinh((1 - at) / width);
  return [=](double t) {
    return curve(std::clamp(at + width * std::sinh(first + t * (last - first)), 0.0, 1.0));
  };
}

/// A closed curve over [0, 1], starting elsewhere.
Curve started_far_from(const std::vector<Vector3d>& points, const Curve& curve) {
  constexpr int kPlaces = 16;
  const auto distance = [&](int place) {
    double least = HUGE_VAL;
    for (const Vector3d& p : points) {
      least = std::min(least, (curve(1.0 * place / kPlaces) - p).norm());
    }
    return least;
  };
  int farthest = 0;
  for (int i = 1; i < kPlaces; ++i) {
    if (distance(i) > distance(farthest)) farthest = i;
  }
  return around(curve, 1.0 * farthest / kPlaces, 1.0 * farthest / kPlaces + 1);
}

/// Points that count as one: every conic through one of them ends there.
using Corner = std::vector<Vector3d>;
/// They are so many times as far apart as what passes through a point.
constexpr double kCornerSize = 8;

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
    for (const Vector3d& stop : quadric.stops) add_corner_at(stop);
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const auto touching = touching_point(quadric.equation, planes_[i], quadric.reach);
      if (touching) add_corner_at(*touching);
      for (std::size_t j = 0; j < i; ++j) {
        for (const Vector3d& p :
             common_points(quadric.equation, planes_[i], planes_[j], quadric.size())) {
          add_corner_at(p);
        }
      }
    }
  }

  std::vector<RegionLoop> loops() {
    std::vector<Arc> arcs;
    for (const BoundingPlane& plane : planes_) {
      for (const BoundaryConic& conic : section(quadric_.equation, plane, quadric_.reach)) {
        for (const Arc& arc : arcs_between(conic, cuts(conic))) {
          if (is_boundary(arc) && !is_among(arcs, arc)) arcs.push_back(slowed(arc));
        }
      }
    }
    return joined(std::move(arcs));
  }

 private:
  bool is_same(const Vector3d& a, const Vector3d& b) const { return (a - b).norm() < tolerance_; }

  void add_corner_at(const Vector3d& p) {
    const auto known = std::find_if(corners_.begin(), corners_.end(), [&](const Corner& corner) {
      return std::any_of(corner.begin(), corner.end(), [&](const Vector3d& q) {
        return (p - q).norm() < kCornerSize * tolerance_;
      });
    });
    if (known == corners_.end()) {
      corners_.push_back({p});
    } else {
      known->push_back(p);
    }
  }

  std::vector<Cut> cuts(const BoundaryConic& conic) const {
    std::vector<Cut> cuts;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      for (const Vector3d& p : corners_[i]) {
        const double at = conic.parameter(p);
        if (!is_same(conic.point(at), p)) continue;
        cuts.push_back({at, i});
        break;
      }
    }
    return cuts;
  }

  /// A closed conic starts where it is farthest from stops, so that it passes them inside.
  Arc slowed(Arc arc) const {
    if (!arc.start) arc.curve = started_far_from(quadric_.stops, arc.curve);
    for (const Vector3d& stop : quadric_.stops) arc.curve = slowed_beside(stop, arc.curve);
    return arc;
  }

  /// Just one side of it is in the region: at two places, since another bound may touch it in one.
  bool is_boundary(const Arc& arc) const {
    return has_one_side_inside(arc.curve, 0.4) && has_one_side_inside(arc.curve, 0.7);
  }

  bool has_one_side_inside(const Curve& curve, double at) const {
    const Vector3d p = curve(at), along = curve(at + kStep) - curve(at - kStep);
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
  std::vector<RegionLoop> joined(std::vector<Arc> arcs) const {
    require_pairs(arcs);
    std::vector<RegionLoop> loops;
    while (!arcs.empty()) {
      const auto first = arcs.back().start;
      auto end = arcs.back().finish;
      RegionLoop loop = {arcs.back().curve};
      arcs.pop_back();
      while (end != first) {
        const auto next = std::find_if(arcs.begin(), arcs.end(), [&](const Arc& arc) {
          return arc.start == end || arc.finish == end;
        });
        const bool runs_on = next->start == end;
        loop.push_back(runs_on ? next->curve : part(next->curve, 1, 0));
        end = runs_on ? next->finish : next->start;
        arcs.erase(next);
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  /// In every corner two arcs end, or none.
  void require_pairs(const std::vector<Arc>& arcs) const {
    std::vector<int> ends(corners_.size());
    for (const Arc& arc : arcs) {
      if (arc.start) ++ends[*arc.start];
      if (arc.finish) ++ends[*arc.finish];
    }
    if (std::all_of(ends.begin(), ends.end(), [](int n) { return n == 0 || n == 2; })) return;
    throw GeometryError(ErrorCode::kRegionUnsupported,
                        "The region touches itself in a point; move one of the bounds there a "
                        "little.");
  }

  const QuadricBounds& bounds_;
  const TracedQuadric& quadric_;
  std::vector<BoundingPlane> planes_;
  double tolerance_;
  std::vector<Corner> corners_;
};

/// A region thinner than this part of the size is nothing but an edge to CAD systems.
constexpr double kThinnest = 1e-7;

GeometryError too_thin() {
  return {ErrorCode::kRegionUnsupported,
          "The bounds leave less than a ten-millionth of the size; move them apart."};
}

void require_interval(const Interval& interval, const char* name) {
  for (const double bound : {interval.low, interval.high}) {
    if (!std::isinf(bound)) require_input_number(bound, std::string("A bound of ") + name);
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
    const double thickness =
        std::min(interval.high, extent.high) - std::max(interval.low, extent.low);
    if (thickness <= kThinnest * quadric.size()) throw too_thin();
    if (interval.low <= extent.low + least) interval.low = -HUGE_VAL;
    if (interval.high >= extent.high - least) interval.high = HUGE_VAL;
  }
  if (!bounds.angle) return result;
  const double turn = bounds.angle->high - bounds.angle->low;
  if (turn <= kThinnest) throw too_thin();
  if (turn >= kFullTurn) result.angle.reset();
  return result;
}

bool are_none(const QuadricBounds& bounds) { return !bounds.angle && planes_of(bounds).empty(); }

std::vector<RegionLoop> region_loops(const QuadricBounds& bounds, const TracedQuadric& quadric) {
  return RegionTracer(bounds, quadric).loops();
}

}  // namespace pn
