// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/parameter_lines.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/parallel.hpp"
#include "pn/bezier/chain_seam.hpp"
#include "pn/bezier/line_factor.hpp"
#include "pn/bezier/region_lines.hpp"
#include "pn/bezier/ruling_band.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using namespace lines;
using Eigen::Matrix2d;

/// A part of a link whose lines are one polynomial F, over [begin, end] of the spine's parameter.
struct Segment {
  std::size_t link;
  double begin, end;
  Rational origin, length;  ///< in the link's parameter on [0, 1]
  Joint joint_before;
  Around around;
  int lines_degree;  ///< the largest degree that F may have
  int halvings = 0;

  double left() const { return origin.to_double(); }
  double middle() const { return (origin + length / Rational(2)).to_double(); }
  double right() const { return (origin + length).to_double(); }
  bool is_whole_link() const { return origin.is_zero() && length == Rational(1); }
};

/// The two parts at a cut; it is a double, so that the knots say exactly where they meet.
std::array<Segment, 2> halves(const Segment& segment, double middle, Joint joint) {
  const Rational begin = Rational::exactly(segment.begin), end = Rational::exactly(segment.end);
  const Rational part = (Rational::exactly(middle) - begin) / (end - begin);
  Segment left = segment, right = segment;
  left.halvings = right.halvings = segment.halvings + 1;
  left.end = right.begin = middle;
  left.length = segment.length * part;
  right.origin = segment.origin + left.length;
  right.length = segment.length - left.length;
  right.joint_before = joint;
  return {left, right};
}

template <class T>
T number(const Rational& x, long precision);
template <>
double number<double>(const Rational& x, long) {
  return x.to_double();
}
template <>
RealBall number<RealBall>(const Rational& x, long precision) {
  return RealBall(x, precision);
}

template <class C, class T>
SpinorMatrix<C> on_segment(const SpinorMatrix<C>& a, const T& origin, const T& length) {
  SpinorMatrix<C> result;
  result.degree = a.degree;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      result.entry[i][j] = a.entry[i][j].on_interval(C(origin), C(length));
    }
  }
  return result;
}

/// A in the segment's own parameter.
template <class T>
SpinorMatrix<ComplexOf<T>> restricted_spinor(const SpinorMatrix<ComplexOf<T>>& a,
                                             const Segment& segment, long precision) {
  if (segment.is_whole_link()) return a;
  return on_segment(a, number<T>(segment.origin, precision), number<T>(segment.length, precision));
}

Carrier<RealBall> restricted_carrier(const Carrier<RealBall>& carrier, const Segment& segment,
                                     long precision) {
  if (segment.is_whole_link()) return carrier;
  return on_interval(carrier, RealBall(segment.origin, precision),
                     RealBall(segment.length, precision));
}

/// What F must satisfy on each segment and how F is found, in doubles or in balls.
template <class T>
class FactorSequence {
 public:
  using C = ComplexOf<T>;

  /// `frames(i, end)` is what the lines of segment i are matched by at its ends.
  template <class Frames>
  FactorSequence(const std::vector<Segment>& segments, bool closed, const TargetLines& target,
                 const std::vector<SpinorMatrix<C>>& spinors, Frames&& frames, long precision)
      : segments_(segments), closed_(closed), precision_(precision), parts_(segments.size()) {
    for_each_index(segments.size(), [&](std::size_t i) {
      const Segment& segment = segments[i];
      parts_[i] = {{frames(i, 0), frames(i, 1)},
                   {target_end(target, segment, segment.left()),
                    target_end(target, segment, segment.right())},
                   short_doubles<T>(target.at(segment.link, segment.middle())),
                   spinors[i].degree[0] == 0};
    });
  }

  std::vector<LineFactor<T>> factors() {
    for (std::size_t i = 0; i < segments_.size(); ++i) factors_.push_back(trimmed(factor(i)));
    return std::move(factors_);
  }

