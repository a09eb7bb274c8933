// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rational_functions.hpp"

#include "pn/input_numbers.hpp"

pn::BivariatePolynomial polynomial_of(const Coefficients& coefficients) {
  if (coefficients.ndim() != 2) {
    throw wrong_shape("The coefficients of a polynomial must be an array of two dimensions.");
  }
  std::vector<std::vector<pn::Rational>> rows;
  for (pybind11::ssize_t i = 0; i < coefficients.shape(0); ++i) {
    rows.emplace_back();
    for (pybind11::ssize_t j = 0; j < coefficients.shape(1); ++j) {
      const double value = coefficients.at(i, j);
      pn::require_input_number(value, "A coefficient");
      rows.back().push_back(pn::Rational::exactly(value));
    }
  }
  return pn::BivariatePolynomial(rows);
}

pn::BivariateFunction function_of(const pybind11::object& function) {
  if (!pybind11::isinstance<pybind11::tuple>(function))
    return polynomial_of(pybind11::cast<Coefficients>(function));
  const auto pair = pybind11::cast<pybind11::tuple>(function);
  if (pair.size() != 2) throw wrong_shape("A quotient is a tuple of two polynomials.");
  const pn::BivariatePolynomial denominator = polynomial_of(pybind11::cast<Coefficients>(pair[1]));
  if (denominator.is_zero()) throw wrong_shape("A denominator is zero.");
  return {polynomial_of(pybind11::cast<Coefficients>(pair[0])), denominator};
}
