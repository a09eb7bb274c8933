// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadratic families: two-parameter families of spheres from six spheres, and where their envelope
// is real and regular.
//
// A sphere with centre m and radius r is the point (m, -r) of R^{3,1}. A quadratic triangular
// Bezier surface there is a family of spheres
//
//     f(u, v) = a1 u^2/2 + a2 u v + a3 v^2/2 + a4 u + a5 v + a6 = sum b_ijk (2! / i! j! k!) u^i v^j
//     w^k,     w = 1 - u - v.
//
// Let g = (g11, g12, g22) be the Gram matrix of f_u, f_v. THEOREM 1. The envelope is real at (u,
// v), and has two sheets there, exactly when the tangent plane is space-like: Delta = det g > 0.
// (M. Peternell, Rational two-parameter families of spheres and rational offset surfaces, section
// 2.) Delta is of degree 4.
//
// THEOREM 2. Where Delta > 0 the point at the signed distance rho from the centre, m + rho n with n
// a normal of the sheet, is singular exactly when
//
//     det(g - rho H) = 0,     H_ij = n.m_ij + r_ij.
//
// Proof: n.m_i + r_i = 0 gives n.m_ij + n_j.m_i + r_ij = 0, that is n_j.m_i = -H_ij. The tangent
// vectors x_i = m_i + r_i n + rho n_i (the offset adds no derivative to r) are perpendicular to n,
// as are t_i = m_i + r_i n, which are independent since their Gram matrix m_i.m_j - r_i r_j = g_ij
// has determinant Delta. The products x_j.t_i are g_ij + rho n_j.m_i = g_ij - rho H_ij. QED
//
// COROLLARY. With h_ij >= |m_ij| + |r_ij| no point at |rho| <= R is singular where
//
//     g11 > R h11,     g22 > R h22,     (g11 - R h11) (g22 - R h22) > (|g12| + R h12)^2,
//
// since g - rho H is then positive definite for every unit vector n, for both sheets and between
// them. The left sides are polynomials of degrees 2, 2 and 4, with either sign of g12.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "pn/algebra/rational.hpp"
#include "pn/algebra/ternary_form.hpp"
#include "pn/minkowski/minkowski_vector.hpp"

namespace pn {

class QuadraticFamily {
 public:
  using Control = std::array<MinkowskiVector<Rational>, 6>;

  /// In the order b200, b110, b020, b101, b011, b002.
  explicit QuadraticFamily(Control control) : control_(std::move(control)) {}

  const Control& control() const { return control_; }
  /// a1, ..., a6.
  std::array<MinkowskiVector<Rational>, 6> power() const;

  /// f_u and f_v.
  std::array<MinkowskiVector<TernaryForm<Rational>>, 2> derivatives() const;

  /// The same family with u and v exchanged: its outer sheet is the inner one of this family.
  QuadraticFamily exchanged() const;

  /// The family over the four triangles between the corners and the middles of the edges; the last
  /// one is the middle triangle.
  std::array<QuadraticFamily, 4> quartered() const;

 private:
  Control control_;
};

/// A part of a family: the family over one of the triangles that the first is divided into.
struct FamilyPart {
  QuadraticFamily family;
  /// (u, v) of its corners u = 1, v = 1, w = 1 in the first triangle.
  std::array<std::array<double, 2>, 3> corners = {{{1, 0}, {0, 1}, {0, 0}}};

  std::array<FamilyPart, 4> quartered() const;
};

/// g11, g12, g22 and det g.
struct FamilyMetric {
  TernaryForm<Rational> g11, g12, g22, determinant;
};
FamilyMetric metric(const QuadraticFamily& family);

/// A parameter (u, v) of the triangle where Delta <= 0, or where Delta could not be shown to be
/// positive around it; nothing when Delta > 0 on the whole triangle, which is proved then.
std::optional<std::array<double, 2>> unreal_place(const QuadraticFamily& family);

/// The triangle divided by the sign of Delta, each part by quarterings of it.
struct RealRegion {
  std::vector<FamilyPart> real;    ///< Delta > 0 on them, which is proved
  std::vector<FamilyPart> unreal;  ///< Delta < 0 on them, which is proved
  std::vector<FamilyPart> border;  ///< the smallest parts, of which neither is
};

/// The region with an envelope, with a border of parts 2^-halvings as wide as the triangle.
RealRegion real_region(const QuadraticFamily& family, int halvings);

/// The largest R [mm] found for which the corollary proves both sheets regular at all distances
/// |rho| <= R from the centres, within 2^-20 of the largest one that it can prove on parts of the
/// triangle; zero when none is. Infinite where all second derivatives vanish.
double regular_radius(const QuadraticFamily& family);

}  // namespace pn
