// SPDX-License-Identifier: LGPL-2.1-or-later
// Translational families: a curve of spheres that is translated along another one.
//
// f(u, v) = c(u) + d(v) in R^{3,1}, a sphere with centre m and radius r being the point (m, -r),
// with parabolas or lines c and d: a quadratic family without the term u v, over a rectangle. (M.
// Peternell, B. Odehnal, M. L. Sampoli, On quadratic two-parameter families of spheres and their
// envelopes, CAGD 25, 2008; M. Peternell, Rational two-parameter families of spheres and rational
// offset surfaces, section 6.6, type 1.) Where the envelope is real and regular is the matter of
// quadratic_family.hpp, on both triangles of the rectangle.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "pn/isotropic/quadratic_family.hpp"

namespace pn {

/// A curve of spheres second t^2/2 + first t + start in R^{3,1} over [0, 1]: a parabola, or a line.
struct SphereParabola {
  MinkowskiVector<Rational> second, first, start;

  /// The derivative at t.
  MinkowskiVector<Rational> slope(const Rational& t) const;
  /// The same curve over [origin, origin + length].
  SphereParabola part(const Rational& origin, const Rational& length) const;
};

/// c(u) + d(v) over the unit square.
struct TranslationalFamily {
  SphereParabola c, d;

  /// The family of d(v) + c(u): its outer sheet is the inner one of this family.
  TranslationalFamily exchanged() const { return {d, c}; }
};

/// f over the triangle u + v <= 1; its polynomials hold for the whole square.
QuadraticFamily quadratic_family(const TranslationalFamily& family);

/// f over both triangles of the square: in (u, v), and in (1 - u, 1 - v).
std::array<QuadraticFamily, 2> triangles(const TranslationalFamily& family);

/// A parameter (u, v) of the square where Delta <= 0, or where Delta could not be shown to be
/// positive around it; nothing when Delta > 0 on the whole square, which is proved then.
std::optional<std::array<double, 2>> unreal_place(const TranslationalFamily& family);

/// A curve of spheres span by span; span i lies over [breaks[i], breaks[i + 1]].
struct SphereParabolas {
  std::vector<Rational> breaks;  ///< strictly increasing
  std::vector<SphereParabola> spans;

  /// With span i halved.
  SphereParabolas halved(std::size_t i) const;
};

/// c(u) + d(v) over a rectangle: a family for every pair of spans.
struct TranslationalSpline {
  SphereParabolas c, d;

  TranslationalFamily family(std::size_t i, std::size_t j) const {
    return {c.spans[i], d.spans[j]};
  }
};

}  // namespace pn
