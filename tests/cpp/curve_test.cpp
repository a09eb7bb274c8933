// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/curve.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"
#include "error_code.hpp"

using pn::BSplineData;
using pn::Curve;
using pn::ErrorCode;
using pn::Law;
using pn::Rational;
using namespace pn::test;

namespace {

/// Value of a component of the B-spline at x by de Boor's algorithm over Q.
template <std::size_t Dimension>
Rational value_at(const BSplineData<Dimension>& data, std::size_t component, double x) {
  const auto flat = flat_knots<Rational>(data.knots, data.multiplicities, Rational::exactly);
  const std::size_t last = span_at(data.knots, data.multiplicities, x);
  std::vector<Rational> numerator, denominator;
  for (std::size_t i = last - static_cast<std::size_t>(data.degree); i <= last; ++i) {
    const Rational weight =
        data.weights.empty() ? Rational(1L) : Rational::exactly(data.weights[i]);
    numerator.push_back(Rational::exactly(data.poles[i][component]) * weight);
    denominator.push_back(weight);
  }
  const Rational at = Rational::exactly(x);
  return de_boor(data.degree, flat, last, numerator, at) /
         de_boor(data.degree, flat, last, denominator, at);
}

template <std::size_t Dimension>
Rational value_at(const pn::PiecewiseRational<Dimension>& function, std::size_t component,
                  double x) {
  const Rational at = Rational::exactly(x);
  std::size_t i = 0;
  while (i + 2 < function.breaks.size() && !(at < function.breaks[i + 1])) ++i;
  const Rational local = (at - function.breaks[i]) / (function.breaks[i + 1] - function.breaks[i]);
  return function.spans[i].numerator[component](local) / function.spans[i].denominator(local);
}

const BSplineData<3> kSpine{
    3,
    {-1, 0.1, 0.7, 2},
    {4, 1, 2, 4},
    {{0, 0, 0}, {1, 0.3, 0}, {2, 1, 0.1}, {3, 1, 1}, {4, -1, 2}, {5, 0, 2}, {6, 1, 1}},
    {1, 0.5, 2, 1, 0.7, 1, 3}};

}  // namespace

TEST_CASE("The spans of a B-spline are its values by de Boor's algorithm, exactly", "[curve]") {
  const auto polynomial = [] {
    BSplineData<3> data = kSpine;
    data.weights.clear();
    return data;
  }();
  for (const BSplineData<3>& data : {kSpine, polynomial}) {
    const auto function = Curve::bspline(data).function();
    REQUIRE(function.spans.size() == 3);
    for (const double x : {-1.0, -0.3, 0.1, 0.35, 0.7, 1.999, 2.0}) {
      for (std::size_t c = 0; c < 3; ++c) CHECK(value_at(function, c, x) == value_at(data, c, x));
    }
  }
}

TEST_CASE("A Bezier curve is a B-spline with one span", "[curve]") {
  const std::vector<std::array<double, 3>> poles = {
      {0, 0.1, 0}, {1, 2, 3}, {4, 4, -1}, {5, 0, 0.3}};
  const std::vector<double> weights = {1, 0.3, 2, 1};
  const BSplineData<3> data{3, {0, 1}, {4, 4}, poles, weights};
  const Curve curve = Curve::bezier(poles, weights);
  for (const double x : {0.0, 0.3, 1.0})
    CHECK(value_at(curve.function(), 1, x) == value_at(data, 1, x));
  CHECK(curve.degree() == 3);
}

TEST_CASE("The degree is the one the data have, not the one they are written in", "[curve]") {
  CHECK(Curve::bezier({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}}).degree() == 1);
  CHECK(Curve::bezier({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 1}}).degree() == 3);
}

TEST_CASE("A chain runs over the lengths of its curves and keeps their shapes", "[curve]") {
  const BSplineData<3> first{1, {2, 4}, {2, 2}, {{0, 0, 0}, {1, 0, 0}}, {}};
  const BSplineData<3> second{1, {-5, -4, 0}, {2, 1, 2}, {{1, 0, 0}, {1, 2, 0}, {1, 2, 3}}, {}};
  const auto function = Curve::chain({Curve::bspline(first), Curve::bspline(second)}).function();
  CHECK(function.breaks ==
        std::vector<Rational>{Rational(2L), Rational(4L), Rational(5L), Rational(9L)});
  CHECK(value_at(function, 0, 3) == value_at(first, 0, 3));
  CHECK(value_at(function, 2, 7) == value_at(second, 2, -2));
  CHECK(code_of([&] {
          Curve::chain({Curve::bspline(second), Curve::bspline(first)});
        }) == ErrorCode::kGap);
  CHECK(code_of([] { Curve::chain({}); }) == ErrorCode::kWrongShape);
}

