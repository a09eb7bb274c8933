// SPDX-License-Identifier: LGPL-2.1-or-later
// Spline surfaces: a designer's tensor-product B-spline, taken as rational patches over Q.
#pragma once

#include <array>
#include <vector>

#include "pn/isotropic/rational_patch.hpp"

namespace pn {

/// The data of a clamped B-spline surface, as OpenCASCADE and STEP give them: in both directions
/// strictly increasing knots with multiplicities, the first and the last degree + 1. Pole (i, j) is
/// poles[i * (number of poles along v) + j], in millimetres; as many weights, or none.
struct SplineSurfaceData {
  std::array<int, 2> degree;
  std::array<std::vector<double>, 2> knots;
  std::array<std::vector<int>, 2> multiplicities;
  std::vector<std::array<double, 3>> poles;
  std::vector<double> weights;
};

/// One patch for every span, row by row along u, each over the unit square with the side of x_u x
/// x_v. Throws GeometryError: kNotFinite, kWrongShape, kBadKnots, kNonPositiveWeight.
std::vector<RationalPatch> rational_patches(const SplineSurfaceData& data);

}  // namespace pn
