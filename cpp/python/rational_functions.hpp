// SPDX-License-Identifier: LGPL-2.1-or-later
// Rational functions of two variables from NumPy arrays.
#pragma once

#include <pybind11/pybind11.h>

#include "arrays.hpp"
#include "pn/algebra/rational_function.hpp"

/// The entry [i, j] is the coefficient of u^i v^j.
using Coefficients = Array;

/// With the coefficients that the doubles are. Throws GeometryError: kWrongShape, kNotFinite,
/// kOutOfRange.
pn::BivariatePolynomial polynomial_of(const Coefficients& coefficients);

/// A polynomial, or a tuple of numerator and denominator. Throws GeometryError: kWrongShape,
/// kNotFinite, kOutOfRange.
pn::BivariateFunction function_of(const pybind11::object& function);
