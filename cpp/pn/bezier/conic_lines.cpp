// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_lines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/conic_parameter.hpp"
#include "pn/bezier/conic_seam.hpp"
#include "pn/bezier/line_factor.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using namespace lines;

/// A target that turns by less than this costs no degree: lines that are nearly even are as good.
constexpr double kNoTurn = 0x1p-20;

/// A part of a span whose lines are one polynomial F. All its numbers are dyadic, so that the knots
/// say exactly where segments meet.
struct Segment {
  std::size_t span;
  double begin, length;  ///< in the span's parameter on [0, 1]
  int lines_degree;
  int halvings = 0;

  double end() const { return begin + length; }
};

template <class T>
FormInU<T> on_segment(const FormInU<T>& x, const Segment& segment) {
  if (segment.length == 1) return x;
  FormInU<T> result;
  for (const Form<T>& form : x.coefficient) {
    result.coefficient.push_back(form.on_interval(T(segment.begin), T(segment.length)));
  }
  return result;
}

/// The form in u of F u.
template <class T>
FormInU<T> lined(const FormInU<T>& x, const LineFactor<T>& factor) {
  std::array<std::array<Form<T>, 2>, 2> f;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      std::vector<T> coefficients;
      for (const Matrix<T>& c : factor.coefficients) coefficients.push_back(c[i][j]);
      f[i][j] = Form<T>(std::move(coefficients));
    }
  }
  const auto polar = [&](std::size_t p, std::size_t q) {
    Form<T> sum = x.coefficient[0] * (f[0][p] * f[0][q]);
    sum += x.coefficient[1] * (f[0][p] * f[1][q] + f[1][p] * f[0][q]);
    return sum + x.coefficient[2] * (f[1][p] * f[1][q]);
  };
  return {{polar(0, 0), polar(0, 1), polar(1, 1)}};
}

template <class T>
LineFactor<T> joined(const Matrix<T>& left, const Matrix<T>& right) {
  const Eigen::Matrix2d a = midpoint(left), b = midpoint(right);
  return (b - a).norm() < kNoTurn * a.norm() ? constant_line(left) : line_through(left, right);
}

/// F on each segment, in doubles or in balls.
template <class T>
class FactorSequence {
 public:
  FactorSequence(const std::vector<Segment>& segments, bool closed, const TargetLines& target,
                 const std::vector<ConicForms<T>>& spans)
      : segments_(segments), closed_(closed), target_(target), spans_(spans) {}

  std::vector<LineFactor<T>> factors() {
    for (std::size_t i = 0; i < segments_.size(); ++i) factors_.push_back(factor(i));
    return std::move(factors_);
  }

 private:
  LineFactor<T> factor(std::size_t i) const {
    const Segment& segment = segments_[i];
    const bool closes = closed_ && i + 1 == segments_.size();
    const bool is_first = i == 0;
    if (segment.lines_degree == 0) {
      return constant_line(is_first ? chosen(segment, segment.begin + segment.length / 2)
                                    : met_at_left(i));
    }
    const Matrix<T> left = is_first ? chosen(segment, segment.begin) : met_at_left(i);
    if (!closes) return joined(left, chosen(segment, segment.end()));
    return line_through(left, met({segment.span, 1}, {0, 0}, is_first ? left : first_left()));
  }

  Matrix<T> first_left() const { return factors_.front().ends[0].value; }

  Matrix<T> met_at_left(std::size_t i) const {
    const Matrix<T>& before = factors_[i - 1].ends[1].value;
    if (segments_[i].begin > 0) return before;
    return met({segments_[i].span, 0}, {segments_[i - 1].span, 1}, before);
  }

  Matrix<T> chosen(const Segment& segment, double t) const {
    return short_doubles<T>(target_.at(segment.span, t));
  }

  /// An end of a span.
  struct End {
    std::size_t span;
    int t;
  };

