// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/evaluation.hpp"

#include <algorithm>
#include <numeric>

namespace pn {
namespace {

/// The 2 p knots around a span, each as often as it counts, and the number of knots before them.
struct KnotsAround {
  std::vector<double> flat;
  std::size_t before;
};

KnotsAround knots_around(std::size_t p, const std::vector<double>& knots,
                         const std::vector<int>& multiplicities, double parameter) {
  // The last span holds its right end too.
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, parameter);
  const auto span = static_cast<std::size_t>(above - knots.begin()) - 1;
  const std::size_t up_to_span = static_cast<std::size_t>(std::accumulate(
      multiplicities.begin(), multiplicities.begin() + static_cast<int>(span) + 1, 0));
  std::vector<double> flat(2 * p);
  std::size_t filled = 0;
  for (std::size_t i = span + 1; filled < p; --i) {
    for (int copy = 0; copy < multiplicities[i - 1] && filled < p; ++copy) {
      flat[p - 1 - filled++] = knots[i - 1];
    }
  }
  for (std::size_t i = span + 1; filled < 2 * p; ++i) {
    for (int copy = 0; copy < multiplicities[i] && filled < 2 * p; ++copy) {
      flat[filled++] = knots[i];
    }
  }
  return {std::move(flat), up_to_span - p};
}

}  // namespace

ActiveBasis active_basis(int degree, const std::vector<double>& knots,
                         const std::vector<int>& multiplicities, double parameter) {
  parameter = std::clamp(parameter, knots.front(), knots.back());
  const auto p = static_cast<std::size_t>(degree);
  const auto [flat, before] = knots_around(p, knots, multiplicities, parameter);
  std::vector<double> values(p + 1, 0.0), left(p + 1), right(p + 1);
  values[0] = 1;
  for (std::size_t j = 1; j <= p; ++j) {
    left[j] = parameter - flat[p - j];
    right[j] = flat[p - 1 + j] - parameter;
    double saved = 0;
    for (std::size_t r = 0; r < j; ++r) {
      const double share = values[r] / (right[r + 1] + left[j - r]);
      values[r] = saved + right[r + 1] * share;
      saved = left[j - r] * share;
    }
    values[j] = saved;
  }
  return {before - 1, std::move(values)};
}

std::array<double, 3> evaluate(const BSplineSurface& surface, double u, double v) {
  const ActiveBasis along =
      active_basis(surface.u_degree, surface.u_knots, surface.u_multiplicities, u);
  const ActiveBasis around =
      active_basis(surface.v_degree, surface.v_knots, surface.v_multiplicities, v);
  std::array<double, 3> point = {0, 0, 0};
  double weight = 0;
  const std::size_t columns = surface.v_count();
  for (std::size_t i = 0; i < along.values.size(); ++i) {
    for (std::size_t j = 0; j < around.values.size(); ++j) {
      const std::size_t index = (along.first + i) * columns + around.first + j;
      const double share = along.values[i] * around.values[j] * surface.weights[index];
      for (std::size_t c = 0; c < 3; ++c) point[c] += share * surface.poles[index][c];
      weight += share;
    }
  }
  for (double& coordinate : point) coordinate /= weight;
  return point;
}

}  // namespace pn
