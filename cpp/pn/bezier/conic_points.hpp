// SPDX-License-Identifier: LGPL-2.1-or-later
// Conic points: all points of a moving conic as homogeneous forms in t and u, and which of them are
// finite.
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
// LINES. For a line c.y = 0 let q_c = c.x, a quadratic form in u; for the line at infinity it is
// the weight w. The polar form of the determinant, [p, q] = (p0 q2 + p2 q0) / 2 - p1 q1, has for
// two lines, up to one positive constant, the value
//
//     [c, d] = c^T adj(C) d / product of (s - r)^(2 floor(a / 2)),
//
// over the zeros r of det C and their Smith types (0, a, b). Proof: B^T C B = g J with a constant J
// of signature (2, 1), so [c, d] = (c^T B) J^-1 (d^T B)^T = g c^T C^-1 d, and g / det C has the
// zeros and poles of the product by the degree theorem of conic_family.hpp.
//
// FINITE PARTS. All of a conic is finite, an ellipse or a point, exactly where [w, w] > 0. The part
// where q_c / w > 0 is one finite arc between two points exactly where
//
//     [c, c] < 0   and   [w, w] > 0 or [c, w] < 0   and   [c, w]^2 > [w, w] [c, c];
//
// then h = w - ([c, w] / [c, c]) q_c, up to the common sign of w and q_c, is positive for all u.
// Proof: q_c has two zeros for [c, c] < 0. By the S-lemma (V. A. Yakubovich, 1971) w > 0 wherever
// q_c
// >= 0 exactly if w - l q_c is positive for some l >= 0. Its determinant [w, w] - 2 l [c, w] + l^2
// [c, c] is concave in l, with its maximum ([w, w] [c, c] - [c, w]^2) / [c, c] at l = [c, w] / [c,
// c]; at l = 0 it is [w, w]. Its sign is that of w at the zeros of q_c.
#pragma once

#include <array>
#include <optional>

#include "pn/conics/interval_substitution.hpp"
#include "pn/conics/moving_conic.hpp"
#include "pn/conics/rational_conic_family.hpp"
#include "pn/isotropic/form_in_u.hpp"

namespace pn {

/// (x, y, z) [mm] times the weight, and the weight; all of one degree in t, quadratic in u.
template <class T>
using HomogeneousConic = std::array<FormInU<T>, 4>;

/// The points, and q_c of a cut; without a cut no coefficients.
template <class T>
struct ConicForms {
  HomogeneousConic<T> point;
  FormInU<T> cut;
};

FormInU<double> midpoint(const FormInU<RealBall>& form);
ConicForms<double> midpoint(const ConicForms<RealBall>& x);

/// h at t: the weight of a whole conic.
template <class T>
Vector3<T> definite_form(const ConicForms<T>& x, const T& t) {
  const auto at = [&](const FormInU<T>& form) -> Vector3<T> {
    return {form.coefficient[0](t), form.coefficient[1](t), form.coefficient[2](t)};
  };
  Vector3<T> h = at(x.point[3]);
  if (x.cut.coefficient.empty()) return h;
  const Vector3<T> q = at(x.cut);
  const T mixed = (h[0] * q[2] + h[2] * q[0]) / T(2.0) - h[1] * q[1];
  const T factor = mixed / (q[0] * q[2] - q[1] * q[1]);
  for (std::size_t k = 0; k < 3; ++k) h[k] -= factor * q[k];
  return h;
}

/// [w, w] and, with a cut, [c, w] and [c, c]; polynomials in s, up to one positive constant.
struct LineInvariants {
  RationalPolynomial infinity, mixed, cut;
};

class ConicPoints {
 public:
  /// Of the conics for t in [0, 1]. Throws GeometryError (kSingularConics, kNoRealPoints).
  explicit ConicPoints(const ConicSpan& span);

  /// n.
  int degree() const { return conics_.degree(); }
  bool has_cut() const { return cut_.has_value(); }
  LineInvariants invariants() const;
  /// The ends of the arcs are rational over R: [c, c] is a constant times a square.
  bool has_rational_ends() const;
  /// t at a parameter s.
  double t_at(double s) const;
  /// Over [0, 1], with the sign by which h is positive. Throws Undecided.
  ConicForms<RealBall> operator()(long precision) const;

 private:
  ConicPoints(const ConicSpan& span, const ConicFamily& family);
  ConicPoints(const ConicSpan& span, const ConicFamily& family,
              const IntervalSubstitution& substitution);

  ConicFamily family_;  ///< over s
  RationalConicFamily conics_;
  IntervalSubstitution substitution_;
  std::array<Vector3<RationalPolynomial>, 4> frame_;
  Vector3<int> frame_degree_{};
  std::optional<Vector3<RationalPolynomial>> cut_;
  int cut_degree_ = 0;  ///< of its components, less those of the frame
};

}  // namespace pn
