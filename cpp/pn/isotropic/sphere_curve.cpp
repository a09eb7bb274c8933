// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/sphere_curve.hpp"

#include <algorithm>

namespace pn {
namespace {

/// The numerator of (p / q)'.
RationalPolynomial derivative_numerator(const RationalPolynomial& p, const RationalPolynomial& q) {
  if (q.degree() == 0) return p.derivative() * q;
  return q * p.derivative() - q.derivative() * p;
}

}  // namespace

int SphereCurve::degree() const {
  return std::max({centre[0].degree(), centre[1].degree(), centre[2].degree(), radius.degree(),
                   denominator.degree()});
}

int CircleFamily::degree() const {
  return std::max({axis[0].degree(), axis[1].degree(), axis[2].degree(), level.degree()});
}

RationalPolynomial CircleFamily::discriminant() const {
  return axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2] - level * level;
}

TangentDirection tangent_direction(const SphereCurve& curve) {
  TangentDirection direction;
  CircleFamily& circles = direction.circles;
  for (std::size_t i = 0; i < 3; ++i) {
    circles.axis[i] = derivative_numerator(curve.centre[i], curve.denominator);
  }
  circles.level = derivative_numerator(curve.radius, curve.denominator);
  direction.content = circles.level;
  for (const RationalPolynomial& component : circles.axis) {
    if (direction.content.degree() == 0) break;
    direction.content = gcd(direction.content, component);
  }
  if (direction.content.degree() > 0) {
    for (RationalPolynomial& component : circles.axis) {
      component = exact_quotient(component, direction.content);
    }
    circles.level = exact_quotient(circles.level, direction.content);
  } else if (!direction.content.is_zero()) {
    direction.content = RationalPolynomial(1L);
  }
  return direction;
}

}  // namespace pn
