// SPDX-License-Identifier: LGPL-2.1-or-later
// Products of signs at real roots, without isolating a root.
//
// THEOREM. Let p and f be polynomials over Q without common roots, a the leading coefficient of p
// and n the degree of f. The product of the signs of f at the real roots of p, each as often as its
// multiplicity, is the sign of a^n Res(p, f).
//
// Proof: Res(p, f) = a^n times the product of f at all roots of p (B. L. van der Waerden, Algebra
// I, section 35), and conjugate roots contribute |f(z)|^2 > 0 to it. ∎
#pragma once

#include <optional>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

/// The product of the signs of f at the real roots of p, which is not zero; nothing when both have
/// a common real root. Decided exactly.
std::optional<int> sign_at_real_roots(const RationalPolynomial& p, const RationalPolynomial& f);

}  // namespace pn
