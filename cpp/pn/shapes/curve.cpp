// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/curve.hpp"

#include <algorithm>
#include <string>

#include "pn/algebra/parallel.hpp"
#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"
#include "pn/shapes/blossom.hpp"

namespace pn {

template <std::size_t Dimension>
bool joins(const RationalSpan<Dimension>& left, const RationalSpan<Dimension>& right) {
  const Rational one(1), zero(0);
  for (std::size_t c = 0; c < Dimension; ++c) {
    if (left.numerator[c](one) * right.denominator(zero) !=
        right.numerator[c](zero) * left.denominator(one)) {
      return false;
    }
  }
  return true;
}

template bool joins(const RationalSpan<3>&, const RationalSpan<3>&);

namespace {

template <std::size_t Dimension>
void require_numbers(const BSplineData<Dimension>& data) {
  require_input_numbers(data.knots, "A knot");
  require_input_numbers(data.weights, "A weight");
  for (const auto& pole : data.poles) require_input_numbers(pole, "A coordinate of a pole");
}

template <std::size_t Dimension>
void require_weights(const BSplineData<Dimension>& data) {
  if (data.weights.empty()) return;
  if (data.weights.size() != data.poles.size()) {
    throw GeometryError(ErrorCode::kWrongShape, "There are " + std::to_string(data.weights.size()) +
                                                    " weights for " +
                                                    std::to_string(data.poles.size()) + " poles.");
  }
  const auto place = std::find_if(data.weights.begin(), data.weights.end(),
                                  [](double weight) { return weight <= 0; });
  if (place == data.weights.end()) return;
  throw GeometryError(ErrorCode::kNonPositiveWeight,
                      "Weight number " + std::to_string(place - data.weights.begin() + 1) + " is " +
                          std::to_string(*place) + "; weights must be positive.");
}

template <std::size_t Dimension>
void require_valid(const BSplineData<Dimension>& data) {
  if (data.degree < 1 || data.poles.size() < 2) {
    throw GeometryError(ErrorCode::kWrongShape,
                        "A curve or law needs at least two poles and a degree of at least 1.");
  }
  require_numbers(data);
  require_weights(data);
  require_clamped(data.degree, data.knots, data.multiplicities, data.poles.size());
}

template <std::size_t Dimension>
void require_continuous(const PiecewiseRational<Dimension>& function) {
  for (std::size_t i = 0; i + 1 < function.spans.size(); ++i) {
    if (joins(function.spans[i], function.spans[i + 1])) continue;
    throw GeometryError(ErrorCode::kGap, "There is a gap at parameter " +
                                             std::to_string(function.breaks[i + 1].to_double()) +
                                             ": the spans do not meet.");
  }
}

template <std::size_t Dimension>
PiecewiseRational<Dimension> piecewise(const BSplineData<Dimension>& data) {
  require_valid(data);
  const auto degree = static_cast<std::size_t>(data.degree);
  PiecewiseRational<Dimension> function;
  function.breaks = exactly(data.knots);
  const std::vector<Rational> flat = flat_knots(function.breaks, data.multiplicities);
  const std::vector<Rational> weights = scaled_weights(data.weights, data.poles.size());
  std::array<std::vector<Rational>, Dimension> homogeneous;
  for (std::size_t c = 0; c < Dimension; ++c) {
    for (std::size_t i = 0; i < data.poles.size(); ++i) {
      homogeneous[c].push_back(Rational::exactly(data.poles[i][c]) * weights[i]);
    }
  }
  const std::vector<std::size_t> last = span_places(data.multiplicities);
  function.spans.resize(last.size());
  for_each_index(last.size(), [&](std::size_t span) {
    RationalSpan<Dimension>& result = function.spans[span];
    for (std::size_t c = 0; c < Dimension; ++c) {
      result.numerator[c] = span_polynomial(flat, last[span], degree, homogeneous[c]);
    }
    result.denominator = data.weights.empty() ? RationalPolynomial(1L)
                                              : span_polynomial(flat, last[span], degree, weights);
  });
  require_continuous(function);
  return function;
}

/// The part of a function over [begin, end], which lies within one of its spans.
template <std::size_t Dimension>
RationalSpan<Dimension> restricted(const PiecewiseRational<Dimension>& function,
                                   const Rational& begin, const Rational& end) {
  const auto after = std::upper_bound(function.breaks.begin(), function.breaks.end(), begin);
  const auto index = static_cast<std::size_t>(after - function.breaks.begin()) - 1;
  const Rational& first = function.breaks[index];
  const Rational length = function.breaks[index + 1] - first;
  RationalSpan<Dimension> span = function.spans[index];
  if (first == begin && function.breaks[index + 1] == end) return span;
  const Rational origin = (begin - first) / length, part = (end - begin) / length;
  for (RationalPolynomial& p : span.numerator) p = p.on_interval(origin, part);
  span.denominator = span.denominator.on_interval(origin, part);
  return span;
}

template <std::size_t Dimension>
BSplineData<Dimension> bezier_data(const std::vector<std::array<double, Dimension>>& poles,
                                   const std::vector<double>& weights) {
  const int degree = static_cast<int>(poles.size()) - 1;
  return {degree, {0, 1}, {degree + 1, degree + 1}, poles, weights};
}

}  // namespace

template <std::size_t Dimension>
PiecewiseRational<Dimension> refined(const PiecewiseRational<Dimension>& function,
                                     const std::vector<Rational>& breaks) {
  PiecewiseRational<Dimension> result{breaks,
                                      std::vector<RationalSpan<Dimension>>(breaks.size() - 1)};
  for_each_index(result.spans.size(), [&](std::size_t i) {
    result.spans[i] = restricted(function, breaks[i], breaks[i + 1]);
  });
  return result;
}

template PiecewiseRational<1> refined(const PiecewiseRational<1>&, const std::vector<Rational>&);
template PiecewiseRational<3> refined(const PiecewiseRational<3>&, const std::vector<Rational>&);

Curve Curve::bezier(const std::vector<std::array<double, 3>>& poles,
                    const std::vector<double>& weights) {
  return bspline(bezier_data(poles, weights));
}

Curve Curve::bspline(const BSplineData<3>& data) { return Curve(piecewise(data)); }

Curve Curve::chain(const std::vector<Curve>& curves) {
  if (curves.empty()) throw GeometryError(ErrorCode::kWrongShape, "There is no curve to chain.");
  PiecewiseRational<3> function = curves.front().function_;
  for (std::size_t i = 1; i < curves.size(); ++i) {
    const PiecewiseRational<3>& next = curves[i].function_;
    const Rational shift = function.breaks.back() - next.breaks.front();
    for (std::size_t j = 1; j < next.breaks.size(); ++j) {
      // Breaks only label the spans, so they may be rounded to the doubles that knots must be.
      const Rational rounded = Rational::exactly((next.breaks[j] + shift).to_double());
      if (!(function.breaks.back() < rounded)) {
        throw GeometryError(ErrorCode::kBadKnots,
                            "Curve number " + std::to_string(i + 1) +
                                " of the chain has a domain too short beside those before it.");
      }
      function.breaks.push_back(rounded);
    }
    function.spans.insert(function.spans.end(), next.spans.begin(), next.spans.end());
  }
  require_continuous(function);
  return Curve(std::move(function));
}

int Curve::degree() const {
  int degree = 0;
  for (const RationalSpan<3>& span : function_.spans) {
    for (const RationalPolynomial& p : span.numerator) degree = std::max(degree, p.degree());
    degree = std::max(degree, span.denominator.degree());
  }
  return degree;
}

Law Law::constant(double value) {
  require_input_number(value, "The radius");
  Law law({{Rational(0), Rational(1)}, {{{RationalPolynomial(Rational::exactly(value))}, 1L}}});
  law.fits_any_domain_ = true;
  return law;
}

Law Law::bezier(const std::vector<double>& coefficients, const std::vector<double>& weights) {
  std::vector<std::array<double, 1>> poles;
  for (const double coefficient : coefficients) poles.push_back({coefficient});
  return bspline(bezier_data(poles, weights));
}

Law Law::bspline(const BSplineData<1>& data) { return Law(piecewise(data)); }

PiecewiseRational<1> Law::over(const Rational& begin, const Rational& end) const {
  PiecewiseRational<1> function = function_;
  if (fits_any_domain_) {
    function.breaks = {begin, end};
  } else if (function.breaks.front() != begin || function.breaks.back() != end) {
    const auto show = [](const Rational& x) { return std::to_string(x.to_double()); };
    throw GeometryError(ErrorCode::kDomainMismatch,
                        "The law is defined over parameters " + show(function.breaks.front()) +
                            " to " + show(function.breaks.back()) + ", the spine over " +
                            show(begin) + " to " + show(end) +
                            "; give both the same knots at their ends.");
  }
  return function;
}

SphereSpline SphereSpline::bezier(const std::vector<std::array<double, 4>>& spheres) {
  return bspline(bezier_data(spheres, {}));
}

SphereSpline SphereSpline::bspline(const BSplineData<4>& data) {
  return SphereSpline(piecewise(data));
}

}  // namespace pn
