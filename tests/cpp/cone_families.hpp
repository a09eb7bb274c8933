// SPDX-License-Identifier: LGPL-2.1-or-later
// Families of quadratic cones by hand and at random: C = a K a^T for planes a of given degrees.
#pragma once

#include <vector>

#include "conic_families.hpp"
#include "pn/conics/quadratic_cones.hpp"

namespace pn::test {

/// a K a^T
inline Matrix4OfPolynomials cone_matrix(const std::array<Vector3<RationalPolynomial>, 4>& a,
                                        const Conic& conic) {
  Matrix4OfPolynomials result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t p = 0; p < 3; ++p) {
        for (std::size_t q = 0; q < 3; ++q) result[i][j] += a[i][p] * conic[p][q] * a[j][q];
      }
    }
  }
  return result;
}

/// Planes of the degrees f, and K_ij of degree k - f_i - f_j: of degree k, with a vertex of degree
/// f_1 + f_2 + f_3 as a rule. Of signature (2, 1) for real t.
inline Matrix4OfPolynomials random_cone_matrix(RandomConics& random, const Vector3<int>& f, int k) {
  std::array<Vector3<RationalPolynomial>, 4> a;
  for (auto& row : a) {
    for (std::size_t j = 0; j < 3; ++j) row[j] = random.any(f[j]);
  }
  const auto half = [&](std::size_t i) { return std::max((k - 2 * f[i]) / 2, 0); };
  const Conic d =
      diagonal(random.positive(half(0)), random.positive(half(1)), -random.positive(half(2)));
  return cone_matrix(a, d);
}

/// The example of M. Peternell, dissertation TU Wien 1997, 1.5, as printed but for two misprints:
/// planes in the order (e0, e1, e2, e3) of e0 + e1 x + e2 y + e3 z = 0.
inline Matrix4OfPolynomials conics_of_the_dissertation() {
  const RationalPolynomial zero, p = conic_polynomial({1, 0, 1}),
                                 q = conic_polynomial({1, 0, -2, 0, 1});
  const Matrix4OfPolynomials base = {
      {{1L, 0L, 2L, 0L}, {0L, -conic_polynomial({1}), 0L, 0L}, {2L, 0L, 3L, 0L}, {}}};
  const Matrix4OfPolynomials m = {{{p, p, zero, conic_polynomial({0, 1}) * p},
                                   {zero, p, zero, zero},
                                   {zero, zero, q, conic_polynomial({0, -2})},
                                   {zero, zero, conic_polynomial({0, 2}), q}}};
  return congruent(base, m);
}

}  // namespace pn::test
