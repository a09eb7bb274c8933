// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/target_lines.hpp"

#include <algorithm>
#include <cmath>

#include "pn/algebra/parallel.hpp"
#include "pn/isotropic/seam.hpp"

namespace pn {

using Eigen::Matrix2d;

std::size_t TargetLines::nearest(double t) {
  return static_cast<std::size_t>(std::clamp(std::lround(t * kGrid), 0L, long{kGrid}));
}

void TargetLines::choose_signs(std::size_t link_count) {
  grid_.resize(link_count);
  for_each_index(link_count, [&](std::size_t i) {
    grid_[i].push_back(factor(i, 0));
    for (int g = 1; g <= kGrid; ++g) {
      grid_[i].push_back(continued(grid_[i].back(), factor(i, grid_parameter(g))));
    }
  });
}

Matrix2d TargetLines::at(std::size_t link, double t) const {
  return continued(grid_[link][nearest(t)], factor(link, t));
}

Matrix2d TargetLines::derivative(std::size_t link, double t) const {
  constexpr double kStep = 1.0 / 1024;
  const Matrix2d here = at(link, t);
  const Matrix2d ahead = continued(here, factor(link, t + kStep));
  const Matrix2d behind = continued(here, factor(link, t - kStep));
  return (ahead - behind) / (2 * kStep);
}

}  // namespace pn
