// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/isotropic_hypersurface.hpp"

namespace pn {

SphereCurveForms<double> midpoint(const SphereCurveForms<RealBall>& curve) {
  SphereCurveForms<double> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.centre[i] = midpoint(curve.centre[i]);
    result.axis[i] = midpoint(curve.axis[i]);
  }
  result.radius = midpoint(curve.radius);
  result.denominator = midpoint(curve.denominator);
  result.level = midpoint(curve.level);
  return result;
}

IsotropicHypersurface<double> midpoint(const IsotropicHypersurface<RealBall>& gamma) {
  IsotropicHypersurface<double> result{midpoint(gamma.curve), {}};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) result.spinor.entry[i][j] = midpoint(gamma.spinor.entry[i][j]);
  }
  result.spinor.degree = gamma.spinor.degree;
  return result;
}

}  // namespace pn
