// SPDX-License-Identifier: LGPL-2.1-or-later
// Separated sheets: families whose two normals are each rational in the parameters of the family.
//
// By sheet.hpp the normals at (u, v) are n = (T +- sqrt(Delta) N) / |N|^2, with polynomials T and N
// = m_u x m_v of degrees 4 and 2 for a quadratic family. As a rule they are one function of two
// values, and the sheets need other parameters. THEOREM. The normals are rational functions of u
// and v over R exactly when
//
//     Delta = c D^2     with a polynomial D over Q and a rational c > 0.
//
// Proof: n.N = +-sqrt(Delta) is rational with n, and a polynomial S, since its square is one. Let S
// be sqrt(c) D with a monic D; then c is the leading coefficient of Delta, and D is over Q, because
// the coefficients of a monic root follow one after the other from those of its square. QED
//
// COROLLARY. So it is when a sheet is a plane, with one normal everywhere: a flat plate of constant
// or linear radius, six spheres that touch one plane (f in an isotropic 3-space), a plane in
// R^{3,1}.
//
// With it the sections m + (r + d) n are of total degree 6 in (u, v), or less where T + sqrt(c) D
// N and |N|^2 have a common factor: 2 for a plane. (M. Peternell, Rational two-parameter families
// of spheres and rational offset surfaces, section 2, gives the normal forms where it happens.)
#pragma once

#include <array>
#include <optional>

#include "pn/isotropic/along_surface.hpp"
#include "pn/isotropic/sheet.hpp"

namespace pn {

/// n = (rational + sqrt(radicand) irrational) / weight, without a common factor.
struct RationalNormal {
  std::array<TensorPolynomial<Rational>, 3> rational, irrational;
  Rational radicand;                  ///< positive; where it is a square, `irrational` is zero
  TensorPolynomial<Rational> weight;  ///< positive at u = v = 0
};

/// The normal of a sheet; nothing when Delta is no multiple of a square. Delta > 0 at u = v = 0.
std::optional<RationalNormal> rational_normal(const QuadraticFamily& family, Sheet sheet);

/// The sections in the parameters of the family, enclosed at this precision [bits].
SurfaceSections<RealBall> sections(const QuadraticFamily& family, const RationalNormal& normal,
                                   long bits);

}  // namespace pn
