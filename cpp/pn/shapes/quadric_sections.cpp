// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric_sections.hpp"

#include <algorithm>
#include <cmath>

namespace pn {
namespace {

using Eigen::Vector3d;

/// Conics on infinite surfaces are drawn so far beyond the region, as a part of its extent.
constexpr double kBeyond = 0.0625;

double& at(Vector3d& p, std::size_t axis) { return p(static_cast<Eigen::Index>(axis)); }
double at(const Vector3d& p, std::size_t axis) { return p(static_cast<Eigen::Index>(axis)); }

Interval widened(const Interval& interval) {
  const double margin = kBeyond * (interval.high - interval.low);
  return {interval.low - margin, interval.high + margin};
}

/// What the equation leaves of a plane x_axis = value: the terms of the two other coordinates add
/// up to this.
double level(const QuadricEquation& quadric, const CoordinatePlane& plane) {
  const double linear = plane.axis == 2 ? 2 * quadric.half_linear * plane.value : 0;
  return -(quadric.constant + at(quadric.square, plane.axis) * plane.value * plane.value + linear);
}

/// A plane with this level nearly touches the surface.
bool touches(const QuadricEquation& quadric, double level, const Box& reach) {
  const double height = std::max(std::abs(reach[2].low), std::abs(reach[2].high));
  const double whole = quadric.constant != 0 ? std::abs(quadric.constant)
                                             : 2 * std::abs(quadric.half_linear) * height;
  return std::abs(level) <= kTouching * whole;
}

/// A curve along a coordinate.
BoundaryConic graph(std::size_t along, const Interval& range,
                    std::function<Vector3d(double)> point) {
  const double low = range.low, high = range.high;
  return {
      [=](double t) { return point(low + t * (high - low)); },
      [=](const Vector3d& p) { return std::clamp((at(p, along) - low) / (high - low), 0.0, 1.0); },
      false};
}

/// The curves of a plane: a point with the plane's own coordinate and two others.
class InPlane {
 public:
  InPlane(const CoordinatePlane& plane, std::size_t first, std::size_t second)
      : plane_(plane), first_(first), second_(second) {}

  Vector3d point(double first, double second) const {
    Vector3d p;
    at(p, plane_.axis) = plane_.value;
    at(p, first_) = first;
    at(p, second_) = second;
    return p;
  }

  BoundaryConic ellipse(double first, double second) const {
    return {[=, self = *this](double t) {
              const double angle = 2 * M_PI * t;
              return self.point(first * std::cos(angle), second * std::sin(angle));
            },
            [=, self = *this](const Vector3d& p) {
              const double turn =
                  std::atan2(at(p, self.second_) / second, at(p, self.first_) / first) / (2 * M_PI);
              return turn < 0 ? turn + 1 : turn;
            },
            true};
  }

  /// (first cosh, second sinh): the branch on the side of the sign of `first`.
  BoundaryConic branch(double first, double second, const Interval& range) const {
    const double low = std::asinh(range.low / second), high = std::asinh(range.high / second);
    return {[=, self = *this](double t) {
              const double x = low + t * (high - low);
              return self.point(first * std::cosh(x), second * std::sinh(x));
            },
            [=, self = *this](const Vector3d& p) {
              const double x = std::asinh(at(p, self.second_) / second);
              return std::clamp((x - low) / (high - low), 0.0, 1.0);
            },
            false};
  }

  /// Along the second coordinate, with the first one at slope times it plus a constant.
  BoundaryConic line(double slope, double constant, const Interval& range) const {
    return graph(second_, range,
                 [=, self = *this](double x) { return self.point(constant + slope * x, x); });
  }

