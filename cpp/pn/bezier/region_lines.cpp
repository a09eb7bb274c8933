// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/region_lines.hpp"

#include <algorithm>
#include <cmath>

#include "pn/algebra/precision.hpp"
#include "pn/isotropic/seam.hpp"

namespace pn {
namespace {

using Eigen::Matrix2cd;
using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr int kSamplesPerArc = 64;
/// The face reaches so far beyond the boundary, as a part of its extent.
constexpr double kMargin = 0.01;
/// Nearer to a pole the direction of its circles is lost to rounding.
constexpr double kAtPole = 1e-9;

/// A loop whose t varies by no more than rounding lies on a line t = const.
constexpr double kParallel = 1e-12;

/// An interval that grows.
struct Hull {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  Hull widened() const {
    const double margin = kMargin * (high - low);
    return {low - margin, high + margin};
  }
};

/// The extent of the boundary in t and in the angle of (u0, u1), followed around every loop.
struct BoundaryHull {
  Hull t, angle;
  bool winds = false;  ///< some loop goes around the circles
};

BoundaryHull boundary_hull(const BoundedRegion& region,
                           const SpinorMatrix<std::complex<double>>& spinor) {
  BoundaryHull hull;
  for (const auto& loop : region.loops) {
    double start = 0, last = 0;
    bool has_begun = false;
    for (const BoundaryArc& arc : loop) {
      for (int i = 0; i < kSamplesPerArc; ++i) {
        const ContactPoint at = arc((i + 0.5) / kSamplesPerArc);
        hull.t.add(at.t);
        const Vector2d u = parameter_of(value_at(spinor, at.t), at.normal);
        const double angle = std::atan2(u(1), u(0));
        last = has_begun ? last + std::remainder(angle - last, M_PI) : angle;
        if (!has_begun) start = angle;
        has_begun = true;
        hull.angle.add(last);
      }
    }
    hull.winds = hull.winds || std::abs(last - start) > M_PI / 2;
  }
  return hull;
}

Matrix2d short_entries(const Matrix2d& a) {
  return a.unaryExpr([](double x) { return static_cast<double>(static_cast<float>(x)); });
}

Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Lines u = (1 : 0) and (0 : 1) at two angles, with weight 1 on both where the link is in the
/// middle.
Matrix2d factor_between(const Matrix2cd& a, const Hull& angles) {
  Vector2d low = direction(angles.low), high = direction(angles.high);
  low /= (a * low).norm();
  high /= (a * high).norm();
  Matrix2d factor;
  factor << low, high;
  return factor;
}

}  // namespace

bool is_ruled(const EnvelopeChain& chain) {
  return std::holds_alternative<RulingForms<RealBall>>(
      chain.links.front().envelope.enclosure(kLeastPrecision).carrier);
}

bool is_bounded_by_parallels(const BoundedRegion& region) {
  return std::all_of(region.loops.begin(), region.loops.end(), [](const auto& loop) {
    Hull t;
    for (const BoundaryArc& arc : loop) {
      for (int i = 0; i < kSamplesPerArc; ++i) t.add(arc((i + 0.5) / kSamplesPerArc).t);
    }
    return t.high - t.low < kParallel;
  });
}

RegionLines region_lines(const EnvelopeChain& chain) {
  const auto& region = std::get<BoundedRegion>(chain.extent);
  const auto gamma = midpoint(chain.links.front().envelope.enclosure(kLeastPrecision));
  const BoundaryHull hull = boundary_hull(region, gamma.spinor);
  const Hull t = is_bounded_by_parallels(region) ? hull.t : hull.t.widened();
  RegionLines lines;
  lines.low = region.has_first_pole ? 0 : std::max(t.low, kAtPole);
  lines.high = region.has_last_pole ? 1 : std::min(t.high, 1 - kAtPole);
  lines.is_closed = region.has_first_pole || region.has_last_pole || hull.winds;
  const double middle = (lines.low + lines.high) / 2;
  const Matrix2cd a = value_at(gamma.spinor, middle);
  const Eigen::Vector3d normal =
      circle_normal(gamma.circles, middle, any_perpendicular(axis_at(gamma.circles, middle)));
  lines.factor = short_entries(lines.is_closed ? even_factor(a, normal)
                                               : factor_between(a, hull.angle.widened()));
  return lines;
}

}  // namespace pn
