// SPDX-License-Identifier: LGPL-2.1-or-later
// Kernels of matrices of real balls, of a rank that is proved or known.
#pragma once

#include <optional>
#include <vector>

#include "pn/algebra/ball.hpp"

namespace pn {

/// A basis of the kernel of a matrix of this rank, each vector with one coordinate 1 where the
/// others of the basis have 0. Elimination with complete pivoting proves that the rank is no less;
/// that it is no more must be known, as it is of `rank` rows. Nothing when the pivots are not
/// certainly different from zero. The matrix has rows of one size.
std::optional<std::vector<std::vector<RealBall>>> kernel(std::vector<std::vector<RealBall>> matrix,
                                                         std::size_t rank);

}  // namespace pn
