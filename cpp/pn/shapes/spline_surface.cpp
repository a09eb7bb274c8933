// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/spline_surface.hpp"

#include <algorithm>
#include <numeric>

#include "pn/algebra/parallel.hpp"
#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"
#include "pn/shapes/blossom.hpp"

namespace pn {
namespace {

std::size_t count_of(const SplineSurfaceData& data, std::size_t direction) {
  const std::vector<int>& mult = data.multiplicities[direction];
  const int count = std::accumulate(mult.begin(), mult.end(), 0) - data.degree[direction] - 1;
  return static_cast<std::size_t>(std::max(count, 0));
}

void require_valid(const SplineSurfaceData& data) {
  if (data.degree[0] < 1 || data.degree[1] < 1) {
    throw GeometryError(ErrorCode::kWrongShape, "A surface needs degrees of at least 1.");
  }
  for (std::size_t direction = 0; direction < 2; ++direction) {
    const auto& knots = data.knots[direction];
    require_input_numbers(knots, "A knot");
    require_clamped(data.degree[direction], knots, data.multiplicities[direction],
                    count_of(data, direction));
  }
  const std::size_t count = count_of(data, 0) * count_of(data, 1);
  if (data.poles.size() != count || (!data.weights.empty() && data.weights.size() != count)) {
    throw GeometryError(ErrorCode::kWrongShape,
                        "The numbers of poles and weights do not fit the knots of the surface.");
  }
  for (const auto& pole : data.poles) require_input_numbers(pole, "A coordinate of a pole");
  require_input_numbers(data.weights, "A weight");
  if (std::any_of(data.weights.begin(), data.weights.end(), [](double w) { return w <= 0; })) {
    throw GeometryError(ErrorCode::kNonPositiveWeight, "The weights must be positive.");
  }
}

/// A scalar tensor-product B-spline.
class ScalarSpline {
 public:
  ScalarSpline(const SplineSurfaceData& data, std::vector<Rational> coefficients)
      : degree_{static_cast<std::size_t>(data.degree[0]), static_cast<std::size_t>(data.degree[1])},
        knots_{flat_knots(exactly(data.knots[0]), data.multiplicities[0]),
               flat_knots(exactly(data.knots[1]), data.multiplicities[1])},
        columns_(count_of(data, 1)),
        coefficients_(std::move(coefficients)) {}

  /// On the span that ends the runs of knots at `last`.
  BivariatePolynomial on_span(const std::array<std::size_t, 2>& last) const {
    const std::size_t rows = coefficients_.size() / columns_;
    std::vector<std::vector<Rational>> across(degree_[0] + 1, std::vector<Rational>(columns_));
    for (std::size_t j = last[1] - degree_[1]; j <= last[1]; ++j) {
      std::vector<Rational> column;
      for (std::size_t i = 0; i < rows; ++i) column.push_back(coefficients_[i * columns_ + j]);
      const RationalPolynomial along = span_polynomial(knots_[0], last[0], degree_[0], column);
      for (std::size_t i = 0; i <= degree_[0]; ++i) {
        across[i][j] = along.coefficient(static_cast<int>(i));
      }
    }
    std::vector<std::vector<Rational>> powers;
    for (const std::vector<Rational>& row : across) {
      const RationalPolynomial p = span_polynomial(knots_[1], last[1], degree_[1], row);
      powers.emplace_back();
      for (int j = 0; j <= p.degree(); ++j) powers.back().push_back(p.coefficient(j));
    }
    return BivariatePolynomial(powers);
  }

 private:
  std::array<std::size_t, 2> degree_;
  std::array<std::vector<Rational>, 2> knots_;
  std::size_t columns_;
  std::vector<Rational> coefficients_;
};

}  // namespace

std::vector<RationalPatch> rational_patches(const SplineSurfaceData& data) {
  require_valid(data);
  const std::vector<Rational> weights = scaled_weights(data.weights, data.poles.size());
  std::vector<ScalarSpline> splines;
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<Rational> coefficients;
    for (std::size_t i = 0; i < data.poles.size(); ++i) {
      coefficients.push_back(Rational::exactly(data.poles[i][c]) * weights[i]);
    }
    splines.emplace_back(data, std::move(coefficients));
  }
  splines.emplace_back(data, weights);
  const auto along = span_places(data.multiplicities[0]),
             across = span_places(data.multiplicities[1]);
  std::vector<RationalPatch> patches(along.size() * across.size());
  for_each_index(patches.size(), [&](std::size_t k) {
    const std::array<std::size_t, 2> last = {along[k / across.size()], across[k % across.size()]};
    RationalPatch& patch = patches[k];
    for (std::size_t c = 0; c < 3; ++c) patch.point[c] = splines[c].on_span(last);
    patch.weight = splines[3].on_span(last);
    patch.side = 1;
  });
  return patches;
}

}  // namespace pn
