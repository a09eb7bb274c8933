// SPDX-License-Identifier: LGPL-2.1-or-later
// The paraboloid of revolution as a patch.
#pragma once

#include "pn/shapes/spline_surface.hpp"

namespace pn::test {

/// z = (x^2 + y^2) / 4 over [-1, 1]^2, with its focus at (0, 0, 1).
inline SplineSurfaceData parabolic_mirror() {
  SplineSurfaceData data{{2, 2}, {{{0, 1}, {0, 1}}}, {{{3, 3}, {3, 3}}}, {}, {}};
  const std::array<double, 3> x = {-1, 0, 1}, square = {1, -1, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      data.poles.push_back({x[i], x[j], (square[i] + square[j]) / 4});
    }
  }
  return data;
}

}  // namespace pn::test