  /// F at one end whose lines meet those of F at another end with the same conic.
  Matrix<T> met(const End& own, const End& other, const Matrix<T>& factor) const {
    const ConicFrame<T> from = conic_frame(spans_[other.span], T(other.t)),
                        to = conic_frame(spans_[own.span], T(own.t));
    const Matrix<T> result = inverse(to.circle) * (least_turn(from, to) * (from.circle * factor));
    const Eigen::Matrix2d near = target_.at(own.span, own.t);
    return (near.inverse() * midpoint(result)).trace() < 0 ? scaled(result, T(-1.0)) : result;
  }

  const std::vector<Segment>& segments_;
  bool closed_;
  const TargetLines& target_;
  const std::vector<ConicForms<T>>& spans_;
  std::vector<LineFactor<T>> factors_;
};

/// What is smaller in parts of the other coefficients is zero in the last place of every pole.
constexpr double kNothing = 0x1p-80;

/// The lines that are the ends of arcs, where they are linear in t in the parameter of the family.
class LinesOfEnds {
 public:
  explicit LinesOfEnds(const std::vector<ConicForms<RealBall>>& spans) : spans_(spans) {}

  /// F on each span; nothing where some end is no line.
  std::optional<std::vector<LineFactor<RealBall>>> factors() const {
    std::vector<LineFactor<RealBall>> result;
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const Matrix<RealBall> left =
          i == 0 ? ends_of_arc(spans_[0], RealBall(0)) : met(i, result.back().ends[1].value);
      result.push_back(continued_from(left, spans_[i]));
      const FormInU<RealBall> cut = lined(spans_[i].cut, result.back());
      if (!vanishes(cut.coefficient[0], cut) || !vanishes(cut.coefficient[2], cut)) return {};
    }
    return result;
  }

 private:
  using Vector = std::array<RealBall, 2>;

  static Vector column(const Matrix<RealBall>& a, std::size_t j) { return {a[0][j], a[1][j]}; }
  static RealBall cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }

  Matrix<RealBall> met(std::size_t span, const Matrix<RealBall>& before) const {
    const auto from = conic_frame(spans_[span - 1], RealBall(1)),
               to = conic_frame(spans_[span], RealBall(0));
    return inverse(to.circle) * (least_turn(from, to) * (from.circle * before));
  }

  /// From the ends at t = 0 to those at t = 1, of the size with which the middle is right too.
  static LineFactor<RealBall> continued_from(const Matrix<RealBall>& left,
                                             const ConicForms<RealBall>& span) {
    const Matrix<RealBall> middle = ends_of_arc(span, RealBall(0.5)),
                           last = ends_of_arc(span, RealBall(1));
    const Matrix<RealBall> first = ends_of_arc(span, RealBall(0));
    // The ends may come in the other order.
    const bool keeps_order = std::abs(cross(column(left, 0), column(first, 0)).midpoint()) <
                             std::abs(cross(column(left, 0), column(first, 1)).midpoint());
    Matrix<RealBall> right = left;
    for (std::size_t j = 0; j < 2; ++j) {
      const std::size_t k = keeps_order ? j : 1 - j;
      const RealBall before = cross(column(left, j), column(middle, k)),
                     after = cross(column(last, k), column(middle, k));
      // A line that does not turn keeps its size.
      if (after.contains_zero()) continue;
      const RealBall size = -before / after;
      for (std::size_t i = 0; i < 2; ++i) right[i][j] = last[i][k] * size;
    }
    return joined(left, right);
  }

  static bool vanishes(const Form<RealBall>& form, const FormInU<RealBall>& cut) {
    double size = 0, largest = 0;
    for (const RealBall& c : cut.coefficient[1].coefficients()) {
      size = std::max(size, c.magnitude_upper());
    }
    for (const RealBall& c : form.coefficients()) {
      if (!c.contains_zero()) return false;
      largest = std::max(largest, c.magnitude_upper());
    }
    return largest <= kNothing * size;
  }

  const std::vector<ConicForms<RealBall>>& spans_;
};

/// Weights along arcs may vary by this factor, as between a vertex and far points.
constexpr double kLeastRatioOfArcs = 2e-3;

