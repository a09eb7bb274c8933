// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/blossom.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>

#include "pn/algebra/bernstein.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

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

}  // namespace

void require_clamped(int degree, const std::vector<double>& knots,
                     const std::vector<int>& multiplicities, std::size_t poles) {
  const auto fail = [](const std::string& sentence) {
    throw GeometryError(ErrorCode::kBadKnots, sentence);
  };
  const auto& mult = multiplicities;
  if (knots.size() < 2 || knots.size() != mult.size()) {
    fail("There must be at least two knots, each with its multiplicity.");
  }
  if (std::adjacent_find(knots.begin(), knots.end(), std::greater_equal<double>()) != knots.end()) {
    fail("The knots must increase strictly.");
  }
  const int order = degree + 1;
  if (mult.front() != order || mult.back() != order) {
    fail("The first and the last knot must have multiplicity degree + 1.");
  }
  if (std::any_of(mult.begin(), mult.end(), [&](int m) { return m < 1 || m > order; })) {
    fail("A knot's multiplicity must lie between 1 and degree + 1.");
  }
  const auto count = static_cast<std::size_t>(std::accumulate(mult.begin(), mult.end(), 0));
  if (count != poles + static_cast<std::size_t>(order)) {
    fail("The number of knots, counted with multiplicity, must be poles + degree + 1.");
  }
}

std::vector<std::size_t> span_places(const std::vector<int>& multiplicities) {
  std::vector<std::size_t> places = {static_cast<std::size_t>(multiplicities.front()) - 1};
  for (std::size_t i = 1; i + 1 < multiplicities.size(); ++i) {
    places.push_back(places.back() + static_cast<std::size_t>(multiplicities[i]));
  }
  return places;
}

std::vector<Rational> exactly(const std::vector<double>& values) {
  std::vector<Rational> result;
  result.reserve(values.size());
  for (const double value : values) result.push_back(Rational::exactly(value));
  return result;
}

std::vector<Rational> scaled_weights(const std::vector<double>& weights, std::size_t count) {
  if (weights.empty()) return std::vector<Rational>(count, Rational(1));
  const int exponent = std::ilogb(*std::max_element(weights.begin(), weights.end()));
  const Rational scale = Rational::exactly(std::ldexp(1.0, -exponent));
  std::vector<Rational> result;
  for (const double weight : weights) result.push_back(Rational::exactly(weight) * scale);
  return result;
}

std::vector<Rational> flat_knots(const std::vector<Rational>& knots,
                                 const std::vector<int>& multiplicities) {
  std::vector<Rational> flat;
  for (std::size_t i = 0; i < knots.size(); ++i)
    flat.insert(flat.end(), multiplicities[i], knots[i]);
  return flat;
}

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

}  // namespace pn
