// SPDX-License-Identifier: LGPL-2.1-or-later
// Evaluation of B-spline surfaces by their basis functions (L. Piegl, W. Tiller, The NURBS Book,
// 2nd ed. 1997, algorithms A2.1, A2.2 and A4.3), in doubles.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"

namespace pn {

/// The basis functions that do not vanish at a parameter, and the index of the first of them.
struct ActiveBasis {
  std::size_t first;
  std::vector<double> values;
};

/// Parameters outside the knots are taken at the nearest end.
ActiveBasis active_basis(int degree, const std::vector<double>& knots,
                         const std::vector<int>& multiplicities, double parameter);

/// The point at (u, v); parameters outside the knots are taken at the nearest end.
std::array<double, 3> evaluate(const BSplineSurface& surface, double u, double v);

}  // namespace pn