 private:
  /// Without leading coefficients that vanish exactly: where the even factor is constant, as on
  /// cylinders and cones, the free choices coincide and the lines cost no degree.
  static LineFactor<T> trimmed(LineFactor<T> factor) {
    while (factor.coefficients.size() > 1 && vanishes(factor.coefficients.back())) {
      factor.coefficients.pop_back();
    }
    return factor;
  }
  static bool vanishes(const Matrix<T>& a) {
    return is_zero(a[0][0]) && is_zero(a[0][1]) && is_zero(a[1][0]) && is_zero(a[1][1]);
  }

  LineFactor<T> factor(std::size_t i) {
    const Segment& segment = segments_[i];
    const Part& part = parts_[i];
    const bool closes = closed_ && i + 1 == segments_.size();
    const bool meets_left = i > 0 && segment.joint_before != Joint::kNone;
    const bool smooth_left = meets_left && segment.joint_before == Joint::kSmooth;
    const bool smooth_right = closes && segments_.front().joint_before == Joint::kSmooth;

    LineEnd<T> left = part.target[0];
    if (meets_left) {
      const LineEnd<T> met =
          matched_to(i, 0, i - 1, finished(parts_[i - 1].ends[1], factors_[i - 1].ends[1]));
      left = {met.value, smooth_left ? met.slope : left.slope};
    }
    const int degree = std::min(smooth_left || smooth_right ? 3 : 2, segment.lines_degree);
    // Lines that cannot turn are right in the middle, or where those before them end.
    if (degree == 0) return constant_line(meets_left ? left.value : part.middle);
    // On a cylinder or cone what is even at one end is even everywhere.
    if (part.is_constant && !smooth_left && !closes) return constant_line(left.value);

    LineEnd<T> right = part.target[1];
    if (closes) {
      const LineEnd<T>& start = i > 0 ? factors_.front().ends[0] : left;
      const LineEnd<T> met = matched_to(i, 1, 0, finished(parts_[0].ends[0], start));
      right = {met.value, smooth_right ? met.slope : right.slope};
    }
    if (degree == 1) return line_through(left.value, right.value);
    if (degree == 3) return hermite_cubic(left, right);
    return parabola_through(left.value, part.middle, right.value);
  }

  /// What a segment brings along: A or another frame of its lines at its ends, and the target there
  /// and in the middle.
  struct Part {
    std::array<EndValue<C>, 2> ends;
    std::array<LineEnd<T>, 2> target;
    Matrix<T> middle;
    bool is_constant;
  };

  /// The target on a segment's link at t, as short doubles; its slope in the segment's parameter.
  static LineEnd<T> target_end(const TargetLines& target, const Segment& segment, double t) {
    return {short_doubles<T>(target.at(segment.link, t)),
            short_doubles<T>(target.derivative(segment.link, t) * segment.length.to_double())};
  }

  /// A F at an end.
  static EndValue<C> finished(const EndValue<C>& a, const LineEnd<T>& factor) {
    const Matrix<C> f = complexified<T>(factor.value), slope = complexified<T>(factor.slope);
    return {a.value * f, a.derivative * f + a.value * slope};
  }

  /// F at an end of a segment, met by the finished lines of a neighbour.
  LineEnd<T> matched_to(std::size_t own, int end, std::size_t neighbour,
                        const EndValue<C>& finished_neighbour) const {
    const Part& part = parts_[own];
    return matched<T>(part.ends[end], finished_neighbour, stretch(own, neighbour),
                      midpoint(part.target[end].value));
  }

  /// The length of one segment over that of another, as the knots have it.
  T stretch(std::size_t own, std::size_t neighbour) const {
    const auto length = [&](std::size_t i) {
      return Rational::exactly(segments_[i].end) - Rational::exactly(segments_[i].begin);
    };
    return number<T>(length(own) / length(neighbour), precision_);
  }

  const std::vector<Segment>& segments_;
  bool closed_;
  long precision_;
  std::vector<Part> parts_;
  std::vector<LineFactor<T>> factors_;
};

/// Room for the degree of F under OpenCASCADE's limit.
int room_for_lines(const Envelope& envelope) {
  return std::max(0, (kLargestDegree - envelope.degree()) / envelope.degree_per_line());
}

