// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists, points and polynomials from NumPy arrays. All throw GeometryError with kWrongShape.
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/rational_polynomial.hpp"
#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"

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

/// Matrices of polynomials over [0, 1] by their Bernstein coefficients, (k + 1, Rows, Columns).
/// Throws GeometryError: kWrongShape, kNotFinite, kOutOfRange.
template <std::size_t Rows, std::size_t Columns>
std::array<std::array<pn::RationalPolynomial, Columns>, Rows> polynomials_of(const Array& array,
                                                                             const char* name) {
  if (array.ndim() != 3 || array.shape(0) == 0 || array.shape(1) != Rows ||
      array.shape(2) != Columns) {
    throw wrong_shape(std::string("The ") + name + " must be an array of shape (k + 1, " +
                      std::to_string(Rows) + ", " + std::to_string(Columns) + ").");
  }
  const auto entries = array.unchecked<3>();
  std::array<std::array<pn::RationalPolynomial, Columns>, Rows> result;
  for (std::size_t i = 0; i < Rows; ++i) {
    for (std::size_t j = 0; j < Columns; ++j) {
      std::vector<pn::Rational> bernstein;
      for (pybind11::ssize_t k = 0; k < array.shape(0); ++k) {
        const double x =
            entries(k, static_cast<pybind11::ssize_t>(i), static_cast<pybind11::ssize_t>(j));
        pn::require_input_number(x, std::string("A number of the ") + name);
        bernstein.push_back(pn::Rational::exactly(x));
      }
      result[i][j] = pn::RationalPolynomial(pn::from_bernstein(std::move(bernstein)));
    }
  }
  return result;
}
