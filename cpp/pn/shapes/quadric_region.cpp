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

/// Places at which a conic is looked at for where it crosses a bound; it does so twice at most.
constexpr int kSamples = 512;
/// Bisection ends at neighbouring doubles before that.
constexpr int kBisections = 80;

/// A bound of the region: negative inside, and the conic along which it is zero.
struct Bound {
  std::function<double(const Vector3d&)> excess;
  BoundaryConic conic;
};

double angle_from(double start, const Vector3d& p) {
  const double turn = std::remainder(std::atan2(p.y(), p.x()) - start, 2 * M_PI);
  return turn < 0 ? turn + 2 * M_PI : turn;
}

/// Signed distances from the half-planes that bound a sector: inside between them.
double distance_from_half_plane(double angle, const Vector3d& p) {
  return p.y() * std::cos(angle) - p.x() * std::sin(angle);
}

double crossing(const std::function<double(double)>& f, double low, double high) {
  const bool rises = f(low) < 0;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (low + high) / 2;
    ((f(middle) < 0) == rises ? low : high) = middle;
  }
  return (low + high) / 2;
}

std::vector<double> crossings(const BoundaryConic& conic,
                              const std::function<double(const Vector3d&)>& excess) {
  // The end of a closed conic is its start to the last bit.
  const auto f = [&](double t) { return excess(conic.point(conic.is_closed && t == 1 ? 0 : t)); };
  std::vector<double> result;
  for (int i = 0; i < kSamples; ++i) {
    const double low = static_cast<double>(i) / kSamples,
                 high = static_cast<double>(i + 1) / kSamples;
    if ((f(low) < 0) != (f(high) < 0)) result.push_back(crossing(f, low, high));
  }
  return result;
}

/// Where a curve passes through a point, if it does.
std::optional<double> passage(const Curve& curve, const Vector3d& point, double tolerance) {
  const auto distance = [&](double t) { return (curve(t) - point).norm(); };
  double best = 0;
  for (int i = 1; i <= kSamples; ++i) {
    const double t = static_cast<double>(i) / kSamples;
    if (distance(t) < distance(best)) best = t;
  }
  double step = 1.0 / kSamples;
  for (int i = 0; i < kBisections; ++i, step /= 2) {
    for (const double t : {best - step, best + step}) {
      if (t >= 0 && t <= 1 && distance(t) < distance(best)) best = t;
    }
  }
  return distance(best) < tolerance ? std::optional<double>(best) : std::nullopt;
}

Curve part(const Curve& curve, double begin, double end) {
  return [=](double t) { return curve(begin + t * (end - begin)); };
}

/// The arcs of a conic between its cuts. A closed one runs on through its start.
std::vector<Curve> arcs_between(const BoundaryConic& conic, std::vector<double> cuts) {
  std::sort(cuts.begin(), cuts.end());
  // Bounds that meet on the conic cut it once.
  const auto is_near = [](double a, double b) { return b - a < kSamePoint; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), is_near), cuts.end());
  std::vector<Curve> arcs;
  if (conic.is_closed) {
    if (cuts.empty()) return {conic.point};
    const Curve around = [point = conic.point](double t) { return point(t - std::floor(t)); };
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      arcs.push_back(part(conic.point, cuts[i], cuts[i + 1]));
    }
    arcs.push_back(part(around, cuts.back(), cuts.front() + 1));
    return arcs;
  }
  if (cuts.empty() || !is_near(0, cuts.front())) cuts.insert(cuts.begin(), 0);
  if (!is_near(cuts.back(), 1)) cuts.push_back(1);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    arcs.push_back(part(conic.point, cuts[i], cuts[i + 1]));
  }
  return arcs;
}

