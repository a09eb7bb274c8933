// SPDX-License-Identifier: LGPL-2.1-or-later
// Matrices over Q: exact rank, null space and inverse.
#pragma once

#include <vector>

#include "pn/algebra/rational.hpp"

namespace pn {

/// By rows, which are equally long.
using RationalMatrix = std::vector<std::vector<Rational>>;

/// The reduced row echelon form, without rows of zeros: a basis of the row space that does not
/// depend on the rows chosen. Its size is the rank.
RationalMatrix row_echelon_form(const RationalMatrix& matrix);

/// A basis of the vectors x of this length with M x = 0.
RationalMatrix null_space(const RationalMatrix& matrix, std::size_t length);

/// Throws std::domain_error when the matrix is singular.
RationalMatrix inverse(const RationalMatrix& matrix);

}  // namespace pn
