// SPDX-License-Identifier: LGPL-2.1-or-later
#include "signed_distance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace pn::bench {
namespace {

using Real = long double;

Point point(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

std::vector<Point> points(const std::vector<std::array<double, 3>>& coordinates) {
  std::vector<Point> result;
  for (const std::array<double, 3>& p : coordinates) result.push_back(point(p));
  return result;
}

/// A Bezier function by de Casteljau's algorithm, for every real t.
template <class Value>
Value bezier_value(std::vector<Value> points, Real t) {
  for (std::size_t n = points.size(); n > 1; --n) {
    for (std::size_t i = 0; i + 1 < n; ++i) points[i] = points[i] * (1 - t) + points[i + 1] * t;
  }
  return points.front();
}

/// The control points of the derivative; those of a constant are left as a single zero.
template <class Value>
std::vector<Value> derivative(const std::vector<Value>& points) {
  const auto degree = static_cast<Real>(points.size() - 1);
  if (points.size() == 1) return {points.front() * Real(0)};
  std::vector<Value> result;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    result.push_back((points[i + 1] - points[i]) * degree);
  }
  return result;
}

/// The moving sphere.
class Spheres {
 public:
  explicit Spheres(const BezierCanal& canal)
      : centre_(points(canal.spine)),
        velocity_(derivative(centre_)),
        radius_(canal.radius.begin(), canal.radius.end()),
        growth_(derivative(radius_)) {}

  Real distance(const Point& p, Real t) const {
    return (p - bezier_value(centre_, t)).norm() - bezier_value(radius_, t);
  }
  Real distance_slope(const Point& p, Real t) const {
    const Point arm = p - bezier_value(centre_, t);
    return -arm.dot(bezier_value(velocity_, t)) / arm.norm() - bezier_value(growth_, t);
  }

 private:
  std::vector<Point> centre_, velocity_;
  std::vector<Real> radius_, growth_;
};

/// The moving line.
class Rulings {
 public:
  explicit Rulings(const BezierRuled& ruled)
      : first_(points(ruled.first)),
        second_(points(ruled.second)),
        first_velocity_(derivative(first_)),
        second_velocity_(derivative(second_)) {}

  Real distance(const Point& p, Real t) const { return foot(p, t).arm.norm(); }
  /// The foot point slides along the line to stay the nearest: that changes nothing to first order.
  Real distance_slope(const Point& p, Real t) const {
    const Foot at = foot(p, t);
    return -at.arm.dot(at.velocity) / at.arm.norm();
  }
  Real signed_distance(const Point& p, Real t) const {
    const Foot at = foot(p, t);
    return std::copysign(at.arm.norm(), at.arm.dot(at.velocity.cross(at.direction)));
  }

 private:
  struct Foot {
    Point arm;        ///< from the foot point to p
    Point velocity;   ///< S_t
    Point direction;  ///< S_v
  };

  Foot foot(const Point& p, Real t) const {
    const Point start = bezier_value(first_, t);
    const Point direction = bezier_value(second_, t) - start;
    const Real v = (p - start).dot(direction) / direction.squaredNorm();
    return {p - start - v * direction,
            (1 - v) * bezier_value(first_velocity_, t) + v * bezier_value(second_velocity_, t),
            direction};
  }

  std::vector<Point> first_, second_, first_velocity_, second_velocity_;
};

/// Where the distance to the family is least over [low, high], a unimodal stretch: the zero of its
/// slope, by halving. The distance is stationary there, so half the digits of t would do.
template <class Family>
Real stationary_parameter(const Family& family, const Point& p, Real low, Real high) {
  constexpr int kHalvings = 50;
  for (int i = 0; i < kHalvings; ++i) {
    const Real middle = (low + high) / 2;
    (family.distance_slope(p, middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// The parameter of the member that is nearest to p.
template <class Family>
Real nearest_parameter(const Family& family, const Point& p) {
  constexpr int kFirst = -6, kLast = 38, kStepsPerUnit = 32;  // some way beyond both ends
  const auto parameter = [](int i) { return static_cast<Real>(i) / kStepsPerUnit; };
  int nearest = kFirst;
  Real least = family.distance(p, parameter(kFirst));
  for (int i = kFirst + 1; i <= kLast; ++i) {
    const Real distance = family.distance(p, parameter(i));
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return stationary_parameter(family, p, parameter(nearest - 1), parameter(nearest + 1));
}

/// F = sum s_i x_i^2 + l_i x_i + k in principal axes.
class ImplicitQuadric {
 public:
  ImplicitQuadric(Point squares, Real linear_in_z, Real constant)
      : squares_(std::move(squares)), linear_(0, 0, linear_in_z), constant_(constant) {}

  Point gradient(const Point& x) const { return 2 * squares_.cwiseProduct(x) + linear_; }
  Real value(const Point& x) const {
    return x.dot(squares_.cwiseProduct(x)) + linear_.dot(x) + constant_;
  }

  /// By Newton's method for F(f(lambda)) = 0 from lambda = 0, f + lambda grad F(f) = p. While p is
  /// nearer than the focal surface all 1 + 2 lambda s_i are positive, F(f(lambda)) decreases, and
  /// the root is the foot point.
  Real signed_distance(const Point& p) const {
    constexpr int kMostSteps = 50;
    constexpr Real kNegligible = 1e-17L;  // two digits below doubles of size 1
    Real lambda = 0;
    for (int i = 0; i < kMostSteps; ++i) {
      const Point stretch = Point::Ones() + 2 * lambda * squares_;
      const Point foot = (p - lambda * linear_).cwiseQuotient(stretch);
      const Point normal = gradient(foot);
      const Real step = value(foot) / normal.dot(normal.cwiseQuotient(stretch));
      lambda += step;
      if (std::abs(step) < kNegligible) return lambda * normal.norm();
    }
    throw std::runtime_error("No foot point on the quadric.");
  }

 private:
  Point squares_, linear_;
  Real constant_;
};

ImplicitQuadric implicit(const QuadricCase& quadric) {
  const Real c = quadric.half_axes[2];
  const Point s = point(quadric.half_axes).cwiseAbs2().cwiseInverse();
  switch (quadric.kind) {
    case QuadricKind::kEllipsoid:
      return {s, 0, -1};
    case QuadricKind::kOneSheetHyperboloid:
      return {{s[0], s[1], -s[2]}, 0, -1};
    case QuadricKind::kTwoSheetHyperboloid:
      return {{s[0], s[1], -s[2]}, 0, 1};
    case QuadricKind::kEllipticParaboloid:
      return {{c * s[0], c * s[1], 0}, -1, 0};
    default:
      throw std::invalid_argument("No quadric of this kind is measured.");
  }
}

}  // namespace

SignedDistance distance_from(const BezierCanal& canal) {
  return [spheres = Spheres(canal)](const Point& p) {
    return spheres.distance(p, nearest_parameter(spheres, p));
  };
}

SignedDistance distance_from(const BezierRuled& ruled) {
  return [rulings = Rulings(ruled)](const Point& p) {
    return rulings.signed_distance(p, nearest_parameter(rulings, p));
  };
}

SignedDistance distance_from(const QuadricCase& quadric) {
  return [surface = implicit(quadric)](const Point& p) { return surface.signed_distance(p); };
}

SignedDistance distance_from(const OffsetBase& base) {
  return std::visit([](const auto& given) { return distance_from(given); }, base);
}

}  // namespace pn::bench
