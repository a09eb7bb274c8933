// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces from planes: PN surfaces by their tangent planes, and the families of spheres around
// them.
//
// THEOREM 1 (universal parametrization). For polynomials a, b, c, d the vector
//
//     w = (2 (a c + b d), 2 (b c - a d), a^2 + b^2 - c^2 - d^2, a^2 + b^2 + c^2 + d^2)
//
// is isotropic, and up to a factor every isotropic vector of polynomials is of this form.
// (R. Dietz, J. Hoschek, B. Juettler, CAGD 10 (1993) 211-229.)
//
// THEOREM 2. Let N = (w1, w2, w3) and h a rational function. Where F = det(N, N_u, N_v) is not zero
// identically, the planes N.x = h touch the surface
//
//     q = (h N_u x N_v + h_u N_v x N + h_v N x N_u) / F
//
// with the rational unit normal n = N / w4; every PN surface that is not developable is of this
// form. (M. Peternell, Rational two-parameter families of spheres and rational offset surfaces,
// eq. 17.)
//
// THEOREM 3. For every rational function r the family of spheres f = (q + r n, r) in R^{3,1} is a
// MOS surface: w is orthogonal to f_u and f_v. (Ibid., Theorem 14 and eq. 18, there with r = w D.)
//
// THEOREM 4. Let f = (m, p) be rational, N = m_u x m_v not zero and
//
//     A = <f_u, f_u> <f_v, f_v> - <f_u, f_v>^2.
//
// The unit vectors n with <(n, 1), f_u> = <(n, 1), f_v> = 0 are
//
//     n = (p_u m_v x N + p_v N x m_u +- sqrt(A) N) / N.N,
//
// so f is a MOS surface exactly when A is the square of a rational function, and the two sheets of
// the envelope are m - p n. (Ibid., section 3.1.) Proof: with E, F, G the products of m_u and m_v,
// the tangential part t of n has the products p_u, p_v with them, and A = N.N - (G p_u^2 - 2 F p_u
// p_v + E p_v^2) = N.N (1 - t.t). QED.
#pragma once

#include <array>
#include <optional>

#include "pn/algebra/rational_function.hpp"
#include "pn/isotropic/quadratic_family.hpp"
#include "pn/isotropic/rational_sections.hpp"

namespace pn {

/// A surface and its unit normal.
struct OrientedSurface {
  std::array<BivariateFunction, 3> point, normal;
};

/// The vector w of theorem 1 from (a, b, c, d).
MinkowskiVector<BivariatePolynomial> universal_isotropic_vector(
    const std::array<BivariatePolynomial, 4>& a);

/// The surface that the planes (w1, w2, w3).x = h touch, for an isotropic w. Throws GeometryError
/// (kDevelopable) when F = 0 identically.
OrientedSurface from_planes(const MinkowskiVector<BivariatePolynomial>& w,
                            const BivariateFunction& h);

/// The MOS surface of theorem 3. Spheres are signed: their centres are on the side of the normal
/// where r > 0.
MinkowskiVector<BivariateFunction> spheres_along(const OrientedSurface& surface,
                                                 const BivariateFunction& r);

/// A root of A, or nothing when f is no MOS surface.
std::optional<BivariateFunction> mos_root(const MinkowskiVector<BivariateFunction>& f);

/// Both sheets of the envelope of a MOS surface. Throws GeometryError: kNotRational when f is no
/// MOS surface, kZeroLength when its centres are no surface.
std::array<OrientedSurface, 2> envelope_sheets(const MinkowskiVector<BivariateFunction>& f);

/// Its sections over the unit square, of which the length is 1.
RationalSections rational_sections(const OrientedSurface& surface);

}  // namespace pn
