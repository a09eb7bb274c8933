// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/curve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/parallel.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

template <std::size_t Dimension>
void require_finite(const BSplineData<Dimension>& data) {
  const auto finite = [](double x) { return std::isfinite(x); };
  bool all = std::all_of(data.knots.begin(), data.knots.end(), finite) &&
             std::all_of(data.weights.begin(), data.weights.end(), finite);
  for (const auto& pole : data.poles) all = all && std::all_of(pole.begin(), pole.end(), finite);
  if (!all)
    throw GeometryError(ErrorCode::kNotFinite, "A pole, weight or knot is not a finite number.");
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
void require_knots(const BSplineData<Dimension>& data) {
  const auto fail = [](const std::string& sentence) {
    throw GeometryError(ErrorCode::kBadKnots, sentence);
  };
  const auto& mult = data.multiplicities;
  if (data.knots.size() < 2 || data.knots.size() != mult.size()) {
    fail("There must be at least two knots, each with its multiplicity.");
  }
  if (std::adjacent_find(data.knots.begin(), data.knots.end(), std::greater_equal<double>()) !=
      data.knots.end()) {
    fail("The knots must increase strictly.");
  }
  const int order = data.degree + 1;
  if (mult.front() != order || mult.back() != order) {
    fail("The first and the last knot must have multiplicity degree + 1.");
  }
  if (std::any_of(mult.begin(), mult.end(), [&](int m) { return m < 1 || m > order; })) {
    fail("A knot's multiplicity must lie between 1 and degree + 1.");
  }
  const auto knots = static_cast<std::size_t>(std::accumulate(mult.begin(), mult.end(), 0));
  if (knots != data.poles.size() + static_cast<std::size_t>(order)) {
    fail("The number of knots, counted with multiplicity, must be poles + degree + 1.");
  }
}

template <std::size_t Dimension>
void require_valid(const BSplineData<Dimension>& data) {
  if (data.degree < 1 || data.poles.size() < 2) {
    throw GeometryError(ErrorCode::kWrongShape,
                        "A curve or law needs at least two poles and a degree of at least 1.");
  }
  require_finite(data);
  require_weights(data);
  require_knots(data);
}

std::vector<Rational> exact(const std::vector<double>& values) {
  std::vector<Rational> result;
  result.reserve(values.size());
  for (const double value : values) result.push_back(Rational::exactly(value));
  return result;
}

/// Weights up to a common power of two, the largest between 1 and 2: only their ratios matter.
std::vector<Rational> scaled_weights(const std::vector<double>& weights, std::size_t count) {
  if (weights.empty()) return std::vector<Rational>(count, Rational(1));
  const int exponent = std::ilogb(*std::max_element(weights.begin(), weights.end()));
  // Two steps, since 2^-exponent alone may not be a double.
  const Rational half = Rational::exactly(std::ldexp(1.0, -(exponent / 2)));
  const Rational rest = Rational::exactly(std::ldexp(1.0, -(exponent - exponent / 2)));
  std::vector<Rational> result;
  for (const double weight : weights) result.push_back(Rational::exactly(weight) * half * rest);
  return result;
}

/// Every knot as often as its multiplicity says.
std::vector<Rational> flat_knots(const std::vector<Rational>& knots,
                                 const std::vector<int>& multiplicities) {
  std::vector<Rational> flat;
  for (std::size_t i = 0; i < knots.size(); ++i)
    flat.insert(flat.end(), multiplicities[i], knots[i]);
  return flat;
}

/// The polar form of the B-spline's segment over [flat[last], flat[last + 1]] at `degree`
/// arguments: de Boor's algorithm with a new argument in every round.
Rational blossom(const std::vector<Rational>& flat, std::size_t last,
                 std::vector<Rational> controls, const std::vector<Rational>& arguments) {
  const std::size_t degree = arguments.size();
  for (std::size_t round = 0; round < degree; ++round) {
    for (std::size_t j = degree; j > round; --j) {
      const Rational& low = flat[last - degree + j];
      const Rational& high = flat[last + j - round];
      if (arguments[round] == low) {
        controls[j] = controls[j - 1];
      } else if (arguments[round] != high) {
        const Rational ratio = (arguments[round] - low) / (high - low);
        controls[j] = controls[j - 1] + ratio * (controls[j] - controls[j - 1]);
      }
    }
  }
  return controls[degree];
}

/// The Bezier coefficients of one scalar B-spline on the span that ends the run of knots at `last`.
RationalPolynomial span_polynomial(const std::vector<Rational>& flat, std::size_t last,
                                   std::size_t degree, const std::vector<Rational>& coefficients) {
  const auto begin = coefficients.begin() + static_cast<std::ptrdiff_t>(last - degree);
  const std::vector<Rational> local(begin, begin + static_cast<std::ptrdiff_t>(degree) + 1);
  std::vector<Rational> bezier;
  bezier.reserve(degree + 1);
  for (std::size_t i = 0; i <= degree; ++i) {
    std::vector<Rational> arguments(degree, flat[last]);
    std::fill(arguments.end() - static_cast<std::ptrdiff_t>(i), arguments.end(), flat[last + 1]);
    bezier.push_back(blossom(flat, last, local, arguments));
  }
  return RationalPolynomial(from_bernstein(std::move(bezier)));
}

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
  function.breaks = exact(data.knots);
  const std::vector<Rational> flat = flat_knots(function.breaks, data.multiplicities);
  const std::vector<Rational> weights = scaled_weights(data.weights, data.poles.size());
  std::array<std::vector<Rational>, Dimension> homogeneous;
  for (std::size_t c = 0; c < Dimension; ++c) {
    for (std::size_t i = 0; i < data.poles.size(); ++i) {
      homogeneous[c].push_back(Rational::exactly(data.poles[i][c]) * weights[i]);
    }
  }
  std::vector<std::size_t> last = {degree};  // the last of the knots at the start of each span
  for (std::size_t span = 1; span + 1 < data.knots.size(); ++span) {
    last.push_back(last.back() + static_cast<std::size_t>(data.multiplicities[span]));
  }
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

template <std::size_t Dimension>
BSplineData<Dimension> bezier_data(const std::vector<std::array<double, Dimension>>& poles,
                                   const std::vector<double>& weights) {
  const int degree = static_cast<int>(poles.size()) - 1;
  return {degree, {0, 1}, {degree + 1, degree + 1}, poles, weights};
}

}  // namespace

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
  if (!std::isfinite(value)) {
    throw GeometryError(ErrorCode::kNotFinite, "The radius is not a finite number.");
  }
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
                        "The radius law is defined over parameters " +
                            show(function.breaks.front()) + " to " + show(function.breaks.back()) +
                            ", the spine over " + show(begin) + " to " + show(end) +
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
