// SPDX-License-Identifier: LGPL-2.1-or-later
// Spans of a curve of spheres: a designer's curve and radius law over common parameters, over Q.
//
// Breaks of both are united exactly. On every span centre and radius have one denominator: the
// product of both, so that it stays as smooth across spans as they are; where both have the same
// weights everywhere, it is their common one.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pn/isotropic/sphere_curve.hpp"
#include "pn/shapes/curve.hpp"

namespace pn {

/// Spheres over [begin, end] of the designer's parameter, in the local parameter on [0, 1].
struct SphereSpan {
  SphereCurve spheres;
  Rational begin, end;
};

/// The spans between the breaks of the curve, of the law and `more` breaks inside the domain.
std::vector<SphereSpan> sphere_spans(const Curve& curve, const Law& law,
                                     const std::vector<Rational>& more = {});

/// Both ascending lists in one, without repetition.
std::vector<Rational> united_breaks(const std::vector<Rational>& a, const std::vector<Rational>& b);

/// Numerators and denominator at the end of `left` and the start of `right` agree exactly up to
/// the derivative of this order by the designer's parameter.
bool meets(const SphereSpan& left, const SphereSpan& right, int order);

/// The first interval of [0, 1] between roots of p, which is not zero, where p is negative; its
/// ends are rounded. Nothing when p is nowhere negative.
std::optional<std::array<double, 2>> first_negative_interval(const RationalPolynomial& p);

/// The designer's parameter at a local one.
double parameter(const SphereSpan& span, double local);

/// The centre there, as sentences for the user show it.
std::string place(const SphereSpan& span, double local);

/// "parameters a to b, near point (x, y, z)" for local parameters.
std::string interval(const SphereSpan& span, double begin, double end);

/// A number as sentences for the user show it.
std::string show(double value);

}  // namespace pn
