// SPDX-License-Identifier: LGPL-2.1-or-later
// Families of quadratic cones x^T C(t) x = 0, and dually of conics by the planes that touch them.
//
// C is a symmetric 4x4 matrix over Q[t] of rank 3, of degree k without common factors. Its kernel v
// is the vertex of the cone, of degree h. In the dual reading x is a plane, C the matrix of the
// planes that touch a conic, and v the plane of the conic.
//
// THEOREM. Let the columns of a be a basis of least degrees f_i of the planes through v, so that
// they add up to h. There is a polynomial r with a^T r = 1, and
//
//     C = a K a^T,    K = r^T C r,    K_ij of degree k - f_i - f_j.
//
// So y^T K y = 0 is the conic of the generators in the bundle of lines through v: y = a^T x for the
// line v x. It is a family of conics of the degrees -f_i and the twist k. (M. Peternell,
// dissertation TU Wien 1997, 1.1, 2.1.)
//
// Proof: a has rank 3 everywhere, so with a point c, v.c = 1, the matrix (a, c) has a constant
// determinant, and three rows of its inverse are r^T. As C v = 0, C depends on a^T x only; r gives
// K. Degrees: a basis of least degrees has rank 3 at infinity too.
#pragma once

#include "pn/conics/moving_conic.hpp"

namespace pn {

/// m^T C m: the quadric C in the coordinates of the columns of m.
template <std::size_t Rows, std::size_t Columns>
std::array<std::array<RationalPolynomial, Columns>, Columns> congruent(
    const std::array<std::array<RationalPolynomial, Rows>, Rows>& c,
    const std::array<std::array<RationalPolynomial, Columns>, Rows>& m) {
  std::array<std::array<RationalPolynomial, Columns>, Columns> result;
  for (std::size_t a = 0; a < Columns; ++a) {
    for (std::size_t b = 0; b < Columns; ++b) {
      for (std::size_t i = 0; i < Rows; ++i) {
        for (std::size_t j = 0; j < Rows; ++j) result[a][b] += m[i][a] * c[i][j] * m[j][b];
      }
    }
  }
  return result;
}

struct QuadraticCones {
  Matrix4OfPolynomials matrix;                                 ///< C
  Vector4OfPolynomials vertex;                                 ///< v
  std::array<Vector3<RationalPolynomial>, 4> planes, inverse;  ///< a, r
  Matrix3<RationalPolynomial> conic;                           ///< K

  /// k and h.
  int degree() const;
  int vertex_degree() const;
};

/// Without common factors of the entries. Throws GeometryError when C is not symmetric or not of
/// rank 3.
QuadraticCones quadratic_cones(const Matrix4OfPolynomials& c);

/// The cones with the vertices (v1, v2, v3) / v4 whose directions d have d^T M d = 0: with the
/// conics M at infinity.
QuadraticCones quadratic_cones(const Vector4OfPolynomials& vertex,
                               const Matrix3<RationalPolynomial>& directions);

/// Conics by the planes that touch them: cones of the dual space.
QuadraticCones tangent_planes_of(const MovingConic& conic);

/// The conics of the generators.
ConicFamily family_of(const QuadraticCones& cones);

/// The derivative by t of every entry.
Matrix4OfPolynomials derivative(const Matrix4OfPolynomials& matrix);
Vector4OfPolynomials derivative(const Vector4OfPolynomials& vector);

}  // namespace pn
