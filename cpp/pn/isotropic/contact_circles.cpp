// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/contact_circles.hpp"

#include "pn/algebra/precision.hpp"
#include "pn/isotropic/odd_root_substitution.hpp"

namespace pn {

ContactCircles::ContactCircles(const SphereCurve& curve)
    : ContactCircles(curve, tangent_direction(curve).circles) {}

ContactCircles::ContactCircles(const SphereCurve& curve, const CircleFamily& circles)
    : envelope_(along_curve(curve, circles)),
      spinor_(envelope_.enclosure(kLeastPrecision).spinor),
      parameter_(at_sufficient_precision([&](long bits) {
        return std::shared_ptr<const LocalParameter>(local_family(circles, bits).parameter);
      })) {}

double ContactCircles::parameter(double t) const {
  return parameter_->local_of(RealBall(t)).midpoint();
}

}  // namespace pn