/// How the lines of a band are tried: the degree of F, the margin beyond the directrices as a part
/// of the arc between their normals, and how often segments may be halved.
struct BandAttempt {
  int lines_degree;
  double margin;
  int halvings;
  double least_weight_ratio;  ///< within a segment
};

/// Long rulings turn their normals by nearly half a turn, and their weights vary by as much.
constexpr double kLeastRatioOfLongRulings = 1e-4;

/// From few poles and little to trim away to what always ends well.
constexpr std::array<BandAttempt, 10> kBandAttempts = {
    {{0, 0.1, 0, kLeastWeightRatio},
     {1, 0.1, 0, kLeastWeightRatio},
     {1, 0.3, 0, kLeastWeightRatio},
     {2, 0.1, 0, kLeastWeightRatio},
     {2, 0.3, 0, kLeastWeightRatio},
     {2, 0.1, kMostSegmentHalvings, kLeastWeightRatio},
     {2, 0.1, kMostSegmentHalvings, kLeastRatioOfLongRulings},
     {2, 0.01, kMostSegmentHalvings, kLeastRatioOfLongRulings},
     {2, 0.001, kMostSegmentHalvings, kLeastRatioOfLongRulings},
     {2, 1.0, kMostSegmentHalvings, kLeastRatioOfLongRulings}}};

/// How the lines of a region are tried: the degree of F over arcs, which arcs of the circles they
/// take and how far beyond, and how often segments may be halved.
struct RegionAttempt {
  int lines_degree;
  ArcOf (*arc)(const RegionCircles&);
  double margin;
  int halvings;
};

/// From few poles to what always ends well.
constexpr std::array<RegionAttempt, 6> kRegionAttempts = {{{0, constant_arc, 0.01, 0},
                                                           {1, tapering_arc, 0.02, 0},
                                                           {1, tapering_arc, 0.08, 0},
                                                           {2, following_arc, 0.05, 0},
                                                           {2, following_arc, 0.05, 3},
                                                           {2, closely_following_arc, 0.02, 4}}};

/// Weights over a region may vary by this factor, as between a vertex and far points.
constexpr double kLeastRatioOfRegions = 2e-3;

/// Places on a segment at which the lines of a band are compared with its directrices.
constexpr int kBandSamples = 129;

class Planner {
 public:
  Planner(const EnvelopeChain& chain, Lines lines, long precision)
      : chain_(chain), lines_(lines), precision_(precision) {
    gammas_.resize(chain.links.size());
    estimates_.resize(chain.links.size());
    for_each_index(chain.links.size(), [&](std::size_t i) {
      gammas_[i] = chain.links[i].envelope.enclosure(precision);
      estimates_[i] = midpoint(gammas_[i]);
    });
  }

  std::vector<LinedSegment> segments() {
    if (std::holds_alternative<RulingForms<double>>(estimates_.front().carrier)) {
      plan_band();
    } else if (std::holds_alternative<BoundedRegion>(chain_.extent)) {
      plan_region();
    } else {
      plan_circles();
    }
    const std::vector<SpinorMatrix<ComplexBall>> spinors = restricted_spinors<RealBall>();
    const std::vector<LineFactor<RealBall>> factors = factors_for<RealBall>(spinors);
    std::vector<LinedSegment> result(segments_.size());
    for_each_index(result.size(), [&](std::size_t i) {
      const Segment& segment = segments_[i];
      const SpinorMatrix<ComplexBall> spinor = lined<RealBall>(spinors[i], factors[i]);
      const Carrier<RealBall> carrier = carrier_of<RealBall>(segment);
      result[i] = {{chain_.links[segment.link].stands_still(), segment.begin, segment.end,
                    segment.joint_before, segment.around,
                    sections(carrier, isotropic_vector<RealBall>(spinor))},
                   midpoint(carrier),
                   midpoint(spinor)};
    });
    return result;
  }

