// SPDX-License-Identifier: LGPL-2.1-or-later
// Conic points: all points of a moving conic as homogeneous forms in t and u.
//
// THEOREM. Let three points b_i(t) of degrees f_i in homogeneous coordinates span the plane of the
// conic with the matrix C(t). With B(t) of rational_conic_family.hpp,
//
//     x(t, u) = b(t) B(t) (u0^2, u0 u1, u1^2)^T
//
// has bidegree (n, 2) and runs once through all points of all conics. (M. Peternell, dissertation
// TU Wien 1997, 1.1 to 1.5, where the degree in t is (12, 2) in the example for which (4, 2)
// suffices.)
//
// Where the conics of the whole line of t do not all have real points, s in [0, 1] takes the place
// of t, and n is twice as high (interval_substitution.hpp).
//
// ELLIPSES. Let w be the weight of b, the line at infinity w.y = 0, and tau^a the second invariant
// of C at c (conic_family.hpp). The weight of x has, up to a positive constant, the determinant
//
//     w^T adj(C) w / product of (s - c)^(2 floor(a / 2)),
//
// and the conic is an ellipse or a point, all of it finite, exactly where this is positive. Proof:
// B^T C B = g J, J constant of signature (2, 1), and the determinant of y^T J y = (w^T B) J^-1 (w^T
// B)^T = g w^T C^-1 w; g / det C has the zeros and poles of the product by the degree theorem of
// conic_family.hpp.
#pragma once

#include <array>

#include "pn/conics/interval_substitution.hpp"
#include "pn/conics/moving_conic.hpp"
#include "pn/conics/rational_conic_family.hpp"
#include "pn/isotropic/form_in_u.hpp"

namespace pn {

/// (x, y, z) [mm] times the weight, and the weight; all of one degree in t, quadratic in u.
template <class T>
using HomogeneousConic = std::array<FormInU<T>, 4>;

HomogeneousConic<double> midpoint(const HomogeneousConic<RealBall>& x);

class ConicPoints {
 public:
  /// Of the conics for t in [0, 1]. Throws GeometryError (kSingularConics, kNoRealPoints).
  explicit ConicPoints(const MovingConic& conic);

  /// n.
  int degree() const { return conics_.degree(); }
  /// The determinant of the weight by the theorem, a polynomial in s.
  RationalPolynomial ellipticity() const;
  /// t at a parameter s.
  double t_at(double s) const;
  /// x(t, u), with a weight that is not negative for u = (1 : 0) in the middle. Throws Undecided.
  HomogeneousConic<RealBall> operator()(long precision) const;

 private:
  ConicPoints(const MovingConic& conic, const ConicFamily& family);
  ConicPoints(const MovingConic& conic, const ConicFamily& family,
              const IntervalSubstitution& substitution);

  ConicFamily family_;  ///< over s
  RationalConicFamily conics_;
  IntervalSubstitution substitution_;
  std::array<Vector3<RationalPolynomial>, 4> frame_;
  Vector3<int> frame_degree_{};
};

}  // namespace pn
