// SPDX-License-Identifier: LGPL-2.1-or-later
// Translational forms: quadratic families of spheres that are c(p) + d(q) in other parameters.
//
// THEOREM 1. For independent directions x and y of the (u, v) plane the mixed derivative
//
//     B(x, y) = a1 x1 y1 + a2 (x1 y2 + x2 y1) + a3 x2 y2
//
// of f vanishes exactly when f = c(p) + d(q) with (u, v) = p x + q y, for parabolas or lines c and
// d. Let the vectors a1, a2, a3 have the rank 2 and A a1 + B a2 + C a3 = 0. Then the directions are
// the roots of A y^2 - B x y + C x^2, rational where B^2 - 4 A C is a square. Proof: x1 y1 : x1 y2
// + x2 y1 : x2 y2 has to be A : B : C. QED
//
// THEOREM 2 (parabolic cylinders). e = q1 q3 - q2^2 (along_surface.hpp) vanishes for all w exactly
// when a1, a2, a3 are a l^2, a l m, a m^2. Then y = (-m, l) has B(x, y) = 0 for all x, and d is a
// line. Proof: the qi = <w, ai> are linear forms in w, and a quadratic form that vanishes for all
// isotropic w is a multiple of <w, w>, which has rank 4 where q1 q3 - q2^2 has at most 3. So q1 q3
// = q2^2 as forms, and by unique factorization q1 : q2 : q3 = l^2 : l m : m^2. QED
//
// Each skin of a parabolic cylinder has one normal along straight pieces, where the spheres of a
// line touch it: it is developable, and its normals cannot be its parameters. The circles of c or d
// can (circle_chart.hpp), as they can where e vanishes in more than a simple way.
#pragma once

#include <array>
#include <optional>

#include "pn/isotropic/translational_family.hpp"

namespace pn {

/// f(u, v) as c(p) + d(q), the triangle inside the unit square of (p, q). The sense is kept.
struct TranslationalForm {
  TranslationalFamily family;
  /// Of p and q: the constant, the coefficients of u and of v.
  std::array<std::array<Rational, 3>, 2> parameters;

  /// (p, q)
  std::array<double, 2> at(const std::array<double, 2>& uv) const;
};

/// Nothing when there are no such directions over Q, and when a1, a2, a3 are multiples of one
/// vector but f is no parabolic cylinder.
std::optional<TranslationalForm> translational_form(const QuadraticFamily& family);

}  // namespace pn
