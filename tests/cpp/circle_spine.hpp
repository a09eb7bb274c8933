// SPDX-License-Identifier: LGPL-2.1-or-later
// A circle as a spine, exact: its weights are rational.
#pragma once

#include "pn/shapes/curve.hpp"

namespace pn::test {

/// The circle of this radius around the origin in the plane z = 0, in four quadratic spans.
inline Curve circle(double r) {
  return Curve::bspline({2,
                         {0, 1, 2, 3, 4},
                         {3, 2, 2, 2, 3},
                         {{r, 0, 0},
                          {r, r, 0},
                          {0, r, 0},
                          {-r, r, 0},
                          {-r, 0, 0},
                          {-r, -r, 0},
                          {0, -r, 0},
                          {r, -r, 0},
                          {r, 0, 0}},
                         {1, 1, 2, 1, 1, 1, 2, 1, 1}});
}

}  // namespace pn::test
