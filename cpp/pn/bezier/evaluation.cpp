// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/evaluation.hpp"

#include <algorithm>

namespace pn {

SplineBasis::SplineBasis(int degree, const std::vector<double>& knots,
                         const std::vector<int>& multiplicities)
    : degree_(static_cast<std::size_t>(degree)) {
  for (std::size_t i = 0; i < knots.size(); ++i) {
    knots_.insert(knots_.end(), static_cast<std::size_t>(multiplicities[i]), knots[i]);
  }
}

ActiveBasis SplineBasis::at(double parameter) const {
  const std::size_t p = degree_;
  parameter = std::clamp(parameter, knots_.front(), knots_.back());
  // The last span holds its right end too.
  const auto first_end = knots_.begin() + static_cast<std::ptrdiff_t>(p) + 1;
  const auto last_end = knots_.end() - static_cast<std::ptrdiff_t>(p) - 1;
  const double* const end = &*std::upper_bound(first_end, last_end, parameter);
  ActiveBasis basis{static_cast<std::size_t>(end - knots_.data()) - p - 1, {}};
  auto& values = basis.values;
  values.resize(static_cast<Eigen::Index>(p) + 1);
  values[0] = 1;
  for (int j = 1; j <= static_cast<int>(p); ++j) {
    double saved = 0;
    for (int r = 0; r < j; ++r) {
      const double right = end[r] - parameter, left = parameter - end[r - j];
      const double share = values[r] / (right + left);
      values[r] = saved + right * share;
      saved = left * share;
    }
    values[j] = saved;
  }
  return basis;
}

SurfaceEvaluation::SurfaceEvaluation(const BSplineSurface& surface)
    : surface_(surface),
      along_(surface.u_degree, surface.u_knots, surface.u_multiplicities),
      around_(surface.v_degree, surface.v_knots, surface.v_multiplicities) {}

std::array<double, 3> SurfaceEvaluation::operator()(double u, double v) const {
  const ActiveBasis along = along_.at(u), around = around_.at(v);
  std::array<double, 3> point = {0, 0, 0};
  double weight = 0;
  const std::size_t columns = surface_.v_count();
  for (Eigen::Index i = 0; i < along.values.size(); ++i) {
    const std::size_t row = along.first + static_cast<std::size_t>(i);
    for (Eigen::Index j = 0; j < around.values.size(); ++j) {
      const std::size_t index = row * columns + around.first + static_cast<std::size_t>(j);
      const double share = along.values[i] * around.values[j] * surface_.weights[index];
      for (std::size_t c = 0; c < 3; ++c) point[c] += share * surface_.poles[index][c];
      weight += share;
    }
  }
  for (double& coordinate : point) coordinate /= weight;
  return point;
}

std::array<double, 3> evaluate(const BSplineSurface& surface, double u, double v) {
  return SurfaceEvaluation(surface)(u, v);
}

}  // namespace pn
