// SPDX-License-Identifier: LGPL-2.1-or-later
// The substitution for odd real roots, and the roots of D in the local parameter.
//
// THEOREM. A family of circles with D > 0 on [0, 1] has normals that are rational in t only if D
// has no real root of odd multiplicity. Otherwise let r1 < 0 < 1 < r2 be the adjacent ones on the
// projective line, a missing one being infinity. With
//
//     t = (r1 sigma^2 + r2 s^2) / (sigma^2 + s^2),      r1 + s^2 without r2,      r2 - s^2 without
//     r1,
//
// all degrees double and D becomes a form without odd real roots: r1 becomes a double root at s =
// 0, r2 one at sigma = 0, and any other root c the two roots s / sigma = +-sqrt((c - r1) / (r2 -
// c)), so no new roots have to be isolated. (M. Peternell, dissertation TU Wien 1997, (1.27).)
//
// The local parameter runs from 0 to 1 as t does: (s : sigma) moves on the chord between its values
// at t = 0 and t = 1. With both roots finite these are taken on the unit circle, so that the
// denominator s^2 + sigma^2 stays between 1/2 and 1; otherwise sigma = 1.
#pragma once

#include <memory>
#include <vector>

#include "pn/algebra/form.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/isotropic/sphere_curve.hpp"

namespace pn {

/// The roots of D in the local parameter: pairs of any multiplicity, real roots of multiplicity 2q.
struct DoubleRoots {
  struct Real {
    RealBall value;
    int copies;  ///< q
  };
  std::vector<ConjugatePair> pairs;
  std::vector<Real> real;
  int infinite_copies = 0;
};

/// The change to the local parameter: t itself where D has no odd real root.
class LocalParameter {
 public:
  virtual ~LocalParameter() = default;
  /// p(t), taken at this formal degree, in the local parameter.
  virtual Form<RealBall> form(const RationalPolynomial& p, int degree) const = 0;
  virtual bool is_substituted() const = 0;
  /// The local parameter of t, which lies between the adjacent odd roots; exact at 0 and 1.
  virtual RealBall local_of(const RealBall& t) const = 0;
};

struct LocalFamily {
  std::unique_ptr<const LocalParameter> parameter;
  DoubleRoots roots;
};

/// The local parameter of a family of circles, with the roots of D there. Throws Undecided when the
/// precision does not suffice.
LocalFamily local_family(const CircleFamily& circles, long precision);

}  // namespace pn
