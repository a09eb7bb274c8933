// SPDX-License-Identifier: LGPL-2.1-or-later
// Supported fibrations: the surface of spheres whose tangent planes are polar to given lines.
//
// THEOREM. Let c(u, v), d(u, v) be vectors of R^{3,1} that span a line at infinity for every (u,
// v), and a, b their support functions. A surface f has tangent planes polar to these lines with
// respect to < , > exactly when
//
//     <c, f> = a,  <d, f> = b,   <c_u, f> = a_u,  <c_v, f> = a_v,  <d_u, f> = b_u,  <d_v, f> = b_v:
//
// differentiate the first two and subtract. (D. Gruber, Rationale Parametrisierungen von
// Kugelhuellflaechen, (3.7); M. Peternell, B. Odehnal, M. L. Sampoli, On quadratic two-parameter
// families of spheres and their envelopes, section 4.) The equations are linear in f, and they
// agree only for support functions that fit the fibration: with c(u) and d(v) for any a(u) and
// b(v), in a parabolic net for c = c(u), d = d0 + v c1 under one differential equation, and so on.
//
// The envelope is rational when the fibration has one line through a general point, with u and v
// rational in it: reparametrization.hpp finds that.
#pragma once

#include "pn/isotropic/reparametrization.hpp"

namespace pn {

struct SupportedFibration {
  MinkowskiVector<BivariateFunction> c, d;
  BivariateFunction a, b;
};

/// Throws GeometryError kNotRational when the support functions do not fit the lines, or fit more
/// than one surface.
SphereSurface supported_surface(const SupportedFibration& fibration);

}  // namespace pn
