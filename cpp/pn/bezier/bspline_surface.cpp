// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/bspline_surface.hpp"

#include <numeric>

namespace pn {

std::size_t pole_count(int degree, const std::vector<int>& multiplicities) {
  const int knots = std::accumulate(multiplicities.begin(), multiplicities.end(), 0);
  return static_cast<std::size_t>(knots - degree - 1);
}

std::size_t BSplineSurface::u_count() const { return pole_count(u_degree, u_multiplicities); }
std::size_t BSplineSurface::v_count() const { return pole_count(v_degree, v_multiplicities); }

}  // namespace pn
