// SPDX-License-Identifier: LGPL-2.1-or-later
// The isotropic hypersurface along a curve of spheres: the envelope of a one-parameter family.
//
// THEOREM. Let f be a rational curve of spheres of degree k with circle family (M, R) of degree h
// and D = |M|^2 - R^2 > 0 on [0, 1]. If D has no real root of odd multiplicity, the spinor
// factorization of (M, R) gives all offsets of the envelope in bidegree (k + 2 d, 2) with d =
// ceil(h/2) when D has no real root at all: for polynomial f, h = k - 1, the degrees in t are 4, 5,
// 8, 9, 12, 13 for k = 2..7, and no parametrization that is quadratic in u has less.
//
// If D has real roots of odd multiplicity (outside [0, 1]), none is rational in t; the substitution
// of odd_root_substitution.hpp doubles all degrees. Of each pair of roots of D one is free to
// choose (root_choice.hpp). (M. Peternell, dissertation TU Wien 1997, section 2.5 and
// Proposition 4.1.)
#pragma once

#include "pn/isotropic/envelope.hpp"
#include "pn/isotropic/sphere_curve.hpp"

namespace pn {

/// Curve and circles in the local parameter, with the roots of D there.
LocalForms local_forms(const SphereCurve& curve, const CircleFamily& circles, long precision);

/// `circles` is the coprime circle family along `curve`, with D > 0 on [0, 1]. It need not stem
/// from f' (where f stands still, as at a corner of a spine, any family through the joints will
/// do). Throws GeometryError when every section exceeds the largest degree.
Envelope along_curve(const SphereCurve& curve, const CircleFamily& circles);

}  // namespace pn
