// SPDX-License-Identifier: LGPL-2.1-or-later
// Bases of least degrees of modules over Q[t].
//
// THEOREM (T. Mulders, A. Storjohann, On lattice reduction for polynomial matrices, J. Symb. Comp.
// 35, 2003). If no two columns have the highest degree last in the same row, the degrees of the
// columns are the least that a basis of the module can have. Two that do are reduced by taking a
// multiple of the lower one from the other.
#pragma once

#include <cstddef>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

/// The last of the entries of highest degree in a column.
struct LeadingTerm {
  std::size_t row;
  int degree;
  Rational coefficient;
};

/// Until all rows of leading terms differ. leading(j) is the LeadingTerm of column j, which is
/// never zero; add_multiple(i, factor, j) adds a multiple of column j to column i.
template <class Leading, class AddMultiple>
void reduce_columns(std::size_t count, const Leading& leading, const AddMultiple& add_multiple) {
  for (bool reduced = false; !reduced;) {
    reduced = true;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        const LeadingTerm high = leading(i), low = leading(j);
        if (i == j || high.row != low.row || high.degree < low.degree) continue;
        add_multiple(i,
                     RationalPolynomial(-(high.coefficient / low.coefficient)) *
                         power_of_t(high.degree - low.degree),
                     j);
        reduced = false;
      }
    }
  }
}

}  // namespace pn
