// SPDX-License-Identifier: LGPL-2.1-or-later
// Reparametrization: where a rational surface of spheres touches the direction w(s, t).
//
// THEOREM. Let f(u, v) be a rational surface in R^{3,1} and w(s, t) a rational isotropic vector.
// The equations <w, f_u> = <w, f_v> = 0 are equations between w and the tangent plane of f alone.
// If u(s, t), v(s, t) is a rational solution of rank 2, Gamma = f(u(s, t), v(s, t)) + mu w(s, t)
// has rational sections with rational normals, one of them the envelope of the spheres. (M.
// Peternell, Rational two-parameter families of spheres and rational offset surfaces, section 6.6;
// M. Peternell, B. Odehnal, M. L. Sampoli, On quadratic two-parameter families of spheres and their
// envelopes, sections 2 and 4.)
//
// Two coprime equations p(u, v) = q(u, v) = 0 over Q(s, t) have finitely many solutions, and v is a
// zero of the resultant in u, u of the greatest common divisor of what p and q become with this v.
// The rational ones belong to factors that are linear in v, then in u, so all are found. Solutions
// in which u and v depend on each other lie on a curve of f where the equations are dependent, and
// carry no surface.
//
// For the stereographic w(s, t), which is every direction, the solution exists when the polar lines
// of the tangent planes at infinity are a rational fibration of order one: the surfaces with six
// control spheres, those in a 3-space, and the generalized LN surfaces of types 1, 2 and 3.
#pragma once

#include <vector>

#include "pn/algebra/rational_function.hpp"
#include "pn/isotropic/quadratic_family.hpp"

namespace pn {

/// A surface f of R^{3,1}, the spheres with centre (f1, f2, f3) and signed radius f4.
using SphereSurface = MinkowskiVector<BivariateFunction>;

/// A vector w with <w, w> = 0. The variables of Q(u, v) stand for its parameters s and t.
using IsotropicField = MinkowskiVector<BivariateFunction>;

/// u(s, t), v(s, t)
struct Reparametrization {
  BivariateFunction u, v;

  SphereSurface operator()(const SphereSurface& f) const;
  friend bool operator==(const Reparametrization& a, const Reparametrization& b) {
    return a.u == b.u && a.v == b.v;
  }
};

/// (2 s, 2 t, 1 - s^2 - t^2, 1 + s^2 + t^2)
IsotropicField stereographic_field();

/// Two vectors over Q[u, v] that span the tangent plane, of the least degrees among those with a
/// unit matrix in two columns before denominators are cleared. Throws GeometryError kZeroLength
/// when f depends on one parameter only.
std::array<MinkowskiVector<BivariatePolynomial>, 2> tangent_plane(const SphereSurface& f);

/// The tangent planes depend on one parameter only, so the normals of both sheets do: these are
/// developable. Throws GeometryError kZeroLength when f depends on one parameter only.
bool has_developable_sheets(const SphereSurface& f);

/// All solutions over Q of <w, f_u> = <w, f_v> = 0 that have rank 2, in no special order. Throws
/// GeometryError kZeroLength when f depends on one parameter only.
std::vector<Reparametrization> reparametrizations(const SphereSurface& f, const IsotropicField& w);

}  // namespace pn
