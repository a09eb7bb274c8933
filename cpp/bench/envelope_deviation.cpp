// SPDX-License-Identifier: LGPL-2.1-or-later
#include "envelope_deviation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "pn/bezier/evaluation.hpp"

namespace pn::bench {
namespace {

using Real = long double;
using Vector3 = Eigen::Matrix<Real, 3, 1>;

/// A Bezier function by de Casteljau's algorithm, for every real t.
template <class Point>
Point bezier_value(std::vector<Point> points, Real t) {
  for (std::size_t n = points.size(); n > 1; --n) {
    for (std::size_t i = 0; i + 1 < n; ++i) points[i] = points[i] * (1 - t) + points[i + 1] * t;
  }
  return points.front();
}

/// The control points of the derivative; those of a constant are left as a single zero.
template <class Point>
std::vector<Point> derivative(const std::vector<Point>& points) {
  const auto degree = static_cast<Real>(points.size() - 1);
  if (points.size() == 1) return {points.front() * Real(0)};
  std::vector<Point> result;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    result.push_back((points[i + 1] - points[i]) * degree);
  }
  return result;
}

/// The moving sphere.
class Spheres {
 public:
  explicit Spheres(const BezierCanal& canal)
      : centre_(canal.spine.size()), radius_(canal.radius.begin(), canal.radius.end()) {
    std::transform(canal.spine.begin(), canal.spine.end(), centre_.begin(),
                   [](const auto& p) { return Vector3(p[0], p[1], p[2]); });
    velocity_ = derivative(centre_);
    growth_ = derivative(radius_);
  }

  Real distance(const Vector3& p, Real t) const {
    return (p - bezier_value(centre_, t)).norm() - bezier_value(radius_, t);
  }
  Real distance_slope(const Vector3& p, Real t) const {
    const Vector3 arm = p - bezier_value(centre_, t);
    return -arm.dot(bezier_value(velocity_, t)) / arm.norm() - bezier_value(growth_, t);
  }

 private:
  std::vector<Vector3> centre_, velocity_;
  std::vector<Real> radius_, growth_;
};

/// The least distance of p to the spheres over [low, high], a unimodal stretch: the zero of the
/// slope, by halving. The distance is stationary there, so half the digits of t would do.
Real least_distance(const Spheres& spheres, const Vector3& p, Real low, Real high) {
  constexpr int kHalvings = 50;
  for (int i = 0; i < kHalvings; ++i) {
    const Real middle = (low + high) / 2;
    (spheres.distance_slope(p, middle) < 0 ? low : high) = middle;
  }
  return spheres.distance(p, (low + high) / 2);
}

Real distance_to_envelope(const Spheres& spheres, const Vector3& p) {
  constexpr int kFirst = -6, kLast = 38, kStepsPerUnit = 32;  // some way beyond both ends
  const auto parameter = [](int i) { return static_cast<Real>(i) / kStepsPerUnit; };
  int nearest = kFirst;
  for (int i = kFirst; i <= kLast; ++i) {
    if (spheres.distance(p, parameter(i)) < spheres.distance(p, parameter(nearest))) nearest = i;
  }
  return least_distance(spheres, p, parameter(nearest - 1), parameter(nearest + 1));
}

}  // namespace

double deviation_from_envelope(const BSplineSurface& surface, const BezierCanal& canal) {
  constexpr int kAlong = 97, kAround = 31;  // odd, so that the grid misses the knots
  const Spheres spheres(canal);
  const auto between = [](const std::vector<double>& knots, int i, int count) {
    return knots.front() + (knots.back() - knots.front()) * i / count;
  };
  Real largest = 0;
  for (int i = 0; i <= kAlong; ++i) {
    for (int j = 0; j <= kAround; ++j) {
      const std::array<double, 3> p = evaluate(surface, between(surface.u_knots, i, kAlong),
                                               between(surface.v_knots, j, kAround));
      largest =
          std::max(largest, std::abs(distance_to_envelope(spheres, Vector3(p[0], p[1], p[2]))));
    }
  }
  return static_cast<double>(largest);
}

}  // namespace pn::bench
