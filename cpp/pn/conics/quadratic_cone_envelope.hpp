// SPDX-License-Identifier: LGPL-2.1-or-later
// Envelopes of quadratic cones, and dually the tangent planes of conic surfaces.
//
// THEOREM. Let cones x^T C(t) x = 0 of degree k have vertices v(t) of degree h > 0, and let z(t,
// u), quadratic in u, run over their generators as points of the lines v z, of degree n in t up to
// multiples of v. The cones touch their envelope along the quartics x^T C x = x^T C' x = 0, and
//
//     Z(t, u) = (z^T C' z) v - 2 (v^T C' z) z      of bidegree (2 n + h + k - 2, 4),
//     C z                                          of bidegree (n + k, 2)
//
// are its points and their tangent planes. For every u fixed, Z is a rational curve and C z a
// rational developable. (M. Peternell, dissertation TU Wien 1997, Theorems 1.2, 1.3, Corollaries
// 2.1, 2.2, sections 1.5, 2.3.) n is the degree of rational_conic_family.hpp for the conics of the
// generators (quadratic_cones.hpp), at least k - h; n = k - h as a rule.
//
// Proof: v is a point of the quadric C', by v^T C' v = 0, so Z is the second point of the generator
// on C' (stereographic_projection.hpp), and on C as all points of the generator are. (C z).Z = 0,
// and from Z^T C Z = Z^T C' Z = 0 follows Z_t^T C Z = 0 and Z_u^T C Z = 0; C Z is C z times -2 v^T
// C' z. Adding multiples of v to z does not change Z; where z is no polynomial of degree n, it is
// one locally. With z = t^n z_n + ..., C = t^k C_k + ... the leading coefficients of z^T C' z and
// v^T C' z would be k z_n^T C_k z_n = 0 and k v_h^T C_k z_n = 0. QED
//
// In Thomsen's class C the contact curves are the conics in which planes meet the cones
// (contact_plane), so the envelope is their conic surface, of bidegree (n, 2) with the degree n of
// these conics, and z are its points. The formula would give them with a factor of degree 2 in u.
//
// THEOREM. Z runs along one curve only, and there is no surface, exactly if Z^T C'' Z = 0; this is
// a quartic form of the generators, divisible by y^T K y or not. Proof: on a curve of points that
// all cones contain, all derivatives of x^T C x vanish. Conversely 2 Z_t^T C' Z = -Z^T C'' Z = 0
// and Z_t^T C Z = 0 put Z_t on the tangent of the contact curve: C and C' touch nowhere along a
// curve unless their pencil contains the square of a plane, which would contain v and give C' v =
// 0, a vertex at rest. QED Cones that are translated are an example: all touch the curve at
// infinity.
//
// DUALLY C are the planes that touch the conics of a conic surface in their planes v: z are the
// tangents of the conics, C z the points of the surface, and Z its tangent planes.
#pragma once

#include <array>
#include <optional>

#include "pn/algebra/tensor_polynomial.hpp"
#include "pn/conics/quadratic_cones.hpp"
#include "pn/conics/rational_conic_family.hpp"

namespace pn {

/// Homogeneous coordinates of points or planes as polynomials in t and in u = u1 / u0.
template <class T>
using HomogeneousCoordinates = std::array<TensorPolynomial<T>, 4>;

/// Points of a surface with their tangent planes, at the same t and u.
template <class T>
struct ContactElements {
  HomogeneousCoordinates<T> point, plane;
};

/// With planes for points.
template <class T>
ContactElements<T> dual(ContactElements<T> elements) {
  return {std::move(elements.plane), std::move(elements.point)};
}

/// All points of contact lie on one curve, and dually, all tangent planes touch a developable.
/// Decided over Q.
bool envelops_curve(const QuadraticCones& cones);

class QuadraticConeEnvelope {
 public:
  /// Throws GeometryError: kZeroLength when the vertices are one point, kNoRealPoints with the
  /// interval when cones have no real generators.
  explicit QuadraticConeEnvelope(QuadraticCones cones);

  const QuadraticCones& cones() const { return cones_; }
  /// n
  int generator_degree() const { return conics_.degree(); }
  /// Of the points, in t and u: those of the theorem, or lower ones where common factors over Q are
  /// removed.
  std::array<int, 2> degree() const { return degree_; }

  /// z, of degree max(n, h - 1) in t, or n in class C. Throws Undecided.
  HomogeneousCoordinates<RealBall> generators(long precision) const;
  /// Enclosed at about this precision. Throws Undecided.
  ContactElements<RealBall> contact_elements(long precision) const;
  /// Over Q without common factors, if the generators are rational.
  const std::optional<ContactElements<Rational>>& rational_contact_elements() const {
    return rational_;
  }

 private:
  QuadraticCones cones_;
  std::optional<MovingConic> contact_conic_;
  RationalConicFamily conics_;  ///< of contact, or of the generators
  std::optional<ContactElements<Rational>> rational_;
  std::array<int, 2> degree_;
};

}  // namespace pn
