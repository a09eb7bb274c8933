// SPDX-License-Identifier: LGPL-2.1-or-later
#include "surface_point.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace pn::bench {

SurfacePoints::Direction SurfacePoints::direction(int degree, const std::vector<double>& knots,
                                                  const std::vector<int>& multiplicities) {
  Direction direction{static_cast<std::size_t>(degree), {}};
  for (std::size_t i = 0; i < knots.size(); ++i) {
    direction.knots.insert(direction.knots.end(), static_cast<std::size_t>(multiplicities[i]),
                           knots[i]);
  }
  return direction;
}

SurfacePoints::SurfacePoints(const BSplineSurface& surface)
    : along_(direction(surface.u_degree, surface.u_knots, surface.u_multiplicities)),
      around_(direction(surface.v_degree, surface.v_knots, surface.v_multiplicities)),
      columns_(surface.v_count()) {
  for (std::size_t i = 0; i < surface.poles.size(); ++i) {
    const auto& [x, y, z] = surface.poles[i];
    poles_.push_back(Homogeneous(x, y, z, 1) * surface.weights[i]);
  }
}

std::size_t SurfacePoints::Direction::span(long double t) const {
  const auto first = knots.begin() + static_cast<std::ptrdiff_t>(degree);
  const auto end = knots.end() - static_cast<std::ptrdiff_t>(degree) - 1;
  return static_cast<std::size_t>(std::upper_bound(first + 1, end, t) - knots.begin()) - 1;
}

SurfacePoints::Homogeneous SurfacePoints::Direction::value(std::vector<Homogeneous> active,
                                                           std::size_t span, long double t) const {
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t j = degree; j >= r; --j) {
      const long double low = knots[span - degree + j], high = knots[span + 1 + j - r];
      const long double share = (t - low) / (high - low);
      active[j] = (1 - share) * active[j - 1] + share * active[j];
    }
  }
  return active[degree];
}

Point SurfacePoints::at(long double u, long double v) const {
  const std::size_t row = along_.span(u), column = around_.span(v);
  std::vector<Homogeneous> across;
  for (std::size_t i = row - along_.degree; i <= row; ++i) {
    const auto last = poles_.begin() + static_cast<std::ptrdiff_t>(i * columns_ + column);
    across.push_back(around_.value(
        std::vector<Homogeneous>(last - static_cast<std::ptrdiff_t>(around_.degree), last + 1),
        column, v));
  }
  return along_.value(across, row, u).hnormalized();
}

}  // namespace pn::bench
