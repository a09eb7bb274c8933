// SPDX-License-Identifier: LGPL-2.1-or-later
// Line congruences of order one: through a general point x of space goes exactly one line.
//
// The lines at infinity of the normal planes of a family of spheres that has rational envelopes
// form such a fibration, and the line through the isotropic direction w is that of the sphere which
// has the normal w. (D. Gruber, Diplomarbeit, TU Wien 2008, 1.1.4-1.1.8.) The congruences of order
// one are:
//
//   - the star of the lines through a vertex;
//   - the chords of a twisted cubic;
//   - nets, the lines of two linear complexes a and b. The line through x is the meet of the null
//     planes of x in a and b, for hyperbolic, elliptic and parabolic nets alike. Their axes are the
//     special complexes of the pencil a + k b, which are real, conjugate complex or one;
//   - the lines that meet an axis and a curve of degree n which meets the axis n - 1 times.
//
// (E. Kummer, 1866; R. Sturm, Liniengeometrie II, 1893.)
//
// CHORDS. In coordinates y with the cubic (1, t, t^2, t^3) the plane k meets it where k0 + k1 t +
// k2 t^2 + k3 t^3 = 0. The chord between the roots of q(t) = q0 + q1 t + q2 t^2 is the meet of the
// planes (q0, q1, q2, 0) and (0, q0, q1, q2), since both polynomials contain q. So it goes through
// y when q is orthogonal to (y0, y1, y2) and (y1, y2, y3), that is, q is their cross product. The
// ends may be complex or coincide.
//
// AXIS AND CURVE. Let e1, e2 be planes through the axis. The forms ei.c(t) have a common factor
// of degree n - 1, the meets, and linear cofactors gi. The plane (e2.x) e1 - (e1.x) e2 through x
// meets the curve also where (e2.x) g1(t) - (e1.x) g2(t) = 0, which is linear.
//
// `line_through` is zero at the points that lie on more than one line. X is any commutative ring:
// points with rational coordinates, or polynomial w(s, t).
#pragma once

#include <array>
#include <vector>

#include "pn/algebra/rational_polynomial.hpp"
#include "pn/minkowski/line_coordinates.hpp"

namespace pn {

struct LineStar {
  MinkowskiVector<Rational> vertex;

  template <class X>
  LineCoordinates<X> line_through(const MinkowskiVector<X>& x) const {
    return join(x, vertex);
  }
};

/// a and b are independent.
struct LineNet {
  LineCoordinates<Rational> a, b;

  template <class X>
  LineCoordinates<X> line_through(const MinkowskiVector<X>& x) const {
    return meet(null_plane(a, x), null_plane(b, x));
  }
};

class CubicChords {
 public:
  /// The chords of c0 + c1 t + c2 t^2 + c3 t^3. Throws std::domain_error when the coefficients are
  /// dependent: the curve is plane.
  explicit CubicChords(const std::array<MinkowskiVector<Rational>, 4>& coefficients);

  template <class X>
  LineCoordinates<X> line_through(const MinkowskiVector<X>& x) const {
    const std::array<X, 4> y = {incidence(coordinates_[0], x), incidence(coordinates_[1], x),
                                incidence(coordinates_[2], x), incidence(coordinates_[3], x)};
    const std::array<X, 3> q = {y[1] * y[3] - y[2] * y[2], y[1] * y[2] - y[0] * y[3],
                                y[0] * y[2] - y[1] * y[1]};
    const auto plane = [&](std::size_t first) {
      PlaneAtInfinity<X> e;
      for (std::size_t i = 0; i < 4; ++i) {
        e[i] = q[0] * coordinates_[first][i] + q[1] * coordinates_[first + 1][i] +
               q[2] * coordinates_[first + 2][i];
      }
      return e;
    };
    return meet(plane(0), plane(1));
  }

 private:
  std::array<PlaneAtInfinity<Rational>, 4> coordinates_;  ///< yi as a plane
};

class AxisCurveCongruence {
 public:
  using Curve = std::array<RationalPolynomial, 4>;

  /// The axis is the meet of the planes. Throws std::domain_error when the curve, of degree n, does
  /// not meet it in n - 1 points, counted with multiplicity and complex ones and infinite
  /// parameters included.
  AxisCurveCongruence(const std::array<PlaneAtInfinity<Rational>, 2>& axis, Curve curve);

  template <class X>
  LineCoordinates<X> line_through(const MinkowskiVector<X>& x) const {
    const X e1 = incidence(axis_[0], x), e2 = incidence(axis_[1], x);
    // The linear equation at + bt * t = 0, and c(-at / bt) times bt^n.
    const X at = e2 * cofactors_[0][0] - e1 * cofactors_[1][0];
    const X bt = e2 * cofactors_[0][1] - e1 * cofactors_[1][1];
    return join(x, curve_point(-at, bt));
  }

 private:
  /// c(numerator / denominator) denominator^n
  template <class X>
  MinkowskiVector<X> curve_point(const X& numerator, const X& denominator) const {
    MinkowskiVector<X> point;
    for (std::size_t i = 0; i < 4; ++i) {
      X sum = numerator * curve_[i].coefficient(degree_);
      X power = denominator;
      for (int k = degree_ - 1; k > 0; --k) {
        sum = (sum + power * curve_[i].coefficient(k)) * numerator;
        power = power * denominator;
      }
      point[i] = sum + power * curve_[i].coefficient(0);
    }
    return point;
  }

  std::array<PlaneAtInfinity<Rational>, 2> axis_;
  Curve curve_;
  int degree_;
  std::array<std::array<Rational, 2>, 2> cofactors_;  ///< gi = gi[0] + gi[1] t
};

}  // namespace pn