TEST_CASE("A law is its values, over its own domain or any", "[curve]") {
  const BSplineData<1> data{2, {0, 0.3, 1}, {3, 1, 3}, {{1}, {2}, {0.7}, {3}}, {1, 2, 1, 0.5}};
  const auto law = Law::bspline(data).over(Rational(0L), Rational(1L));
  for (const double x : {0.0, 0.2, 0.3, 0.9}) CHECK(value_at(law, 0, x) == value_at(data, 0, x));
  CHECK(code_of([&] { Law::bspline(data).over(Rational(0L), Rational(2L)); }) ==
        ErrorCode::kDomainMismatch);
  const auto constant = Law::constant(0.1).over(Rational(-3L), Rational(5L));
  CHECK(value_at(constant, 0, -2.5) == Rational::exactly(0.1));
  CHECK(value_at(Law::bezier({1, 3}).over(Rational(0L), Rational(1L)), 0, 0.25) ==
        Rational(3L) / Rational(2L));
}

TEST_CASE("Every kind of bad data has its code", "[curve]") {
  const auto refused = [](auto&& spoil) {
    BSplineData<3> data = kSpine;
    spoil(data);
    return code_of([&] { Curve::bspline(data); });
  };
  const double nan = std::nan("");
  CHECK(refused([&](auto& d) { d.poles[2][1] = nan; }) == ErrorCode::kNotFinite);
  CHECK(refused([&](auto& d) { d.poles[2][1] = INFINITY; }) == ErrorCode::kNotFinite);
  CHECK(refused([&](auto& d) { d.knots[1] = nan; }) == ErrorCode::kNotFinite);
  CHECK(refused([&](auto& d) { d.weights[0] = nan; }) == ErrorCode::kNotFinite);
  CHECK(refused([&](auto& d) { d.weights[3] = 0; }) == ErrorCode::kNonPositiveWeight);
  CHECK(refused([&](auto& d) { d.weights[3] = -1; }) == ErrorCode::kNonPositiveWeight);
  CHECK(refused([&](auto& d) { d.weights.pop_back(); }) == ErrorCode::kWrongShape);
  CHECK(refused([&](auto& d) { d.degree = 0; }) == ErrorCode::kWrongShape);
  CHECK(refused([&](auto& d) { d.poles.resize(1); }) == ErrorCode::kWrongShape);
  CHECK(refused([&](auto& d) { d.poles.pop_back(), d.weights.pop_back(); }) ==
        ErrorCode::kBadKnots);
  CHECK(refused([&](auto& d) { d.knots[2] = d.knots[1]; }) == ErrorCode::kBadKnots);
  CHECK(refused([&](auto& d) { d.knots.pop_back(); }) == ErrorCode::kBadKnots);
  CHECK(refused([&](auto& d) { d.multiplicities = {3, 2, 2, 4}; }) == ErrorCode::kBadKnots);
  CHECK(refused([&](auto& d) { d.multiplicities = {4, 0, 3, 4}; }) == ErrorCode::kBadKnots);
  CHECK(refused([&](auto& d) { d.multiplicities = {4, 5, -2, 4}; }) == ErrorCode::kBadKnots);
  CHECK(code_of([] { Curve::bezier({{1, 2, 3}}); }) == ErrorCode::kWrongShape);
  CHECK(code_of([] { Curve::bezier({}); }) == ErrorCode::kWrongShape);
  CHECK(code_of([&] { Law::constant(nan); }) == ErrorCode::kNotFinite);
  CHECK(code_of([] { Law::bezier({1}); }) == ErrorCode::kWrongShape);
  // A knot of multiplicity degree + 1 lets the curve jump.
  const BSplineData<3> jump{
      1, {0, 1, 2}, {2, 2, 2}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {}};
  CHECK(code_of([&] { Curve::bspline(jump); }) == ErrorCode::kGap);
}

TEST_CASE("A chain whose lengths vanish beside each other is refused", "[curve]") {
  const auto line = [](double begin, double end, double x) {
    return Curve::bspline({1, {begin, end}, {2, 2}, {{x, 0, 0}, {x + 1, 0, 0}}, {}});
  };
  CHECK(code_of([&] { Curve::chain({line(0, 1e20, 0), line(0, 1, 1)}); }) == ErrorCode::kBadKnots);
}
