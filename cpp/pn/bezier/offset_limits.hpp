// SPDX-License-Identifier: LGPL-2.1-or-later
// Offset limits: the distances at which an envelope has no singular point.
//
// THEOREM. Let f = (m, -r), f' = lambda (M, -R), n.M + R = 0 and D = |M|^2 - R^2 > 0. The section
// at distance d, x = m + rho n with rho = r + d, is singular at (t, n) exactly when
//
//     rho = 0     or     lambda D = rho (n.M' + R').
//
// Proof: n turns around the circle with n_u != 0, so rho = 0 is singular; else let b be the unit
// vector perpendicular to n and n_u, so that M = -R n + sqrt(D) b. Differentiating n.M + R = 0
// gives n_t.b = -(n.M' + R') / sqrt(D), and x_t.b = lambda sqrt(D) + rho n_t.b. QED. Over the
// circle n.M' + R' has the largest value
//
//     K = (K1 + sqrt(E)) / |M|^2,    K1 = R' |M|^2 - R (M.M'),    E = D |M x M'|^2,
//
// so for lambda > 0 no distance in (-min r, min over K > 0 of lambda D / K - r) has a singular
// point. (The focal distances are the principal radii of curvature of all offsets at once.)
//
// COROLLARY. For rho > 0 and lambda > 0 the section at d is regular exactly when the polynomials
//
//     A = lambda D |M|^2 - rho K1,        B = A^2 - rho^2 E
//
// (freed of denominators) are positive on [0, 1]: a distance is certified by Bernstein
// coefficients.
//
// Where the spine stands still, at a corner, only rho = 0 counts: the zone lies on a sphere. Where
// it turns back inside a span (lambda changes sign) no distance is claimed to be regular.
#pragma once

#include <array>
#include <optional>

#include "pn/isotropic/envelope_chain.hpp"

namespace pn {

/// Where an offset becomes singular: a point of the surface at distance zero, and the centre of
/// curvature at this signed distance on its normal. In doubles, an estimate.
struct FocalPoint {
  std::array<double, 3> base, point;  ///< [mm]
  double distance;                    ///< [mm]
};

/// Distances d [mm] strictly between these have no singular point; none when lower >= upper.
struct OffsetRange {
  double lower, upper;  ///< each may be infinite
  /// The first singular points beyond; none beyond an infinite end, and where nothing is proved.
  std::optional<FocalPoint> at_lower = {}, at_upper = {};
};

/// The certified range: it lies inside the true one. Of chains along curves of spheres by the
/// corollary, of others by the curvature of their base (curvature_limits.hpp). Its ends are within
/// a few times `tolerance` [mm] of it, except next to a cusp of the spine; the empty range where
/// nothing can be proved.
OffsetRange regular_range(const EnvelopeChain& chain, double tolerance);

/// A tolerance in proportion to the surface: 1e-9 of the largest radius or chord of a link.
double default_tolerance(const EnvelopeChain& chain);

}  // namespace pn
