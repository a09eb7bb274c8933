// SPDX-License-Identifier: LGPL-2.1-or-later
// What holds for every sheet of an envelope, as identities of rational functions.
#pragma once

#include "pn/isotropic/rational_envelope.hpp"

namespace pn::test {

/// n is a unit vector and perpendicular to the surface at this distance.
inline bool is_pn_surface(const OrientedSurface& sheet, const Rational& distance) {
  BivariateFunction length, by_u, by_v;
  for (std::size_t i = 0; i < 3; ++i) {
    const BivariateFunction x = sheet.point[i] + BivariateFunction(distance) * sheet.normal[i];
    length += sheet.normal[i] * sheet.normal[i];
    by_u += sheet.normal[i] * x.derivative(Variable::kU);
    by_v += sheet.normal[i] * x.derivative(Variable::kV);
  }
  return length == BivariateFunction(1L) && by_u.is_zero() && by_v.is_zero();
}

/// n is normal to the spheres at the points of the sheet, and the derivative spheres pass through
/// these: q - m = -f4 n and (q - m).m_x + f4 (f4)_x = 0.
inline bool is_envelope(const OrientedSurface& sheet, const SphereSurface& f) {
  std::array<BivariateFunction, 3> from_centre;
  for (std::size_t i = 0; i < 3; ++i) {
    from_centre[i] = sheet.point[i] - f[i];
    if (from_centre[i] != -(f[3] * sheet.normal[i])) return false;
  }
  for (const Variable x : {Variable::kU, Variable::kV}) {
    BivariateFunction sum = f[3] * f[3].derivative(x);
    for (std::size_t i = 0; i < 3; ++i) sum += from_centre[i] * f[i].derivative(x);
    if (!sum.is_zero()) return false;
  }
  return true;
}

}  // namespace pn::test
