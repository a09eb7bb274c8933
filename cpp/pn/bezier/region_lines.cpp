// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/region_lines.hpp"

#include <algorithm>
#include <cmath>

#include "pn/algebra/precision.hpp"
#include "pn/bezier/circle_parameter.hpp"
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

/// Follows the angle of (u0, u1) along an arc in steps that are small even near a pole.
class AngleWalk {
 public:
  AngleWalk(const BoundaryArc& arc, const SpinorMatrix<std::complex<double>>& spinor)
      : arc_(arc), spinor_(spinor) {}

  struct Step {
    double s, t, angle;
  };

  /// Steps from `first`, the angle of which continues `angle`, to `last`.
  std::vector<Step> steps(double first, double last, double angle) const {
    std::vector<Step> result = {at(first)};
    result.back().angle = angle + std::remainder(result.back().angle - angle, M_PI);
    for (int i = 1; i <= kSamplesPerArc; ++i) {
      walk(result, first + (last - first) * i / kSamplesPerArc);
    }
    return result;
  }

  Step at(double s) const {
    const ContactPoint contact = arc_(s);
    const Vector2d u = parameter_of(value_at(spinor_, contact.t), contact.normal);
    return {s, contact.t, std::atan2(u(1), u(0))};
  }

 private:
  void walk(std::vector<Step>& steps, double to) const {
    constexpr double kLargestTurn = 0.2, kShortest = 1e-10;
    const Step from = steps.back();
    Step next = at(to);
    const double turn = std::remainder(next.angle - from.angle, M_PI);
    if (std::abs(turn) > kLargestTurn && to - from.s > kShortest) {
      walk(steps, (from.s + to) / 2);
      return walk(steps, to);
    }
    next.angle = from.angle + turn;
    steps.push_back(next);
  }

  const BoundaryArc& arc_;
  const SpinorMatrix<std::complex<double>>& spinor_;
};

/// All steps along the loops, the angle followed around each.
std::vector<std::vector<AngleWalk::Step>> walks(const BoundedRegion& region,
                                                const SpinorMatrix<std::complex<double>>& spinor) {
  constexpr double kEnd = 1e-6;  // an arc may end at a pole
  std::vector<std::vector<AngleWalk::Step>> result;
  for (const auto& loop : region.loops) {
    std::vector<AngleWalk::Step> around;
    for (const BoundaryArc& arc : loop) {
      const AngleWalk walk(arc, spinor);
      const double angle = around.empty() ? walk.at(kEnd).angle : around.back().angle;
      const auto steps = walk.steps(kEnd, 1 - kEnd, angle);
      around.insert(around.end(), steps.begin(), steps.end());
    }
    result.push_back(std::move(around));
  }
  return result;
}

BoundaryHull boundary_hull(const std::vector<std::vector<AngleWalk::Step>>& walks) {
  BoundaryHull hull;
  for (const auto& walk : walks) {
    for (const auto& step : walk) {
      hull.t.add(step.t);
      hull.angle.add(step.angle);
    }
    hull.winds = hull.winds || std::abs(walk.back().angle - walk.front().angle) > M_PI / 2;
  }
  return hull;
}

/// The arc of directions on which the boundary lies beyond a circle: what remains of the half turn
/// without its widest gap.
Hull directions_beyond(const std::vector<std::vector<AngleWalk::Step>>& walks, double t) {
  std::vector<double> angles;
  for (const auto& walk : walks) {
    for (const auto& step : walk) {
      if (step.t > t) angles.push_back(step.angle - M_PI * std::floor(step.angle / M_PI));
    }
  }
  std::sort(angles.begin(), angles.end());
  Hull arc{angles.front(), angles.back()};
  double widest = angles.front() + M_PI - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (angles[i] - angles[i - 1] <= widest) continue;
    widest = angles[i] - angles[i - 1];
    arc = {angles[i], angles[i - 1] + M_PI};
  }
  return arc;
}

