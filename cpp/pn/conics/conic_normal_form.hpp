// SPDX-License-Identifier: LGPL-2.1-or-later
// The parametrization of a family of conics whose determinant has no zeros.
//
// When det Q is constant on the whole projective line, the columns of the lattice have degrees m -
// a, m, m + a. For a = 0 the conic Q is constant and indefinite, and a diagonalization gives
//
//     x^2 + y^2 = z^2,    (u0^2 - u1^2, 2 u0 u1, u0^2 + u1^2).
//
// For a > 0 the lowest column w0 runs on the conics, alpha = Q(w0, w2) and beta = Q(w1, w1) are
// constant, and with w1 - (Q12 / alpha) w0, w2 - (Q22 / 2 alpha) w0 the points are
//
//     -(beta / 2 alpha) u0^2 w0 + u0 u1 w1 + u1^2 w2,
//
// without any square root. The degree in t is m + a. For a = 0 the same holds with a rational point
// w0 of the constant conic, w1 on its tangent and w2 off it.
#pragma once

#include <array>
#include <optional>

#include "pn/algebra/form.hpp"
#include "pn/conics/conic_family.hpp"

namespace pn {

/// Columns k = 0, 1, 2 are the coefficients of u0^2, u0 u1, u1^2.
using QuadraticColumns = Matrix3<RealBall>;

/// The points of a constant conic; nothing when the balls do not prove that it is indefinite and
/// not singular.
std::optional<QuadraticColumns> points_of_constant_conic(const Matrix3<RealBall>& conic);

/// The same from a rational point of the conic, over Q.
Matrix3<Rational> points_of_constant_conic(const Matrix3<Rational>& conic,
                                           const Vector3<Rational>& point);

/// What an unbalanced lattice needs: its columns in ascending degree, and the forms of Q.
template <class T>
struct UnbalancedLattice {
  Matrix3<Form<T>> basis;  ///< [i][j]
  T alpha, beta;           ///< Q02, Q11
  Form<T> q12, q22;        ///< of degrees a and 2 a
};

/// Coefficients of u0^2, u0 u1, u1^2.
template <class T>
Matrix3<Form<T>> points_of_unbalanced_lattice(const UnbalancedLattice<T>& lattice) {
  const T half_inverse = T(1L) / (lattice.alpha + lattice.alpha);
  const T factor = T(0L) - lattice.beta * half_inverse;
  Matrix3<Form<T>> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [w0, w1, w2] = lattice.basis[i];
    points[i][0] = w0 * factor;
    points[i][1] = w1;
    points[i][1] -= lattice.q12 * w0 * (half_inverse + half_inverse);
    points[i][2] = w2;
    points[i][2] -= lattice.q22 * w0 * half_inverse;
  }
  return points;
}

}  // namespace pn
