// SPDX-License-Identifier: LGPL-2.1-or-later
// Conics in moving planes.
//
// A frame spans the plane by three points, and C(t) is the conic in their coordinates. A family may
// also be given by the planes that touch its conics: e^T D e = 0 for a symmetric 4x4 matrix D(t) of
// rank 3. Then the plane of the conic is the kernel of D.
//
// THEOREM. Let the columns of b be a basis of all polynomial points of the plane g(t), g.b = 0,
// without common zeros and of least degrees; they add up to deg g for coprime entries. If D = b K
// b^T, the points of the conic have the matrix adj K, which is a multiple of r^T adj(D_r) r for
// three rows r of b and the same rows and columns D_r of D. (M. Peternell, dissertation TU Wien
// 1997, 1.1.)
//
// Proof: D_r = r K r^T, so adj D_r = adj(r)^T adj(K) adj(r), and r adj(r) = det r.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "pn/conics/conic_family.hpp"

namespace pn {

struct MovingConic {
  /// Rows: x, y, z [mm] times the weight, and the weight; columns: three points that span the
  /// plane.
  std::array<Vector3<RationalPolynomial>, 4> frame;
  Matrix3<RationalPolynomial> conic;  ///< y^T C y = 0 for the point frame * y
};

/// The part of each conic where cut . y > 0, y in the coordinates of its frame; all of it without a
/// cut, an ellipse.
struct ConicSpan {
  MovingConic conic;
  std::optional<Vector3<RationalPolynomial>> cut;
};

/// With the degrees of the columns of the frame.
ConicFamily family_of(const MovingConic& conic);

using Vector4OfPolynomials = std::array<RationalPolynomial, 4>;
using Matrix4OfPolynomials = std::array<Vector4OfPolynomials, 4>;

/// The plane x of three points, or the point of three planes: x.y = det(y, a, b, c).
Vector4OfPolynomials join(const Vector4OfPolynomials& a, const Vector4OfPolynomials& b,
                          const Vector4OfPolynomials& c);

/// The kernel of a symmetric matrix of rank 3, without common zeros. Throws GeometryError when the
/// matrix is another one, with sentences that begin with `name`.
Vector4OfPolynomials kernel_of(const Matrix4OfPolynomials& matrix, const std::string& name);

/// The basis b of the theorem for a plane that is not zero.
std::array<Vector3<RationalPolynomial>, 4> plane_basis(const Vector4OfPolynomials& plane);

/// The conics of the planes (e1, e2, e3, e4), e1 x + e2 y + e3 z + e4 = 0, with e^T D e = 0. Throws
/// GeometryError when D is not symmetric or not of rank 3.
MovingConic conic_of_tangent_planes(const Matrix4OfPolynomials& d);

}  // namespace pn
