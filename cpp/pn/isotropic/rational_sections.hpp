// SPDX-License-Identifier: LGPL-2.1-or-later
// Rational sections: PN surfaces over Q up to the length of their normals.
//
// Where an optical path or a direction brings in a square root, it is often one number only: the
// surface at distance zero is over Q, and so is a normal field V whose length L is constant with
// L^2 in Q. Then
//
//     x_d = (X + (d / L) V) / W,
//
// and all decisions are made over Q with d / L in place of d.
#pragma once

#include <array>
#include <optional>

#include "pn/algebra/multivariate_polynomial.hpp"
#include "pn/isotropic/along_surface.hpp"

namespace pn {

/// A part of a surface over [0, 1]^2.
struct RationalSections {
  /// X, V, W: W is positive at the middle of the square.
  SurfaceSections<Rational> sections;
  /// L^2; none where the length of V / W is not constant. Then only the section at distance zero is
  /// rational, and V / W is normal to it.
  std::optional<Rational> squared_length;
};

/// Without the common factor of all polynomials, and with W > 0 at the middle of the square. Throws
/// std::domain_error when the weight is zero.
RationalSections rational_sections(std::array<BivariatePolynomial, 3> point,
                                   std::array<BivariatePolynomial, 3> direction,
                                   BivariatePolynomial weight,
                                   std::optional<Rational> squared_length);

/// The part over a rectangle of [0, 1]^2, again over the unit square.
RationalSections part_of(const RationalSections& sections, const std::array<Rational, 2>& low,
                         const std::array<Rational, 2>& high);

/// The sections with unit normals V / (L W), enclosed at this precision [bits]; V as it is where L
/// is not constant.
SurfaceSections<RealBall> enclosed(const RationalSections& sections, long bits);

}  // namespace pn
