// SPDX-License-Identifier: LGPL-2.1-or-later
// Knots of the splines that are measured.
#pragma once

#include "pn/shapes/curve.hpp"

namespace pn::bench {

/// Uniform knots, clamped at both ends, of a cubic with so many spans.
template <std::size_t Dimension>
BSplineData<Dimension> clamped_cubic(int spans) {
  BSplineData<Dimension> data;
  data.degree = 3;
  for (int i = 0; i <= spans; ++i) {
    data.knots.push_back(i);
    data.multiplicities.push_back(i == 0 || i == spans ? 4 : 1);
  }
  return data;
}

}  // namespace pn::bench
