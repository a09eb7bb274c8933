// SPDX-License-Identifier: LGPL-2.1-or-later
// The pencil of a quadric: the ruled quadric of R^{3,1} that has the same isotropic hypersurface.
//
// THEOREM. The dual quadrics of the pencil spanned by a quadric phi of R^3 and the absolute quadric
// n.n = n4^2 have the isotropic hypersurface of phi in common. One of its singular members is a
// ruled quadric psi in a space x_i = 0 whose rulings are real cones where phi is: so Gamma is that
// along the rulings g of psi. With half-axes A >= B >= C in the directions 1, 2, 3:
//
//   ellipsoid             x1^2 / (A^2 - B^2) - x3^2 / (B^2 - C^2) + x4^2 / B^2 = 1,  x2 = 0
//       g(T) = (G (1 - T^2), 0, L (1 + T^2); 2 B T),  G^2 = A^2 - B^2, L^2 = B^2 - C^2,
//       real for |T| <= sqrt((A - C) / (A + C));
//   two-sheet hyperboloid  x1^2 / A^2 - x2^2 / B^2 - x3^2 / C^2 = 1, B >= C only,
//                          x1^2 / (A^2 + B^2) + x3^2 / (B^2 - C^2) - x4^2 / B^2 = 1,  x2 = 0
//       g(T) = (P (1 - T^2), 0, 2 Q T; -B (1 + T^2)),  P^2 = A^2 + B^2, Q^2 = B^2 - C^2,
//       real for |T| <= (sqrt(A^2 + C^2) - C) / A;
//   elliptic paraboloid    x1^2 / A + x2^2 / B = 2 x3,
//                          -x2^2 / (A - B) + x4^2 / A = 2 x3 - A,  x1 = 0
//       g(T) = (0, sqrt(A - B), T; sqrt(A)),  real for T <= -sqrt(B).
//
// (M. Peternell, dissertation TU Wien 1997, Theorem 4.6; the constant of the paraboloid corrected.)
// At the ends of these intervals the cone is a plane that touches phi in an umbilic. A quadratic
// substitution, T = T0 (s^2 - r^2) / (s^2 + r^2) for the closed ones, makes D a form with double
// roots at both ends and two conjugate pairs in closed form, so no root has to be isolated and
// nearly equal axes are as good as others. Each regular point of phi lies on one ruling: t runs
// from an umbilic, a pole of the parametrization, over all of phi to the opposite umbilic, or to
// infinity.
//
// DEGREES. w has the bidegree (4, 2), for the paraboloid (2, 2); so has the support function S /
// w4, and with the dual quadric K every section is K (N, S) times w4, plus d N: (8, 4), for the
// paraboloid (6, 4). Where two half-axes are equal phi is a canal surface and its sections have the
// bidegree (8, 2), (6, 2); a sphere (2, 2).
#pragma once

#include <Eigen/Dense>
#include <array>
#include <memory>
#include <vector>

#include "pn/isotropic/envelope.hpp"

namespace pn {

/// Gamma of a quadric over the local parameter t on [0, 1], and the t of a normal.
class QuadricFamily {
 public:
  virtual ~QuadricFamily() = default;
  virtual LocalForms forms(long precision) const = 0;
  /// Where the circle of t passes through a unit normal of the quadric.
  virtual double parameter(const Eigen::Vector3d& normal) const = 0;
};

/// x^2/a^2 + y^2/b^2 + z^2/c^2 = 1, n outwards; t = 0 and t = 1 are opposite umbilics.
std::shared_ptr<const QuadricFamily> ellipsoid_family(const std::array<Rational, 3>& half_axes);

/// The sheet z > 0 of z^2/c^2 - x^2/a^2 - y^2/b^2 = 1, n away from the axis; t = 0 is an umbilic.
std::shared_ptr<const QuadricFamily> two_sheet_hyperboloid_family(
    const std::array<Rational, 3>& half_axes);

/// z = c (x^2/a^2 + y^2/b^2), n away from the axis; t = 0 is an umbilic, and t = 1 lies somewhat
/// beyond all of these unit normals.
std::shared_ptr<const QuadricFamily> elliptic_paraboloid_family(
    const std::array<Rational, 3>& half_axes, const std::vector<Eigen::Vector3d>& far_normals);

}  // namespace pn
