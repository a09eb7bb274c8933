// SPDX-License-Identifier: LGPL-2.1-or-later
// Moving conics by hand, for tests.
#pragma once

#include "conic_families.hpp"
#include "pn/conics/moving_conic.hpp"

namespace pn::test {

/// (xi / a)^2 + (eta / b)^2 = 1 for squared half-axes, in the coordinates (1, xi, eta).
inline Conic ellipse(const RationalPolynomial& aa, const RationalPolynomial& bb) {
  return diagonal(-(aa * bb), bb, aa);
}

/// Centre m, directions p and q.
inline MovingConic moving(const Vector3<RationalPolynomial>& m,
                          const Vector3<RationalPolynomial>& p,
                          const Vector3<RationalPolynomial>& q, const Conic& conic) {
  MovingConic result;
  for (std::size_t c = 0; c < 3; ++c) result.frame[c] = {m[c], p[c], q[c]};
  result.frame[3] = {1L, 0L, 0L};
  result.conic = conic;
  return result;
}

/// Along z from 10 i to 10 i + 10, in planes parallel to xy.
inline MovingConic upright(const Conic& conic, long i = 0) {
  return moving({0L, 0L, conic_polynomial({10 * i, 10})}, {1L, 0L, 0L}, {0L, 1L, 0L}, conic);
}

}  // namespace pn::test
