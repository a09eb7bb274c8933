// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists and points from NumPy arrays. All throw GeometryError with kWrongShape.
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <string>
#include <vector>

#include "pn/geometry_error.hpp"

using Array = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

inline pn::GeometryError wrong_shape(const std::string& sentence) {
  return {pn::ErrorCode::kWrongShape, sentence};
}

/// A list of numbers, which errors call by its name.
inline std::vector<double> vector_of(const Array& array, const char* name) {
  if (array.ndim() != 1)
    throw wrong_shape(std::string("The ") + name + " must be a list of numbers.");
  return {array.data(), array.data() + array.size()};
}

/// (n, 3)
inline std::vector<std::array<double, 3>> points_of(const Array& array) {
  if (array.ndim() != 2 || array.shape(1) != 3) {
    throw wrong_shape("The poles must be an array of shape (n, 3).");
  }
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) points[i][c] = array.data()[3 * i + c];
  }
  return points;
}
