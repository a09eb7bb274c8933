// SPDX-License-Identifier: LGPL-2.1-or-later
// Rational patches: parts of a rational surface over Q.
#pragma once

#include <array>
#include <vector>

#include "pn/algebra/multivariate_polynomial.hpp"

namespace pn {

/// A part of a rational surface: x = point / weight on the part of [0, 1]^2 where all polynomials
/// of the region are >= 0, with weight > 0 there. Its normal is side (x_u x x_v) / |x_u x x_v|.
struct RationalPatch {
  std::array<BivariatePolynomial, 3> point;
  BivariatePolynomial weight;
  std::vector<BivariatePolynomial> region;  ///< none: the whole square
  int side;                                 ///< 1 or -1
};

}  // namespace pn
