// SPDX-License-Identifier: LGPL-2.1-or-later
// Blossoming over Q: the polynomials of a B-spline on its spans, without any knot insertion in
// floating point. (L. Ramshaw, Blossoms are polar forms, CAGD 6, 1989.)
#pragma once

#include <cstddef>
#include <vector>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

/// Throws GeometryError (kBadKnots) where these are not the strictly increasing knots of a clamped
/// B-spline with so many poles.
void require_clamped(int degree, const std::vector<double>& knots,
                     const std::vector<int>& multiplicities, std::size_t poles);

/// For each span the index of the last of the knots at its start, counted with multiplicity.
std::vector<std::size_t> span_places(const std::vector<int>& multiplicities);

/// The rational numbers that finite doubles are.
std::vector<Rational> exactly(const std::vector<double>& values);

/// Weights up to a common power of two, the largest between 1 and 2: only their ratios matter. All
/// of them 1 when there are none.
std::vector<Rational> scaled_weights(const std::vector<double>& weights, std::size_t count);

/// Every knot as often as its multiplicity says.
std::vector<Rational> flat_knots(const std::vector<Rational>& knots,
                                 const std::vector<int>& multiplicities);

/// The polynomial of one scalar B-spline on the span that ends the run of knots at `last`, in the
/// local parameter on [0, 1].
RationalPolynomial span_polynomial(const std::vector<Rational>& flat, std::size_t last,
                                   std::size_t degree, const std::vector<Rational>& coefficients);

}  // namespace pn
