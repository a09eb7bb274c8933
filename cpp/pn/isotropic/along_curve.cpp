// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/along_curve.hpp"

namespace pn {

LocalForms local_forms(const SphereCurve& curve, const CircleFamily& circles, long precision) {
  LocalFamily family = local_family(circles, precision);
  const LocalParameter& t = *family.parameter;
  const int k = curve.degree();
  SphereCurveForms<RealBall> carrier;
  for (std::size_t i = 0; i < 3; ++i) carrier.centre[i] = t.form(curve.centre[i], k);
  carrier.radius = t.form(curve.radius, k);
  carrier.denominator = t.form(curve.denominator, k);
  return {std::move(carrier), circle_forms(circles, t), std::move(family.roots),
          t.is_substituted()};
}

Envelope along_curve(const SphereCurve& curve, const CircleFamily& circles) {
  return Envelope([=](long precision) { return local_forms(curve, circles, precision); },
                  "the degree of spine and radius (now " + std::to_string(curve.degree()) +
                      "), for instance by a cubic B-spline");
}

}  // namespace pn
