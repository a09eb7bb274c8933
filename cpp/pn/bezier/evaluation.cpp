// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/evaluation.hpp"

#include <algorithm>

namespace pn {
namespace {

/// The nonzero basis functions at a parameter and the index of the first of them.
struct ActiveBasis {
  std::size_t first;
  std::vector<double> values;
};

ActiveBasis active_basis(int degree, const std::vector<double>& knots,
                         const std::vector<int>& multiplicities, double parameter) {
  parameter = std::clamp(parameter, knots.front(), knots.back());
  std::vector<double> flat;
  for (std::size_t i = 0; i < knots.size(); ++i)
    flat.insert(flat.end(), multiplicities[i], knots[i]);
  const auto p = static_cast<std::size_t>(degree);
  const std::size_t count = flat.size() - p - 1;
  const auto above = std::upper_bound(flat.begin() + static_cast<std::ptrdiff_t>(p),
                                      flat.begin() + static_cast<std::ptrdiff_t>(count), parameter);
  const std::size_t span = static_cast<std::size_t>(above - flat.begin()) - 1;
  std::vector<double> values(p + 1, 0.0), left(p + 1), right(p + 1);
  values[0] = 1;
  for (std::size_t j = 1; j <= p; ++j) {
    left[j] = parameter - flat[span + 1 - j];
    right[j] = flat[span + j] - parameter;
    double saved = 0;
    for (std::size_t r = 0; r < j; ++r) {
      const double share = values[r] / (right[r + 1] + left[j - r]);
      values[r] = saved + right[r + 1] * share;
      saved = left[j - r] * share;
    }
    values[j] = saved;
  }
  return {span - p, std::move(values)};
}

}  // namespace

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