 private:
  /// The links as segments with lines of these degrees.
  template <class DegreeOf>
  std::vector<Segment> whole_links(Around around, DegreeOf&& degree_of) const {
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < chain_.links.size(); ++i) {
      const ChainLink& link = chain_.links[i];
      const double begin = link.stands_still() ? 0 : link.begin;
      const double end = link.stands_still() ? 1 : link.end;
      segments.push_back({i, begin, end, Rational(0), Rational(1), link.joint_before, around,
                          std::min(degree_of(i), room(i))});
    }
    // The last lines of a closed chain have to come back to the first.
    if (chain_.closed) segments.back().lines_degree = std::max(1, segments.back().lines_degree);
    // A joint stays smooth only where both sides have room for cubic lines.
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const Segment& before = segments[(i + segments.size() - 1) % segments.size()];
      const bool keeps = segments[i].lines_degree == 3 && before.lines_degree == 3;
      Joint& joint = segments[i].joint_before;
      if (joint == Joint::kSmooth && !keeps) joint = Joint::kTangent;
    }
    return segments;
  }

  void plan_circles() {
    target_ = std::make_unique<ChainSeam>(chain_, estimates_);
    segments_ =
        whole_links(Around::kCircle, [&](std::size_t) { return lines_ == Lines::kEven ? 3 : 0; });
    while (refine_uneven_segments()) {
    }
  }

  void plan_band() {
    const bool smooth =
        std::any_of(chain_.links.begin(), chain_.links.end(),
                    [](const ChainLink& link) { return link.joint_before == Joint::kSmooth; });
    for (const BandAttempt& attempt : kBandAttempts) {
      const int degree = smooth && lines_ == Lines::kEven ? 3 : attempt.lines_degree;
      target_ = std::make_unique<BandLines>(estimates_, attempt.margin);
      segments_ = whole_links(Around::kArc, [&](std::size_t) { return degree; });
      do {
        if (is_band_covered(attempt.least_weight_ratio)) return;
      } while (halve_bad_segments(attempt.halvings));
    }
    throw no_lines_of_band();
  }

  /// The directrices turn, and lines without room for it in their degree cannot follow.
  GeometryError no_lines_of_band() const {
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      if (!bad_[i] || room(segments_[i].link) > 0) continue;
      return {ErrorCode::kDegreeTooHigh,
              "The exact surface would need a degree above " + std::to_string(kLargestDegree) +
                  " for lines that follow its curves. Lower the degree of both curves, for "
                  "instance by cubic B-splines."};
    }
    return {ErrorCode::kWeightsNotPositive,
            "No patches with positive weights were found along the rulings; divide the curves into "
            "shorter spans."};
  }

  void plan_region() {
    const auto& region = std::get<BoundedRegion>(chain_.extent);
    const RegionCircles circles = region_circles(region, estimates_.front());
    const auto plan = [&](const RegionAttempt& attempt) {
      target_ = std::make_unique<RegionLines>(estimates_.front(), circles, attempt.arc(circles),
                                              attempt.margin);
      segments_ = region_parts(circles, std::min(attempt.lines_degree, room(0)));
    };
    // Whole circles have constant lines: there is nothing to try.
    if (circles.boundary.empty()) return plan(kRegionAttempts.front());
    for (const RegionAttempt& attempt : kRegionAttempts) {
      plan(attempt);
      do {
        // Around whole circles lines are constant, and there is nothing else to try.
        if (circles.boundary.empty() || is_region_covered(circles.boundary)) return;
      } while (halve_bad_segments(attempt.halvings));
    }
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "No patches with positive weights were found over the region; divide it "
                        "by heights, a box or sectors.");
  }

  /// Whole circles with constant lines, arcs with lines of this degree.
  static std::vector<Segment> region_parts(const RegionCircles& circles, int lines_degree) {
    const auto part = [](double begin, double end, Joint joint, Around around, int degree) {
      const Rational origin = Rational::exactly(begin);
      return Segment{0, begin, end, origin, Rational::exactly(end) - origin, joint, around, degree};
    };
    const auto& [low, high, is_closed, split, boundary] = circles;
    if (!is_closed) return {part(low, high, Joint::kNone, Around::kArc, lines_degree)};
    if (!split) return {part(low, high, Joint::kNone, Around::kHalves, 0)};
    return {part(low, *split, Joint::kNone, Around::kUnequalParts, 0),
            part(*split, high, Joint::kTangent, Around::kLargerPart, lines_degree)};
  }

  int room(std::size_t link) const { return room_for_lines(chain_.links[link].envelope); }

  template <class T>
  const SpinorMatrix<ComplexOf<T>>& spinor_of(std::size_t link) const {
    if constexpr (std::is_same_v<T, double>) {
      return estimates_[link].spinor;
    } else {
      return gammas_[link].spinor;
    }
  }

  template <class T>
  std::vector<SpinorMatrix<ComplexOf<T>>> restricted_spinors() const {
    std::vector<SpinorMatrix<ComplexOf<T>>> result(segments_.size());
    for_each_index(result.size(), [&](std::size_t i) {
      result[i] = restricted_spinor<T>(spinor_of<T>(segments_[i].link), segments_[i], precision_);
    });
    return result;
  }

  template <class T>
  std::vector<LineFactor<T>> factors_for(
      const std::vector<SpinorMatrix<ComplexOf<T>>>& spinors) const {
    const auto frames = [&](std::size_t i, int end) { return frame_at<T>(i, end, spinors[i]); };
    return FactorSequence<T>(segments_, chain_.closed, *target_, spinors, frames, precision_)
        .factors();
  }

  /// What lines are matched by at an end of a segment: A, or where the end is a torsal ruling, at
  /// which A is singular, the points of that ruling. Joints there are tangent only, without slopes.
  template <class T>
  EndValue<ComplexOf<T>> frame_at(std::size_t i, int end,
                                  const SpinorMatrix<ComplexOf<T>>& spinor) const {
    if (!ends_at_torsal_ruling(segments_[i], end)) return end_value(spinor, end);
    const auto rulings = std::get<RulingForms<T>>(carrier_of<T>(segments_[i]));
    const Matrix<T> frame = torsal_frame<T>(rulings, spinor, end);
    return {complexified<T>(frame), complexified<T>(scaled(frame, T(0.0)))};
  }

  bool ends_at_torsal_ruling(const Segment& segment, int end) const {
    const auto* rulings = std::get_if<RulingForms<RealBall>>(&gammas_[segment.link].carrier);
    const Rational place = end == 0 ? segment.origin : segment.origin + segment.length;
    if (!rulings || place != Rational(long{end})) return false;
    const RealBall at(end);
    return std::any_of(rulings->torsal_roots.begin(), rulings->torsal_roots.end(),
                       [&](const RealBall& root) { return (root - at).is_zero(); });
  }

  /// Refines every segment with uneven weights; false when there is none (any more).
  bool refine_uneven_segments() {
    const auto spinors = restricted_spinors<double>();
    const auto factors = factors_for<double>(spinors);
    const std::vector<CircleColumns> circle =
        circle_columns(lines_, lines_ == Lines::kEven ? kLeastArcs : kMostArcs, 2);
    std::vector<WeightRange> ranges(segments_.size());
    for_each_index(ranges.size(), [&](std::size_t i) {
      const auto spinor = lined<double>(spinors[i], factors[i]);
      ranges[i] = weight_range(isotropic_vector<double>(spinor)[3], circle);
    });
    double largest = 0;
    for (const WeightRange& range : ranges) largest = std::max(largest, range.largest);
    const double least = lines_ == Lines::kEven ? kLeastWeightRatio * largest : 0;
    bool changed = false;
    std::vector<Segment> refined;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const bool is_uneven =
          ranges[i].least <= least && can_be_refined(segments_[i], kMostSegmentHalvings);
      changed = changed || is_uneven;
      const std::vector<Segment> parts =
          is_uneven ? refinement(segments_[i]) : std::vector<Segment>{segments_[i]};
      refined.insert(refined.end(), parts.begin(), parts.end());
    }
    segments_ = std::move(refined);
    return changed;
  }

  /// Where a segment would be halved, which is not inside when its ends are neighbours: in the
  /// middle, or beside it where that is too near to a torsal ruling, on which lines cannot be
  /// matched.
  double cut_of(const Segment& segment) const {
    const double length = segment.end - segment.begin, middle = segment.begin + length / 2;
    const auto* rulings = std::get_if<RulingForms<double>>(&estimates_[segment.link].carrier);
    if (!rulings) return middle;
    const double in_link = segment.middle(), near = segment.length.to_double() / 32;
    const bool is_torsal =
        std::any_of(rulings->torsal_roots.begin(), rulings->torsal_roots.end(),
                    [&](double root) { return std::abs(root - in_link) < near; });
    return is_torsal ? segment.begin + length * 7 / 16 : middle;
  }

  bool can_be_refined(const Segment& segment, int most_halvings) const {
    const double cut = cut_of(segment);
    const bool has_cut = segment.begin < cut && cut < segment.end;
    return has_cut && segment.halvings < most_halvings && room(segment.link) > 0;
  }

  /// Finds the segments of a band that do not reach its directrices or have uneven weights.
  bool is_band_covered(double least_weight_ratio) {
    const auto spinors = restricted_spinors<double>();
    const auto factors = factors_for<double>(spinors);
    const std::vector<CircleColumns> band = {straight_band(1, 4)};
    bad_.assign(segments_.size(), 0);
    for_each_index(segments_.size(), [&](std::size_t i) {
      const Carrier<double> carrier = carrier_of<double>(segments_[i]);
      const auto w = isotropic_vector<double>(lined<double>(spinors[i], factors[i]));
      const auto& rulings = std::get<RulingForms<double>>(carrier);
      const WeightRange weights = weight_range(section_weight(rulings, w), band);
      const bool is_even = weights.least > least_weight_ratio * weights.largest;
      bad_[i] = !is_even || !reaches(directrix_forms(rulings, w));
    });
    return std::none_of(bad_.begin(), bad_.end(), [](char bad) { return bad != 0; });
  }

  /// Finds the segments of a region whose lines do not hold it or have uneven weights.
  bool is_region_covered(const std::vector<BoundaryPlace>& boundary) {
    const auto spinors = restricted_spinors<double>();
    const auto factors = factors_for<double>(spinors);
    bad_.assign(segments_.size(), 0);
    for_each_index(segments_.size(), [&](std::size_t i) {
      const auto w = isotropic_vector<double>(lined<double>(spinors[i], factors[i]));
      const FormInU<double> weight = sections(carrier_of<double>(segments_[i]), w).weight;
      bad_[i] = !is_even(weight, segments_[i].around) || !holds(boundary, segments_[i], factors[i]);
    });
    return std::none_of(bad_.begin(), bad_.end(), [](char bad) { return bad != 0; });
  }

  /// Places on a segment, along and around, at which its weight is looked at.
  static constexpr int kWeightSamples = 17;

  static bool is_even(const FormInU<double>& weight, Around around) {
    double least = HUGE_VAL, largest = -HUGE_VAL;
    for (int i = 0; i < kWeightSamples; ++i) {
      for (int j = 0; j < kWeightSamples; ++j) {
        const double part = static_cast<double>(j) / (kWeightSamples - 1);
        const Eigen::Vector2d u = direction_across(around, part);
        const double at = value(weight, static_cast<double>(i) / (kWeightSamples - 1), u(0), u(1));
        least = std::min(least, at);
        largest = std::max(largest, at);
      }
    }
    return least > kLeastRatioOfRegions * largest;
  }

  /// u at a part of what is taken of the circle.
  static Eigen::Vector2d direction_across(Around around, double part) {
    if (around == Around::kArc) return {1 - part, part};
    const int arcs = around == Around::kLargerPart ? kArcsOfLargerPart : kLeastArcs;
    return circle_point(arcs * part, kLeastArcs);
  }

  static bool holds(const std::vector<BoundaryPlace>& boundary, const Segment& segment,
                    const LineFactor<double>& factor) {
    return std::all_of(boundary.begin(), boundary.end(), [&](const BoundaryPlace& place) {
      if (place.t < segment.begin || place.t > segment.end) return true;
      const double local = (place.t - segment.begin) / (segment.end - segment.begin);
      const Eigen::Vector2d direction(std::cos(place.angle), std::sin(place.angle));
      return is_across(segment.around, value_at(factor, local).inverse() * direction);
    });
  }

  static bool is_across(Around around, const Eigen::Vector2d& u) {
    if (around == Around::kArc) return u(0) * u(1) > 0;
    if (around != Around::kLargerPart) return true;
    return circle_parameter(u(0), u(1), kLeastArcs) < kArcsOfLargerPart;
  }

  /// The carrier of a segment in its own parameter; in doubles nearly.
  template <class T>
  Carrier<T> carrier_of(const Segment& segment) const {
    const auto in_balls = [&] {
      return restricted_carrier(gammas_[segment.link].carrier, segment, precision_);
    };
    if constexpr (std::is_same_v<T, double>) {
      return segment.is_whole_link() ? estimates_[segment.link].carrier : midpoint(in_balls());
    } else {
      return in_balls();
    }
  }

  static bool reaches(const DirectrixForms<double>& directrices) {
    for (const FormInU<double>& directrix : directrices) {
      for (int i = 0; i < kBandSamples; ++i) {
        const double s = band_parameter(directrix, static_cast<double>(i) / (kBandSamples - 1));
        if (!(s > 0 && s < 1)) return false;
      }
    }
    return true;
  }

  bool halve_bad_segments(int most_halvings) {
    bool changed = false;
    std::vector<Segment> refined;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const Segment& segment = segments_[i];
      if (bad_[i] && can_be_refined(segment, most_halvings)) {
        const auto parts = halves(segment, cut_of(segment),
                                  segment.lines_degree == 3 ? Joint::kSmooth : Joint::kTangent);
        refined.insert(refined.end(), parts.begin(), parts.end());
        changed = true;
      } else {
        refined.push_back(segment);
      }
    }
    segments_ = std::move(refined);
    return changed;
  }

  /// Lines that may turn, where they were constant; otherwise two halves.
  std::vector<Segment> refinement(Segment segment) const {
    if (segment.lines_degree == 0) {
      segment.lines_degree = 1;
      return {segment};
    }
    const auto parts = halves(segment, cut_of(segment),
                              segment.lines_degree == 3 ? Joint::kSmooth : Joint::kTangent);
    return {parts.begin(), parts.end()};
  }

  const EnvelopeChain& chain_;
  Lines lines_;
  long precision_;
  std::vector<IsotropicHypersurface<RealBall>> gammas_;
  std::vector<IsotropicHypersurface<double>> estimates_;
  std::unique_ptr<const TargetLines> target_;
  std::vector<Segment> segments_;
  std::vector<char> bad_;  ///< of a band: the segments to be halved
};

/// Developable strips have their rulings for lines already.
std::vector<LinedSegment> strip_segments(const EnvelopeChain& chain, long precision) {
  std::vector<LinedSegment> segments(chain.links.size());
  for_each_index(segments.size(), [&](std::size_t i) {
    const ChainLink& link = chain.links[i];
    const Carrier<RealBall> carrier = link.envelope.enclosure(precision).carrier;
    segments[i] = {{false, link.begin, link.end, link.joint_before, Around::kArc,
                    sections(carrier, IsotropicVector<RealBall>{})},
                   midpoint(carrier),
                   {}};
  });
  return segments;
}

}  // namespace

std::vector<LinedSegment> lined_segments(const EnvelopeChain& chain, Lines lines, long precision) {
  if (std::holds_alternative<Strip>(chain.extent)) return strip_segments(chain, precision);
  if (chain.closed && room_for_lines(chain.links.back().envelope) == 0) {
    throw GeometryError(
        ErrorCode::kDegreeTooHigh,
        "The closed surface needs a degree above " + std::to_string(kLargestDegree) +
            " to bring its lines back to where they began; lower the degree of spine "
            "and radius.");
  }
  return Planner(chain, lines, precision).segments();
}

}  // namespace pn
