// SPDX-License-Identifier: LGPL-2.1-or-later
// Products of signs at real roots, decided exactly: a polynomial that is not zero at a root has a
// sign there in small enough balls, and common roots are found over Q.
#pragma once

#include <optional>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

/// The product of the signs of f at the real roots of p, which is not zero, each as often as its
/// multiplicity; nothing when both have a common real root.
std::optional<int> sign_at_real_roots(const RationalPolynomial& p, const RationalPolynomial& f);

}  // namespace pn
