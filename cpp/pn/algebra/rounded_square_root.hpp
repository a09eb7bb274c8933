// SPDX-License-Identifier: LGPL-2.1-or-later
// Square roots as rational numbers, exact where they are rational.
//
// sqrt(n / d) = sqrt(n d) / d with n d >= 1, and floor(sqrt(n d 4^k)) / 2^k is less than 2^-k off.
#pragma once

#include "pn/algebra/rational.hpp"

namespace pn {

/// The root of a positive number: exact for squares, else with a relative error below 2^-bits.
Rational rounded_square_root(const Rational& x, long bits);

}  // namespace pn
