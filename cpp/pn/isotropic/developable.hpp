// SPDX-License-Identifier: LGPL-2.1-or-later
// Developable strips whose offsets are rational.
//
// THEOREM. Let c = (1 - v) c0(t) + v c1(t) be a rational developable surface and N(t) its normal
// along the ruling of t, a coprime polynomial vector, N.N = k q p^2 with monic p and squarefree q.
// The offsets c + d N / sqrt(N.N) of the strip are rational over the rulings exactly when q has the
// degree 0 or 2: then the double cover y^2 = q of the line of rulings is a rational curve. For q =
// 1 they are rational in t; for q = (t - e)^2 + f^2 in s with
//
//     t = e + f (s^2 - 1) / (2 s),      sqrt(q) = f (s^2 + 1) / (2 s).
//
// q has no real root, N having none, so its degree is even. Planes have constant N; cylinders and
// cones of revolution over rational circles have q = 1, parabolic cylinders a q of degree 2;
// elliptic ones have more. The degree along is that of c plus that of sqrt(N.N), the degree
// across 1.
#pragma once

#include <array>
#include <optional>

#include "pn/isotropic/envelope.hpp"

namespace pn {

/// A strip between two directrices over Q.
struct DevelopableStrip {
  std::array<SphereCurve, 2> directrices;
  std::array<RationalPolynomial, 3> normal;  ///< coprime, on the side of c_t x c_v
  RationalPolynomial root;                   ///< p
  RationalPolynomial double_cover;           ///< q
  Rational factor;                           ///< k
};

/// The strip of a family of lines whose torsion vanishes; nothing when its normal turns over
/// between the directrices, at a line of regression or an apex, or when its offsets are not
/// rational.
std::optional<DevelopableStrip> developable_strip(const std::array<SphereCurve, 2>& directrices);

/// The strip in its local parameter.
LocalForms local_forms(const DevelopableStrip& strip, long precision);

Envelope along_strip(const DevelopableStrip& strip);

}  // namespace pn
