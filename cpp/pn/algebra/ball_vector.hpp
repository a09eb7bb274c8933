// SPDX-License-Identifier: LGPL-2.1-or-later
// Ball vectors: sums of products of their balls, rounded seldom.
//
// Term by term every product and every sum would be rounded, which takes several times as long. Of
// double words the small parts of all terms are summed as doubles first (DoubleWordSum), of longer
// balls Arb sums the mantissas. (F. Johansson, Faster arbitrary-precision dot product and matrix
// multiplication, ARITH 26, 2019.)
#pragma once

#include <vector>

#include "pn/algebra/ball.hpp"

namespace pn {

/// a_0 b_0 + a_1 b_1 + ...
RealBall dot(const std::vector<RealBall>& a, const std::vector<RealBall>& b);

/// sum_k += a_0 b_k + a_1 b_(k-1) + ... + a_k b_0, a product of polynomials, or as many of its
/// coefficients as the sum has. Neither factor is empty.
void add_product(std::vector<RealBall>& sum, const std::vector<RealBall>& a,
                 const std::vector<RealBall>& b);
void add_product(std::vector<ComplexBall>& sum, const std::vector<ComplexBall>& a,
                 const std::vector<ComplexBall>& b);

/// The numbers times the power of two with which the largest midpoint is in [1/2, 1): homogeneous
/// coordinates that may be too large for doubles.
std::vector<RealBall> normalized(std::vector<RealBall> numbers);

}  // namespace pn