/// How the lines of arcs are tried: the degree of F, the margin beyond the arcs as a part of them,
/// and how often segments may be halved.
struct ArcAttempt {
  int lines_degree;
  double margin;
  int halvings;
};

/// From few poles to what always ends well.
constexpr std::array<ArcAttempt, 6> kArcAttempts = {
    {{0, 0.02, 0}, {1, 0.02, 0}, {1, 0.1, 0}, {1, 0.1, 2}, {1, 0.02, 6}, {1, 0.1, 10}}};

/// Places on a segment at which the band is compared with its arcs.
constexpr int kBandSamples = 129;

class Planner {
 public:
  Planner(const ConicChain& chain, Lines lines, long precision)
      : chain_(chain), lines_(lines), spans_(chain.spans.size()), estimates_(spans_.size()) {
    for_each_index(spans_.size(), [&](std::size_t i) {
      spans_[i] = (*chain.spans[i])(precision);
      estimates_[i] = pn::midpoint(spans_[i]);
    });
  }

  std::vector<ConicSegment> segments() {
    if (chain_.has_cuts()) {
      if (const auto factors = lines_of_ends()) return lined_with(*factors);
      plan_arcs();
    } else {
      plan_ellipses();
    }
    return lined_with(factors_for<RealBall>(spans_));
  }

 private:
  std::vector<ConicSegment> lined_with(const std::vector<LineFactor<RealBall>>& factors) const {
    std::vector<ConicSegment> result(segments_.size());
    for_each_index(result.size(), [&](std::size_t i) {
      const Segment& segment = segments_[i];
      const auto form = [&](const FormInU<RealBall>& x) {
        return lined(on_segment(x, segment), factors[i]);
      };
      const auto& [point, cut] = spans_[segment.span];
      const auto span = static_cast<double>(segment.span);
      result[i] = {{false,
                    span + segment.begin,
                    span + segment.end(),
                    i == 0 ? Joint::kNone : Joint::kTangent,
                    chain_.has_cuts() ? Around::kArc : Around::kCircle,
                    {{form(point[0]), form(point[1]), form(point[2])}, {}, form(point[3])}},
                   is_trimmed_ ? pn::midpoint(form(cut)) : FormInU<double>{}};
    });
    return result;
  }

