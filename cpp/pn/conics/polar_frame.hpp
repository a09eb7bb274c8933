// SPDX-License-Identifier: LGPL-2.1-or-later
// Frames of a conic surface in the planes of its conics, and dually of cones in their bundles.
//
// Let K be the conics of quadratic_cones.hpp, lines l of the plane with l^T K l = 0, and g = a^T v'
// the line in which the plane meets its neighbours.
//
// THEOREM. For an elliptic or hyperbolic family let p = K g be the pole of g, eta a line through p
// that does not touch the conic, q = K eta its pole, on g, and zeta = p x q. Then g, eta, zeta are
// conjugate in pairs: with these rows, S K S^T = diag(c0, c1, c2).
//
// For a parabolic family p = K g is a point of the conic. Let eta be another line through p, q = K
// eta its pole, on g, and zeta the second tangent through q. Then g^T K g = zeta^T K zeta = 0 and
// eta is conjugate to both: c02 and c11 are all that is left of S K S^T.
//
// Proof: eta^T K g = eta.p = 0, zeta^T K g = zeta.p = 0, zeta^T K eta = zeta.q = 0. QED
//
// Everything is rational in t. (M. Peternell, dissertation TU Wien 1997, (1.10)-(1.14),
// (2.8)-(2.11).) Parametrizations do without these frames, which raise the degree.
#pragma once

#include "pn/conics/quadratic_cones.hpp"

namespace pn {

struct PolarFrame {
  Vector3<RationalPolynomial> g, eta, zeta;  ///< lines, each without common zeros
  Vector3<RationalPolynomial> p, q, r;       ///< points: r is g x eta, or eta x zeta when parabolic
  Matrix3<RationalPolynomial> form;          ///< S K S^T
  bool is_parabolic;                         ///< c02 and c11 instead of the diagonal
};

/// Throws GeometryError kZeroLength when v is constant.
PolarFrame polar_frame(const QuadraticCones& cones);

/// The point of space with these coordinates in the basis a of the plane, or the plane through the
/// vertex.
Vector4OfPolynomials in_space(const QuadraticCones& cones,
                              const Vector3<RationalPolynomial>& point);

}  // namespace pn