class RegionTracer {
 public:
  RegionTracer(const QuadricBounds& bounds, const QuadricSections& sections, double size,
               const std::vector<Vector3d>& stops)
      : bounds_(bounds), tolerance_(kSamePoint * size), stops_(stops) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Interval& interval = bounds.box[axis];
      for (const double sign : {-1.0, 1.0}) {
        const double value = sign < 0 ? interval.low : interval.high;
        if (!std::isfinite(value)) continue;
        const auto excess = [=](const Vector3d& p) {
          return sign * (p(static_cast<Eigen::Index>(axis)) - value);
        };
        if (const auto conic = sections.plane(axis, value)) bound_.push_back({excess, *conic});
      }
    }
    if (!bounds.angle) return;
    for (const double angle : {bounds.angle->low, bounds.angle->high}) {
      bound_.push_back({[=](const Vector3d& p) { return distance_from_half_plane(angle, p); },
                        sections.half_plane(angle)});
    }
  }

  std::vector<BoundaryLoop> loops() {
    std::vector<Curve> arcs;
    for (std::size_t i = 0; i < bound_.size(); ++i) {
      for (const Curve& arc : arcs_between(bound_[i].conic, cuts(i))) {
        if (bounds_the_region(arc(0.5), i)) arcs.push_back(arc);
      }
    }
    return joined(std::move(arcs));
  }

 private:
  std::vector<double> cuts(std::size_t own) const {
    const BoundaryConic& conic = bound_[own].conic;
    std::vector<double> result;
    for (std::size_t i = 0; i < bound_.size(); ++i) {
      if (i == own) continue;
      const auto more = crossings(conic, bound_[i].excess);
      result.insert(result.end(), more.begin(), more.end());
    }
    for (const Vector3d& stop : stops_) {
      const auto at = passage(conic.point, stop, tolerance_);
      if (!at) continue;
      const bool is_end = *at < kSamePoint || *at > 1 - kSamePoint;
      if (!is_end) result.push_back(*at);
      if (is_end && conic.is_closed) result.push_back(0);
    }
    return result;
  }

  /// A point of a bound's conic is on the boundary when all other bounds hold there.
  bool bounds_the_region(const Vector3d& p, std::size_t own) const {
    const bool is_angular = bounds_.angle && own + 2 >= bound_.size();
    QuadricBounds others = bounds_;
    if (is_angular) {
      others.angle.reset();
    } else {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = p(static_cast<Eigen::Index>(axis));
        if (std::abs(x - others.box[axis].low) < tolerance_) others.box[axis].low = -HUGE_VAL;
        if (std::abs(x - others.box[axis].high) < tolerance_) others.box[axis].high = HUGE_VAL;
      }
    }
    return is_inside(others, p);
  }

  bool is_same(const Vector3d& a, const Vector3d& b) const { return (a - b).norm() < tolerance_; }

  /// The arcs end to end.
  std::vector<BoundaryLoop> joined(std::vector<Curve> arcs) const {
    std::vector<BoundaryLoop> loops;
    while (!arcs.empty()) {
      BoundaryLoop loop = {arcs.back()};
      arcs.pop_back();
      while (!is_same(loop.back()(1), loop.front()(0))) {
        const Vector3d end = loop.back()(1);
        const auto next = std::find_if(arcs.begin(), arcs.end(), [&](const Curve& arc) {
          return is_same(arc(0), end) || is_same(arc(1), end);
        });
        if (next == arcs.end()) {
          throw GeometryError(ErrorCode::kRegionUnsupported,
                              "The bounds touch the surface without cutting it; move one of them "
                              "a little.");
        }
        const Curve arc = *next;
        arcs.erase(next);
        loop.push_back(is_same(arc(0), end) ? arc : part(arc, 1, 0));
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  QuadricBounds bounds_;
  double tolerance_;
  std::vector<Vector3d> stops_;
  std::vector<Bound> bound_;
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

std::vector<BoundaryLoop> boundary_loops(const QuadricBounds& bounds,
                                         const QuadricSections& sections, double size,
                                         const std::vector<Vector3d>& stops) {
  return RegionTracer(bounds, sections, size, stops).loops();
}

}  // namespace pn
