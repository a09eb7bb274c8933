// SPDX-License-Identifier: LGPL-2.1-or-later
// Laguerre transformations: the maps of oriented spheres and oriented planes that keep contact.
//
// THEOREM. They are the similarities of R^{3,1},
//
//     x -> L x + t,     <L x, L y> = k <x, y>,     k > 0,
//
// and the plane <w, x> = c becomes <L w, x> = k c + <L w, t>. (W. Blaschke, Vorlesungen ueber
// Differentialgeometrie III, 1929; M. Peternell, dissertation, TU Wien 1997, section 3.2.) L maps
// isotropic directions to isotropic ones and f_u, f_v to the derivatives of the image, so
// <w, f_u> = <w, f_v> = 0 stays true: the image of the envelope is the envelope of the images, with
// the same parameters. Offsets are translations by (0, 0, 0, -d), and every map without dilation
// and translation is a product of reflections (E. Cartan, J. Dieudonne).
#pragma once

#include "pn/minkowski/sphere.hpp"

namespace pn {

class LaguerreMap {
 public:
  using Vector = MinkowskiVector<Rational>;
  /// By rows.
  using Matrix = std::array<Vector, 4>;

  /// Throws std::domain_error when L is no similarity.
  LaguerreMap(const Matrix& linear, const Vector& translation);

  static LaguerreMap identity();
  static LaguerreMap translation(const Vector& t);
  /// All signed radii grow by d.
  static LaguerreMap offset(const Rational& d) { return translation({0L, 0L, 0L, -d}); }
  /// Throws std::domain_error when the factor is zero.
  static LaguerreMap dilation(const Rational& factor);
  /// x -> x - 2 <a, x> / <a, a> a. Throws std::domain_error when a is isotropic.
  static LaguerreMap reflection(const Vector& a);

  const Matrix& linear() const { return linear_; }
  const Vector& translation() const { return translation_; }
  /// k
  const Rational& square_factor() const { return square_factor_; }

  /// L w
  Vector direction(const Vector& w) const;
  /// L x + t
  Vector operator()(const Vector& x) const;
  Sphere operator()(const Sphere& sphere) const { return sphere_of((*this)(point_of(sphere))); }
  OrientedPlane<Rational> operator()(const OrientedPlane<Rational>& plane) const;
  /// Of all control points, which is that of the family.
  template <std::size_t N>
  std::array<Vector, N> operator()(std::array<Vector, N> points) const {
    for (Vector& x : points) x = (*this)(x);
    return points;
  }

  LaguerreMap inverse() const;
  /// First b, then a.
  friend LaguerreMap operator*(const LaguerreMap& a, const LaguerreMap& b);

 private:
  Matrix linear_;
  Vector translation_;
  Rational square_factor_;
};

}  // namespace pn
