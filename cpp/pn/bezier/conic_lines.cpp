// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_lines.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/conic_seam.hpp"
#include "pn/bezier/ellipse_parameter.hpp"
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
HomogeneousConic<T> on_segment(const HomogeneousConic<T>& x, const Segment& segment) {
  if (segment.length == 1) return x;
  HomogeneousConic<T> result;
  for (std::size_t c = 0; c < 4; ++c) {
    for (const Form<T>& form : x[c].coefficient) {
      result[c].coefficient.push_back(form.on_interval(T(segment.begin), T(segment.length)));
    }
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
                 const std::vector<HomogeneousConic<T>>& spans)
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

  /// F at one end whose lines meet those of F at another end with the same ellipse.
  Matrix<T> met(const End& own, const End& other, const Matrix<T>& factor) const {
    const EllipseFrame<T> from = ellipse_frame(spans_[other.span], T(other.t)),
                          to = ellipse_frame(spans_[own.span], T(own.t));
    const Matrix<T> result = inverse(to.circle) * (least_turn(from, to) * (from.circle * factor));
    const Eigen::Matrix2d near = target_.at(own.span, own.t);
    return (near.inverse() * midpoint(result)).trace() < 0 ? scaled(result, T(-1.0)) : result;
  }

  const std::vector<Segment>& segments_;
  bool closed_;
  const TargetLines& target_;
  const std::vector<HomogeneousConic<T>>& spans_;
  std::vector<LineFactor<T>> factors_;
};

class Planner {
 public:
  Planner(const EllipseChain& chain, Lines lines, long precision)
      : chain_(chain), lines_(lines), spans_(chain.spans.size()), estimates_(spans_.size()) {
    for_each_index(spans_.size(), [&](std::size_t i) {
      spans_[i] = (*chain.spans[i])(precision);
      estimates_[i] = pn::midpoint(spans_[i]);
    });
    target_ = std::make_unique<ConicSeam>(estimates_, chain.closed);
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const int degree = lines == Lines::kEven ? std::min(1, room(i)) : 0;
      segments_.push_back({i, 0, 1, degree});
    }
    // The last lines of a closed surface have to come back to the first.
    if (chain.closed) segments_.back().lines_degree = 1;
  }

  std::vector<SectionSegment> segments() {
    while (refine_uneven_segments()) {
    }
    const auto factors = factors_for<RealBall>(spans_);
    std::vector<SectionSegment> result(segments_.size());
    for_each_index(result.size(), [&](std::size_t i) {
      const Segment& segment = segments_[i];
      const HomogeneousConic<RealBall> x = on_segment(spans_[segment.span], segment);
      const auto span = static_cast<double>(segment.span);
      result[i] = {false,
                   span + segment.begin,
                   span + segment.end(),
                   i == 0 ? Joint::kNone : Joint::kTangent,
                   Around::kCircle,
                   {{lined(x[0], factors[i]), lined(x[1], factors[i]), lined(x[2], factors[i])},
                    {},
                    lined(x[3], factors[i])}};
    });
    return result;
  }

 private:
  /// Room for the degree of F under OpenCASCADE's limit.
  int room(std::size_t span) const {
    return std::max(0, (kLargestDegree - chain_.spans[span]->degree()) / 2);
  }

  template <class T>
  std::vector<LineFactor<T>> factors_for(const std::vector<HomogeneousConic<T>>& spans) const {
    return FactorSequence<T>(segments_, chain_.closed, *target_, spans).factors();
  }

  /// Refines every segment with uneven weights; false when there is none (any more).
  bool refine_uneven_segments() {
    const auto factors = factors_for<double>(estimates_);
    const std::vector<CircleColumns> circle =
        circle_columns(lines_, lines_ == Lines::kEven ? kLeastArcs : kMostArcs, 2);
    bool changed = false;
    std::vector<Segment> refined;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const Segment& segment = segments_[i];
      const FormInU<double> weight = on_segment(estimates_[segment.span], segment)[3];
      const WeightRange range = weight_range(lined(weight, factors[i]), circle);
      const double least = lines_ == Lines::kEven ? kLeastWeightRatio * range.largest : 0;
      const bool is_uneven = range.least <= least && can_be_refined(segment);
      changed = changed || is_uneven;
      const std::vector<Segment> parts =
          is_uneven ? refinement(segment) : std::vector<Segment>{segment};
      refined.insert(refined.end(), parts.begin(), parts.end());
    }
    segments_ = std::move(refined);
    return changed;
  }

  bool can_be_refined(const Segment& segment) const {
    return segment.halvings < kMostSegmentHalvings && room(segment.span) > 0;
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

  const EllipseChain& chain_;
  Lines lines_;
  std::vector<HomogeneousConic<RealBall>> spans_;
  std::vector<HomogeneousConic<double>> estimates_;
  std::unique_ptr<const TargetLines> target_;
  std::vector<Segment> segments_;
};

}  // namespace

std::vector<SectionSegment> lined_segments(const EllipseChain& chain, Lines lines, long precision) {
  if (chain.closed && chain.spans.back()->degree() + 2 > kLargestDegree) {
    throw GeometryError(ErrorCode::kDegreeTooHigh,
                        "The closed surface needs a degree above " +
                            std::to_string(kLargestDegree) +
                            " to bring its lines back to where they began.");
  }
  return Planner(chain, lines, precision).segments();
}

}  // namespace pn
