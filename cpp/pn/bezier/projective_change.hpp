// SPDX-License-Identifier: LGPL-2.1-or-later
// Projective changes of parameters: the same patch over the unit square with more even weights.
//
// LEMMA. With t = tau / (tau + mu (1 - tau)), mu > 0, and s likewise with nu, a Bezier patch of
// bidegree (m, n) over [0, 1]^2 keeps its poles, and its weights w_ij are multiplied by mu^(m - i)
// nu^(n - j). Proof: t : 1 - t = tau : mu (1 - tau), so t^i (1 - t)^(m - i) is tau^i (1 - tau)^(m -
// i) times mu^(m - i) and a factor common to all i. QED (G. Farin, Curves and Surfaces for CAGD,
// 5th ed. 2002, section 13.5.)
#pragma once

#include <array>

#include "pn/isotropic/along_surface.hpp"

namespace pn {

struct ProjectiveChange {
  double mu = 1, nu = 1;

  /// Of short numbers, so that the logarithms of these weights, by Bernstein coefficients, vary as
  /// little as they can (least squares). None of the coefficients may contain zero.
  static ProjectiveChange evening(const TensorPolynomial<RealBall>& weight);

  /// (tau, sigma) of (t, s).
  std::array<double, 2> place(const std::array<double, 2>& ts) const;
  /// The sections over (tau, sigma), of this bidegree, at this precision [bits].
  SurfaceSections<RealBall> applied(SurfaceSections<RealBall> sections,
                                    const std::array<int, 2>& degree, long bits) const;
};

}  // namespace pn