  /// Lines that end where the arcs do, if these are rational and there are such lines.
  std::optional<std::vector<LineFactor<RealBall>>> lines_of_ends() {
    whole_spans(1);
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      if (chain_.closed || room(i) == 0 || !chain_.spans[i]->has_rational_ends()) return {};
    }
    auto factors = LinesOfEnds(spans_).factors();
    if (!factors) return {};
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const FormInU<double> weight = pn::midpoint(lined(spans_[i].point[3], (*factors)[i]));
      if (!has_even_weights(weight)) return {};
    }
    return factors;
  }

  void plan_ellipses() {
    target_ = std::make_unique<ConicSeam>(estimates_, chain_.closed);
    whole_spans(lines_ == Lines::kEven ? 1 : 0);
    do {
      find_bad_segments(&Planner::is_even);
    } while (refine_bad_segments(kMostSegmentHalvings));
  }

  void plan_arcs() {
    is_trimmed_ = true;
    for (const ArcAttempt& attempt : kArcAttempts) {
      target_ = std::make_unique<ArcLines>(estimates_, attempt.margin);
      whole_spans(attempt.lines_degree);
      do {
        find_bad_segments(&Planner::holds_arcs);
        if (std::none_of(bad_.begin(), bad_.end(), [](char bad) { return bad != 0; })) return;
      } while (refine_bad_segments(attempt.halvings));
    }
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "No patches with positive weights were found along the arcs: one of them "
                        "nearly reaches infinity, or nearly vanishes.");
  }

  /// Lines of this degree, where there is room for it.
  void whole_spans(int lines_degree) {
    segments_.clear();
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      segments_.push_back({i, 0, 1, std::min(lines_degree, room(i))});
    }
    // The last lines of a closed surface have to come back to the first.
    if (chain_.closed) segments_.back().lines_degree = 1;
  }

  /// Room for the degree of F under OpenCASCADE's limit.
  int room(std::size_t span) const {
    return std::max(0, (kLargestDegree - chain_.spans[span]->degree()) / 2);
  }

  template <class T>
  std::vector<LineFactor<T>> factors_for(const std::vector<ConicForms<T>>& spans) const {
    return FactorSequence<T>(segments_, chain_.closed, *target_, spans).factors();
  }

  /// Whether the lines of a segment are good.
  using IsGood = bool (Planner::*)(const Segment&, const LineFactor<double>&) const;

  void find_bad_segments(IsGood is_good) {
    const auto factors = factors_for<double>(estimates_);
    bad_.assign(segments_.size(), 0);
    for_each_index(segments_.size(),
                   [&](std::size_t i) { bad_[i] = !(this->*is_good)(segments_[i], factors[i]); });
  }

  bool is_even(const Segment& segment, const LineFactor<double>& factor) const {
    const std::vector<CircleColumns> circle =
        circle_columns(lines_, lines_ == Lines::kEven ? kLeastArcs : kMostArcs, 2);
    const FormInU<double>& weight = estimates_[segment.span].point[3];
    const auto [least, largest] = weight_range(lined(on_segment(weight, segment), factor), circle);
    return least > (lines_ == Lines::kEven ? kLeastWeightRatio * largest : 0);
  }

  /// The arcs are inside the band, on which the weights are positive and not too uneven.
  bool holds_arcs(const Segment& segment, const LineFactor<double>& factor) const {
    const auto& [point, cut] = estimates_[segment.span];
    const auto& q = lined(on_segment(cut, segment), factor).coefficient;
    for (int k = 0; k < kBandSamples; ++k) {
      const double t = static_cast<double>(k) / (kBandSamples - 1);
      if (!(q[0](t) < 0 && q[1](t) > 0 && q[2](t) < 0)) return false;
    }
    return has_even_weights(lined(on_segment(point[3], segment), factor));
  }

  static bool has_even_weights(const FormInU<double>& weight) {
    const auto [least, largest] = weight_range(weight, {straight_band(kMostArcs / kLeastArcs, 2)});
    return least > kLeastRatioOfArcs * largest;
  }

  /// Refines every bad segment; false when there is none (any more).
  bool refine_bad_segments(int most_halvings) {
    bool changed = false;
    std::vector<Segment> refined;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const Segment& segment = segments_[i];
      const bool refine =
          bad_[i] != 0 && segment.halvings < most_halvings && room(segment.span) > 0;
      changed = changed || refine;
      const std::vector<Segment> parts =
          refine ? refinement(segment) : std::vector<Segment>{segment};
      refined.insert(refined.end(), parts.begin(), parts.end());
    }
    segments_ = std::move(refined);
    return changed;
  }

  /// Lines that may turn, where they were constant; otherwise two halves.
  static std::vector<Segment> refinement(Segment segment) {
    if (segment.lines_degree == 0) {
      segment.lines_degree = 1;
      return {segment};
    }
    segment.length /= 2;
    ++segment.halvings;
    Segment right = segment;
    right.begin += right.length;
    return {segment, right};
  }

  const ConicChain& chain_;
  Lines lines_;
  std::vector<ConicForms<RealBall>> spans_;
  std::vector<ConicForms<double>> estimates_;
  std::unique_ptr<const TargetLines> target_;
  std::vector<Segment> segments_;
  std::vector<char> bad_;  ///< the segments to be refined
  bool is_trimmed_ = false;
};

}  // namespace

std::vector<ConicSegment> lined_segments(const ConicChain& chain, Lines lines, long precision) {
  if (chain.closed && chain.spans.back()->degree() + 2 > kLargestDegree) {
    throw GeometryError(ErrorCode::kDegreeTooHigh,
                        "The closed surface needs a degree above " +
                            std::to_string(kLargestDegree) +
                            " to bring its lines back to where they began.");
  }
  return Planner(chain, lines, precision).segments();
}

}  // namespace pn
