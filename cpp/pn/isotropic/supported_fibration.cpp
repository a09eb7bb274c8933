// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/supported_fibration.hpp"

#include <algorithm>
#include <vector>

#include "pn/geometry_error.hpp"

namespace pn {
namespace {

/// <x, f> = support, by its coefficients and its right side.
using Equation = std::array<BivariateFunction, 5>;

Equation equation(const MinkowskiVector<BivariateFunction>& x, const BivariateFunction& support) {
  return {x[0], x[1], x[2], -x[3], support};
}

Equation derivative(const Equation& equation, Variable variable) {
  Equation result;
  std::transform(equation.begin(), equation.end(), result.begin(),
                 [variable](const BivariateFunction& c) { return c.derivative(variable); });
  return result;
}

void eliminate(Equation& equation, const Equation& pivot, std::size_t column) {
  const BivariateFunction factor = equation[column];
  for (std::size_t c = 0; c < equation.size(); ++c) equation[c] -= factor * pivot[c];
}

}  // namespace

SphereSurface supported_surface(const SupportedFibration& fibration) {
  std::vector<Equation> rows;
  for (const Equation& line :
       {equation(fibration.c, fibration.a), equation(fibration.d, fibration.b)}) {
    rows.push_back(line);
    rows.push_back(derivative(line, Variable::kU));
    rows.push_back(derivative(line, Variable::kV));
  }
  for (std::size_t column = 0; column < 4; ++column) {
    const auto row = rows.begin() + static_cast<std::ptrdiff_t>(column);
    const auto pivot =
        std::find_if(row, rows.end(), [column](const Equation& x) { return !x[column].is_zero(); });
    if (pivot == rows.end()) {
      throw GeometryError(ErrorCode::kNotRational,
                          "The lines and their support functions leave the spheres open: the lines "
                          "of the fibration depend on one parameter only, or lie in one plane.");
    }
    std::iter_swap(row, pivot);
    const BivariateFunction lead = (*row)[column];
    for (BivariateFunction& c : *row) c /= lead;
    for (auto other = rows.begin(); other != rows.end(); ++other) {
      if (other != row) eliminate(*other, *row, column);
    }
  }
  for (auto row = rows.begin() + 4; row != rows.end(); ++row) {
    if (!row->back().is_zero()) {
      throw GeometryError(ErrorCode::kNotRational,
                          "The support functions do not fit the lines of the fibration: no surface "
                          "of spheres has all these tangent planes.");
    }
  }
  return {rows[0].back(), rows[1].back(), rows[2].back(), rows[3].back()};
}

}  // namespace pn
