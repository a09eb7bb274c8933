// SPDX-License-Identifier: LGPL-2.1-or-later
// The 42 affine classes of quadratic surfaces x = q(u, v).
//
// Two surfaces whose coordinates are polynomials of degree two in (u, v) are of one class when
// affine maps of the parameter plane and of space carry one to the other. So the class is that of
// the vector space V spanned by the coordinates, modulo constants. Let W be the space of its
// quadratic parts, M that of its linear forms: V is given by W, M and a linear map phi from W to
// the linear forms modulo M. THEOREM. The class is determined by
//
//   - dim V and dim W,
//   - the squares l^2 of linear forms in W, or of a single form its rank and sign, and whether M
//     contains such l,
//   - the roots of the binary cubic c(l) = phi(l^2) ^ l, where l^2 is in W and l in M if M != 0.
//
// It has 42 values, one for each of the normal forms of D. Gruber (Diplomarbeit, TU Wien 2008,
// table 3.1), which are named dimension-...: "3-2-1b" for (u^2, v^2, u). Reason: a shift of (u, v)
// adds to phi(q) the derivative of q along it, which does not change c(l), as d(l^2) is a multiple
// of l. For W = all quadratic forms, Hom(W, linear forms) modulo shifts is the space of binary
// cubics, of which there are five kinds; for smaller W the rest is what c says at the squares in W:
// with two or conjugate complex ones, or a double one, the number of them at which c vanishes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "pn/algebra/rational.hpp"

namespace pn {

/// Of u^2, u v, v^2, u, v.
using QuadraticCoordinate = std::array<Rational, 5>;

/// The name of the class in Gruber's table.
std::string affine_class(const std::vector<QuadraticCoordinate>& coordinates);

}  // namespace pn