Matrix2d short_entries(const Matrix2d& a) {
  return a.unaryExpr([](double x) { return static_cast<double>(static_cast<float>(x)); });
}

Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// The directions at two angles, with weight 1 on both on this circle.
Matrix2d directions(const Matrix2cd& a, const Hull& angles) {
  const Vector2d low = direction(angles.low), high = direction(angles.high);
  Matrix2d factor;
  factor << low / (a * low).norm(), high / (a * high).norm();
  return factor;
}

/// Even lines on a circle. The line between the halves is turned off the coordinate planes, in
/// which regions like to have their edges.
Matrix2d even_lines(const CircleForms<double>& circles, const Matrix2cd& a, double t) {
  constexpr double kTurn = 0.2137;
  const Eigen::Vector3d axis = axis_at(circles, t).normalized();
  const Eigen::Vector3d e = Eigen::AngleAxisd(kTurn, axis) * any_perpendicular(axis);
  return even_factor(a, circle_normal(circles, t, e));
}

/// The largest t up to which all circles from a pole on stay on the sheet: their weight is
/// positive.
double last_whole_circle(const IsotropicHypersurface<double>& gamma, double high) {
  constexpr int kCircles = 200, kDirections = 64;
  const FormInU<double> weight =
      sections(gamma.carrier, isotropic_vector<double>(gamma.spinor)).weight;
  const auto is_positive = [&](double t) {
    for (int i = 0; i < kDirections; ++i) {
      const Vector2d u = direction(M_PI * i / kDirections);
      double value = 0;
      for (int j = 0; j <= weight.degree(); ++j) {
        value += small_binomial(weight.degree(), j) * weight.coefficient[j](t) *
                 std::pow(u(0), weight.degree() - j) * std::pow(u(1), j);
      }
      if (value <= 0) return false;
    }
    return true;
  };
  for (int i = 1; i <= kCircles; ++i) {
    if (!is_positive(high * i / kCircles)) return high * (i - 1) / kCircles;
  }
  return high;
}

/// Circles are taken whole up to this part of the last one that stays on the sheet.
constexpr double kWholePart = 0.8;
/// Beyond them the first half covers what the region needs and this part more.
constexpr double kHalfMargin = 0.1;

/// Lines whose first half, from s = 0 to s = 2 of four arcs, lies between two angles.
Matrix2d half_between(const Matrix2cd& a, Hull angles) {
  const double margin = kHalfMargin * (angles.high - angles.low);
  const Vector2d start = circle_point(0, 4).normalized(), end = circle_point(2, 4).normalized();
  Matrix2d ends;
  ends << start, end;
  return directions(a, {angles.low - margin, angles.high + margin}) * ends.inverse();
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
  const auto steps = walks(region, gamma.spinor);
  const BoundaryHull hull = boundary_hull(steps);
  const Hull t = is_bounded_by_parallels(region) ? hull.t : hull.t.widened();
  RegionLines lines;
  lines.low = region.has_first_pole ? 0 : std::max(t.low, kAtPole);
  lines.high = region.has_last_pole ? 1 : std::min(t.high, 1 - kAtPole);
  lines.is_closed = region.has_first_pole || region.has_last_pole || hull.winds;
  const double middle = (lines.low + lines.high) / 2;
  const Matrix2cd a = value_at(gamma.spinor, middle);
  if (!lines.is_closed) {
    lines.factor = short_entries(directions(a, hull.angle.widened()));
    return lines;
  }
  const double whole = last_whole_circle(gamma, lines.high);
  if (whole == lines.high) {
    lines.factor = short_entries(even_lines(gamma.circles, a, middle));
    return lines;
  }
  const double split = kWholePart * whole;
  lines.last_whole = split;
  const Hull beyond = directions_beyond(steps, split);
  lines.factor = short_entries(half_between(value_at(gamma.spinor, split), beyond));
  return lines;
}

}  // namespace pn