 private:
  CoordinatePlane plane_;
  std::size_t first_, second_;
};

std::vector<BoundaryConic> section(const QuadricEquation& quadric, const CoordinatePlane& plane,
                                   const Box& reach) {
  const double q = level(quadric, plane);
  if (quadric.half_linear != 0 && plane.axis != 2) {
    const std::size_t along = 1 - plane.axis;
    const double square = at(quadric.square, along), linear = 2 * quadric.half_linear;
    const InPlane in_plane(plane, along, 2);
    return {graph(along, widened(reach[along]),
                  [=](double x) { return in_plane.point(x, (q - square * x * x) / linear); })};
  }
  std::size_t first = (plane.axis + 1) % 3, second = (plane.axis + 2) % 3;
  // The first coordinate is one whose axis the conic crosses: it has the sign of the level.
  if (!(q * at(quadric.square, first) > 0)) std::swap(first, second);
  const double s = at(quadric.square, first), r = at(quadric.square, second);
  const InPlane in_plane(plane, first, second);
  const Interval range = widened(reach[second]);
  if (touches(quadric, q, reach)) {
    if (!(s * r < 0)) return {};
    const double slope = std::sqrt(-r / s);
    return {in_plane.line(slope, 0, range), in_plane.line(-slope, 0, range)};
  }
  if (!(q / s > 0)) return {};
  const double radius = std::sqrt(q / s);
  if (r == 0) return {in_plane.line(0, radius, range), in_plane.line(0, -radius, range)};
  if (q / r > 0) return {in_plane.ellipse(radius, std::sqrt(q / r))};
  std::vector<BoundaryConic> branches = {in_plane.branch(radius, std::sqrt(-q / r), range)};
  if (!(quadric.is_upper_sheet && first == 2)) {
    branches.push_back(in_plane.branch(-radius, std::sqrt(-q / r), range));
  }
  return branches;
}

double across(const QuadricEquation& quadric, double c, double s) {
  return quadric.square.x() * c * c + quadric.square.y() * s * s;
}

std::vector<BoundaryConic> section(const QuadricEquation& quadric, const HalfPlane& plane,
                                   const Box& reach) {
  const double c = std::cos(plane.angle), s = std::sin(plane.angle);
  const double square = across(quadric, c, s), up = quadric.square.z();
  const double constant = quadric.constant, linear = 2 * quadric.half_linear;
  const auto point = [=](double r, double z) { return Vector3d(r * c, r * s, z); };
  const auto radius = [](const Vector3d& p) { return std::hypot(p.x(), p.y()); };
  if (up > 0) {
    const double width = std::sqrt(-constant / square), height = std::sqrt(-constant / up);
    return {
        {[=](double t) { return point(width * std::sin(M_PI * t), height * std::cos(M_PI * t)); },
         [=](const Vector3d& p) { return std::atan2(radius(p) / width, p.z() / height) / M_PI; },
         false}};
  }
  if (linear == 0 && !quadric.is_upper_sheet) {
    return {graph(2, widened(reach[2]), [=](double z) {
      return point(std::sqrt(std::max(0.0, -(up * z * z + constant) / square)), z);
    })};
  }
  const auto far = [&](std::size_t axis) {
    return std::max(std::abs(reach[axis].low), std::abs(reach[axis].high));
  };
  const double end = (1 + kBeyond) * std::hypot(far(0), far(1));
  const auto height = [=](double r) {
    return linear != 0 ? -(square * r * r + constant) / linear
                       : std::sqrt(-(square * r * r + constant) / up);
  };
  return {{[=](double t) { return point(t * end, height(t * end)); },
           [=](const Vector3d& p) { return std::min(1.0, radius(p) / end); }, false}};
}

/// The points on a line along an axis through a point with coordinate zero there.
std::vector<Vector3d> on_line(const QuadricEquation& quadric, Vector3d foot, std::size_t axis,
                              double size) {
  const Vector3d half_gradient = quadric.half_gradient(foot);
  const double rest = foot.dot(half_gradient) + quadric.half_linear * foot.z() + quadric.constant;
  if (axis == 2 && quadric.half_linear != 0) {
    foot.z() = -rest / (2 * quadric.half_linear);
    return {foot};
  }
  const double square = -rest / at(quadric.square, axis);
  Vector3d slope = 2 * half_gradient;
  at(slope, axis) = 0;
  const bool is_tangent = std::abs(rest) <= kTouching * size * slope.norm();
  if (!(square > 0) || !std::isfinite(square) || is_tangent) return {};
  std::vector<Vector3d> points;
  for (const double sign : {1.0, -1.0}) {
    at(foot, axis) = sign * std::sqrt(square);
    if (!quadric.is_upper_sheet || foot.z() > 0) points.push_back(foot);
  }
  return points;
}

std::vector<Vector3d> common_points(const QuadricEquation& quadric, const CoordinatePlane& a,
                                    const CoordinatePlane& b, double size) {
  if (a.axis == b.axis) return {};
  Vector3d foot = Vector3d::Zero();
  at(foot, a.axis) = a.value;
  at(foot, b.axis) = b.value;
  return on_line(quadric, foot, 3 - a.axis - b.axis, size);
}

std::vector<Vector3d> common_points(const QuadricEquation& quadric, const CoordinatePlane& a,
                                    const HalfPlane& b, double size) {
  const double c = std::cos(b.angle), s = std::sin(b.angle);
  if (a.axis == 2) {
    const double square = level(quadric, a) / across(quadric, c, s);
    if (!(square >= 0) || !std::isfinite(square)) return {};
    const double r = std::sqrt(square);
    return {Vector3d(r * c, r * s, a.value)};
  }
  const double r = a.value / (a.axis == 0 ? c : s);
  if (!(r >= 0) || !std::isfinite(r)) return {};
  return on_line(quadric, {r * c, r * s, 0}, 2, size);
}

std::vector<Vector3d> common_points(const QuadricEquation& quadric, const HalfPlane& a,
                                    const CoordinatePlane& b, double size) {
  return common_points(quadric, b, a, size);
}

/// On the z-axis.
std::vector<Vector3d> common_points(const QuadricEquation& quadric, const HalfPlane&,
                                    const HalfPlane&, double size) {
  return on_line(quadric, Vector3d::Zero(), 2, size);
}

}  // namespace

std::vector<BoundaryConic> section(const QuadricEquation& quadric, const BoundingPlane& plane,
                                   const Box& reach) {
  return std::visit([&](const auto& own) { return section(quadric, own, reach); }, plane);
}

std::optional<Vector3d> touching_point(const QuadricEquation& quadric, const BoundingPlane& plane,
                                       const Box& reach) {
  const auto* own = std::get_if<CoordinatePlane>(&plane);
  if (!own || (quadric.half_linear != 0 && own->axis != 2)) return std::nullopt;
  if (!touches(quadric, level(quadric, *own), reach)) return std::nullopt;
  Vector3d p = Vector3d::Zero();
  at(p, own->axis) = own->value;
  return p;
}

std::vector<Vector3d> common_points(const QuadricEquation& quadric, const BoundingPlane& a,
                                    const BoundingPlane& b, double size) {
  return std::visit([&](const auto& first,
                        const auto& second) { return common_points(quadric, first, second, size); },
                    a, b);
}

}  // namespace pn
