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
  ActiveBasis basis{static_cast<std::size_t>(end - knots_.data()) - p - 1, {}, {}};
  auto& [first, values, slopes] = basis;
  values.resize(static_cast<Eigen::Index>(p) + 1);
  slopes.setZero(values.size());
  values[0] = 1;
  for (int j = 1; j <= static_cast<int>(p); ++j) {
    double saved = 0;
    for (int r = 0; r < j; ++r) {
      const double right = end[r] - parameter, left = parameter - end[r - j];
      const double share = values[r] / (right + left);
      if (j == static_cast<int>(p)) {
        slopes[r] -= j * share;
        slopes[r + 1] += j * share;
      }
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

SurfaceEvaluation::Place SurfaceEvaluation::place(double u, double v) const {
  return {along_.at(u), around_.at(v)};
}

Eigen::Vector4d SurfaceEvaluation::combination(const Place& place, const Numbers& along,
                                               const Numbers& around) const {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  const std::size_t columns = surface_.v_count();
  for (Eigen::Index i = 0; i < along.size(); ++i) {
    const std::size_t row = place.along.first + static_cast<std::size_t>(i);
    for (Eigen::Index j = 0; j < around.size(); ++j) {
      const std::size_t index = row * columns + place.around.first + static_cast<std::size_t>(j);
      const double share = along[i] * around[j] * surface_.weights[index];
      for (std::size_t c = 0; c < 3; ++c) {
        sum[static_cast<Eigen::Index>(c)] += share * surface_.poles[index][c];
      }
      sum[3] += share;
    }
  }
  return sum;
}

std::array<double, 3> SurfaceEvaluation::operator()(double u, double v) const {
  const Place at = place(u, v);
  const Eigen::Vector4d x = combination(at, at.along.values, at.around.values);
  return {x[0] / x[3], x[1] / x[3], x[2] / x[3]};
}

std::array<double, 3> SurfaceEvaluation::normal(double u, double v) const {
  const Place at = place(u, v);
  const Eigen::Vector4d x = combination(at, at.along.values, at.around.values),
                        by_u = combination(at, at.along.slopes, at.around.values),
                        by_v = combination(at, at.along.values, at.around.slopes);
  const Eigen::Vector3d point = x.head<3>() / x[3];
  const Eigen::Vector3d along = (by_u.head<3>() - by_u[3] * point) / x[3],
                        around = (by_v.head<3>() - by_v[3] * point) / x[3];
  const Eigen::Vector3d n = along.cross(around);
  return {n[0], n[1], n[2]};
}

std::array<double, 3> evaluate(const BSplineSurface& surface, double u, double v) {
  return SurfaceEvaluation(surface)(u, v);
}

}  // namespace pn
