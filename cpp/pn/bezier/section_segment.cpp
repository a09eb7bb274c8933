// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/section_segment.hpp"

#include <algorithm>
#include <cmath>

#include "pn/algebra/bernstein.hpp"

namespace pn {

std::vector<CircleColumns> circle_columns(Lines lines, int arcs, int form_degree) {
  std::vector<CircleColumns> columns;
  if (lines == Lines::kEven) {
    columns.push_back(circle_part(0, arcs, arcs, form_degree));
  } else {
    for (int i = 0; i < arcs; ++i) columns.push_back(circle_arc(i, arcs, form_degree));
  }
  // A power of two, so the knots stay exact and evenly spaced.
  const double scale = static_cast<double>(kLeastArcs) / arcs;
  for (CircleColumns& column : columns) {
    for (double& knot : column.knots) knot *= scale;
  }
  return columns;
}

WeightRange weight_range(const FormInU<double>& form, const std::vector<CircleColumns>& circle) {
  std::vector<std::vector<double>> rows;
  for (const Form<double>& c : form.coefficient) rows.push_back(to_bernstein(c.coefficients()));
  WeightRange range{INFINITY, -INFINITY};
  for (const CircleColumns& columns : circle) {
    for (const auto& column : columns.coefficients) {
      std::vector<double> factors;
      for (const Rational& x : column) factors.push_back(x.to_double());
      for (std::size_t i = 0; i < rows[0].size(); ++i) {
        double weight = 0;
        for (std::size_t q = 0; q < rows.size(); ++q) weight += factors[q] * rows[q][i];
        if (!std::isfinite(weight)) return {-INFINITY, INFINITY};
        range.least = std::min(range.least, weight);
        range.largest = std::max(range.largest, weight);
      }
    }
  }
  return range;
}

}  // namespace pn
