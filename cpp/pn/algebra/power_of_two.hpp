// SPDX-License-Identifier: LGPL-2.1-or-later
// Powers of two near exact numbers: what homogeneous coordinates are divided by when they may be
// too large for doubles.
#pragma once

#include <vector>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

/// 2^k with |x| / 2^k between 1/2 and 2, for x that is not zero.
Rational power_of_two_near(const Rational& x);

/// That of the largest coefficient, about; 1 when all polynomials are zero.
Rational power_of_two_near(const std::vector<RationalPolynomial>& polynomials);

}  // namespace pn
