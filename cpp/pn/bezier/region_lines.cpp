// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/region_lines.hpp"

#include <algorithm>
#include <cmath>

#include "pn/bezier/circle_parameter.hpp"
#include "pn/bezier/parameter_lines.hpp"
#include "pn/geometry_error.hpp"
#include "pn/isotropic/seam.hpp"

namespace pn {
namespace {

using Eigen::Matrix2cd;
using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr int kSamplesPerArc = 64;
/// The faces begin and end so far beyond the boundary, as a part of their extent along.
constexpr double kMargin = 0.01;
/// Nearer to a pole the direction of its circles is lost to rounding.
constexpr double kAtPole = 1e-9;

/// Within this distance from a pole a region has no split.
constexpr double kBesidePole = 1e-3;

/// A loop whose t varies by no more than rounding lies on a line t = const.
constexpr double kParallel = 1e-12;

/// An interval that grows.
struct Hull {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  double width() const { return high - low; }
  Hull widened(double by) const { return {low - by, high + by}; }
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
    constexpr double kLargestTurn = 0.05, kLargestGrowth = 0.02, kShortest = 1e-10;
    const Step from = steps.back();
    Step next = at(to);
    const double turn = std::remainder(next.angle - from.angle, M_PI);
    // A part of the distance from the pole, so that no step hides what lies beside a split.
    const double largest_growth = kLargestGrowth * std::max(from.t, kBesidePole);
    const bool is_far = std::abs(turn) > kLargestTurn || std::abs(next.t - from.t) > largest_growth;
    if (is_far && to - from.s > kShortest) {
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

/// The angle followed around a loop grows by a half turn: the loop goes around the circles.
bool winds(const std::vector<AngleWalk::Step>& loop) {
  return std::abs(loop.back().angle - loop.front().angle) > M_PI / 2;
}

double turned_into_half_turn(double angle, double start) {
  return angle - M_PI * std::floor((angle - start) / M_PI);
}

/// The widest gap between directions, from its start; directions are angles modulo pi.
Hull widest_gap(const std::vector<BoundaryPlace>& places) {
  std::vector<double> angles;
  for (const BoundaryPlace& place : places) angles.push_back(turned_into_half_turn(place.angle, 0));
  std::sort(angles.begin(), angles.end());
  Hull gap{angles.back() - M_PI, angles.front()};
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (angles[i] - angles[i - 1] > gap.width()) gap = {angles[i - 1], angles[i]};
  }
  return gap;
}

/// All angles from the middle of the gap on.
std::vector<BoundaryPlace> beyond_gap(std::vector<BoundaryPlace> places, const Hull& gap) {
  const double start = (gap.low + gap.high) / 2;
  for (BoundaryPlace& place : places) place.angle = turned_into_half_turn(place.angle, start);
  return places;
}

std::vector<BoundaryPlace> places_on(const std::vector<std::vector<AngleWalk::Step>>& walks) {
  std::vector<BoundaryPlace> places;
  for (const auto& walk : walks) {
    for (const auto& step : walk) places.push_back({step.t, step.angle});
  }
  return places;
}

/// The places beyond a circle.
std::vector<BoundaryPlace> from(const std::vector<BoundaryPlace>& places, double t) {
  std::vector<BoundaryPlace> result;
  std::copy_if(places.begin(), places.end(), std::back_inserter(result),
               [&](const BoundaryPlace& place) { return place.t >= t; });
  return result;
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

/// Lines of the whole circle whose larger part lies between two angles.
Matrix2d larger_part_between(const Matrix2cd& a, const Hull& angles) {
  Matrix2d ends;
  ends << circle_point(0, kLeastArcs).normalized(),
      circle_point(kArcsOfLargerPart, kLeastArcs).normalized();
  return directions(a, angles) * ends.inverse();
}

/// Weights around a circle may vary by this factor; a whole circle nearer to infinity is not taken.
constexpr double kLeastRatioAround = 0.05;

/// The last circle up to which all weights are positive, and vary little where `high` is not
/// reached.
double last_whole_circle(const IsotropicHypersurface<double>& gamma, double low, double high) {
  constexpr int kCircles = 200, kDirections = 64;
  const FormInU<double> weight =
      sections(gamma.carrier, isotropic_vector<double>(gamma.spinor)).weight;
  const auto least_ratio = [&](double t) {
    const Matrix2d even = even_lines(gamma.circles, value_at(gamma.spinor, t), t);
    double least = HUGE_VAL, largest = 0;
    for (int i = 0; i < kDirections; ++i) {
      const Vector2d u = even * direction(M_PI * i / kDirections);
      const double at = value(weight, t, u(0), u(1));
      least = std::min(least, at);
      largest = std::max(largest, at);
    }
    return least / largest;
  };
  double last = low;
  for (int i = 1; i <= kCircles; ++i) {
    const double t = low + (high - low) * i / kCircles, ratio = least_ratio(t);
    if (ratio <= 0) return last;
    if (ratio > kLeastRatioAround) last = t;
  }
  return high;
}

/// Lines over arcs stay even beside a gap of this width in the directions that a region takes; with
/// less, whole circles are better where they can be had.
constexpr double kWideGap = 1;

/// The first circle beyond which the boundary leaves a wide gap, `last` if none does.
double first_with_wide_gap(const std::vector<BoundaryPlace>& places, double low, double last) {
  constexpr int kSteps = 32;
  for (int i = 1; i < kSteps; ++i) {
    const double t = low + (last - low) * i / kSteps;
    if (widest_gap(from(places, t)).width() > kWideGap) return t;
  }
  return last;
}

/// The least arc that lines are spread over, as a part of the widest one: where a region ends in a
/// corner.
constexpr double kLeastArc = 0.1;
/// A margin takes this part of what the region leaves of the circle, at most.
constexpr double kMostOfGap = 0.25;

/// The boundary within `reach` of a circle.
CircleArc arc_near(const std::vector<BoundaryPlace>& boundary, double t, double reach) {
  Hull near, all;
  for (const BoundaryPlace& place : boundary) {
    all.add(place.angle);
    if (std::abs(place.t - t) <= reach) near.add(place.angle);
  }
  if (near.width() < 0) near = all;
  const double missing = std::max(0.0, kLeastArc * all.width() - near.width());
  near = near.widened(missing / 2);
  return {near.low, near.high};
}

ArcOf arc_within(const RegionCircles& circles, double window) {
  const double reach = window * (circles.high - circles.low);
  return [=, boundary = circles.boundary](double t) { return arc_near(boundary, t, reach); };
}

/// A line over t.
struct Line {
  double origin, value, slope;
  double operator()(double t) const { return value + slope * (t - origin); }
};

/// The line above all places that is lowest in the middle: it goes through two places, one on each
/// side, or through a single one in the middle.
Line supporting_line(const std::vector<BoundaryPlace>& places, double middle) {
  // The slope is right when the highest places over it lie on both sides of the middle.
  const auto highest = [&](double slope) {
    return *std::max_element(places.begin(), places.end(),
                             [&](const BoundaryPlace& a, const BoundaryPlace& b) {
                               return a.angle - slope * a.t < b.angle - slope * b.t;
                             });
  };
  constexpr int kBisections = 40;
  double steepest = 1 << 20, slope = 0;
  for (int i = 0; i < kBisections; ++i, steepest /= 2) {
    slope += highest(slope).t > middle ? steepest / 2 : -steepest / 2;
  }
  const BoundaryPlace place = highest(slope);
  return {place.t, place.angle, slope};
}

std::vector<BoundaryPlace> upside_down(std::vector<BoundaryPlace> places) {
  for (BoundaryPlace& place : places) place.angle = -place.angle;
  return places;
}

/// Places of the boundary lie no farther apart beside the split, as a part of its distance from
/// where the region begins.
constexpr double kBeforeSplit = 0.03;

GeometryError too_far() {
  return {ErrorCode::kRegionUnsupported,
          "The region reaches too far beyond the umbilics of the hyperboloid, to where its points "
          "run to infinity. Lower its height, or divide it by a sector or a box."};
}

}  // namespace

bool is_bounded_by_parallels(const BoundedRegion& region) {
  return std::all_of(region.loops.begin(), region.loops.end(), [](const auto& loop) {
    Hull t;
    for (const BoundaryArc& arc : loop) {
      for (int i = 0; i < kSamplesPerArc; ++i) t.add(arc((i + 0.5) / kSamplesPerArc).t);
    }
    return t.width() < kParallel;
  });
}

RegionCircles region_circles(const BoundedRegion& region,
                             const IsotropicHypersurface<double>& gamma) {
  // Only a closed surface has no boundary.
  if (region.loops.empty()) return {0, 1, true, {}, {}};
  const auto loops = walks(region, gamma.spinor);
  const std::vector<BoundaryPlace> everywhere = places_on(loops);
  Hull t;
  for (const BoundaryPlace& place : everywhere) t.add(place.t);
  if (!is_bounded_by_parallels(region)) t = t.widened(kMargin * t.width());
  RegionCircles circles;
  circles.low = region.has_first_pole ? 0 : std::max(t.low, kAtPole);
  circles.high = region.has_last_pole ? 1 : std::min(t.high, 1 - kAtPole);
  const double whole = last_whole_circle(gamma, circles.low, circles.high);
  const bool surrounds = region.has_first_pole || region.has_last_pole ||
                         std::any_of(loops.begin(), loops.end(), winds);
  const bool has_gap = widest_gap(everywhere).width() > kWideGap;
  circles.is_closed = surrounds || (!has_gap && whole == circles.high);
  if (circles.is_closed && whole == circles.high) return circles;
  if (circles.is_closed) circles.split = first_with_wide_gap(everywhere, circles.low, whole);
  if (circles.split == circles.low) throw too_far();
  // The boundary crosses the split between two places: that before it belongs to the arcs, too.
  const double start = circles.split.value_or(circles.low);
  const auto places = from(everywhere, start - kBeforeSplit * (start - circles.low));
  const Hull gap = widest_gap(places);
  if (gap.width() < kLeastArc) throw too_far();
  circles.boundary = beyond_gap(places, gap);
  return circles;
}

ArcOf constant_arc(const RegionCircles& circles) { return arc_within(circles, 1); }

ArcOf tapering_arc(const RegionCircles& circles) {
  const double low = circles.split.value_or(circles.low), middle = (low + circles.high) / 2;
  const Line above = supporting_line(circles.boundary, middle),
             below = supporting_line(upside_down(circles.boundary), middle);
  return [=](double t) { return CircleArc{-below(t), above(t)}; };
}

ArcOf following_arc(const RegionCircles& circles) { return arc_within(circles, 0.1); }

ArcOf closely_following_arc(const RegionCircles& circles) { return arc_within(circles, 0.03); }

RegionLines::RegionLines(IsotropicHypersurface<double> gamma, RegionCircles circles, ArcOf arc,
                         double margin)
    : gamma_(std::move(gamma)),
      circles_(std::move(circles)),
      arc_(std::move(arc)),
      margin_(margin) {
  choose_signs(1);
}

Matrix2d RegionLines::factor(std::size_t, double place) const {
  if (circles_.boundary.empty()) {
    const double middle = (circles_.low + circles_.high) / 2;
    return even_lines(gamma_.circles, value_at(gamma_.spinor, middle), middle);
  }
  const double start = circles_.split.value_or(circles_.low);
  const auto [low, high] = arc_(std::clamp(place, start, circles_.high));
  const double margin = std::min(margin_ * (high - low), kMostOfGap * (M_PI - (high - low)));
  const Hull arc{low - margin, high + margin};
  // On one circle for all: then the directions of linear lines turn evenly between their ends.
  const Matrix2cd a = value_at(gamma_.spinor, (start + circles_.high) / 2);
  return circles_.split ? larger_part_between(a, arc) : directions(a, arc);
}

}  // namespace pn
