// SPDX-License-Identifier: LGPL-2.1-or-later
// Types of conic surfaces and, dually, of envelopes of quadratic cones.
//
// Let C(t) be the planes that touch the conics and v the plane of a conic (quadratic_cones.hpp),
// where v and v' are independent. As C v = 0,
//
//     v^T C' v = 0,    p = C' v = -C v',    v^T C'' v + 2 p.v' = 0:
//
// v touches all quadrics of the pencil lambda C + mu C' in the point p, the pole of the line g = v
// v'. The conic is elliptic, parabolic or hyperbolic when it has 0, 1 or 2 real points on g. For
// cones g is the tangent of the curve of vertices, and the real planes count that touch the cone
// along generators and contain g.
//
// THEOREM 1. It is elliptic where det(K) v'^T C v' > 0, parabolic where that is 0, hyperbolic where
// it is negative. Proof: in the bundle g is the point w = a^T v' of K, and w^T K w = v'^T C v'. For
// K = diag(1, 1, -1), by Sylvester's law of inertia, the sign is that of w2^2 - w0^2 - w1^2, and
// det K makes it independent of the sign of K. QED
//
// THEOREM 2 (G. Thomsen). det(lambda C + mu C') = mu^2 (a lambda^2 + b lambda mu + c mu^2), and a
// is -det(K) v'^T C v' times the square of a constant. The zeros other than mu^2 give the classes
//
//     A  two others,     B  a double one, of rank 3,     C  a double one, of rank 2,
//     D  mu^3 and one,   E  mu^4,                        F  none: the determinant is zero.
//
// A to C are elliptic or hyperbolic, D to F parabolic. (M. Peternell, dissertation TU Wien 1997,
// 1.1, (1.5)-(1.9), where (1.6) is to read C' for C''.)
#pragma once

#include <optional>

#include "pn/conics/quadratic_cones.hpp"

namespace pn {

enum class ConicType { kElliptic, kParabolic, kHyperbolic };

/// det(K) v'^T C v': the sign tells the type at every t where C has rank 3 and v, v' are
/// independent.
RationalPolynomial type_discriminant(const QuadraticCones& cones);

/// Of the conic at t; nothing where C(t) has a lower rank or v and v' are dependent.
std::optional<ConicType> conic_type(const QuadraticCones& cones, const Rational& t);

/// a, b, c of the second theorem.
Vector3<RationalPolynomial> tangent_pencil(const QuadraticCones& cones);

enum class ThomsenClass { kA, kB, kC, kD, kE, kF };

/// Of all conics but finitely many; nothing when v is constant.
std::optional<ThomsenClass> thomsen_class(const QuadraticCones& cones);

/// Of a family of class C: the quadric of rank 2 is the plane p = C' v, which contains v, and this
/// other one. The cones touch their envelope along conics in it; dually the tangent planes of the
/// conics envelop quadratic cones. Without common zeros; nothing for other classes.
std::optional<Vector4OfPolynomials> contact_plane(const QuadraticCones& cones);

/// Of the conic at t; nothing where C(t) has a lower rank or v and v' are dependent.
std::optional<ThomsenClass> thomsen_class(const QuadraticCones& cones, const Rational& t);

}  // namespace pn
