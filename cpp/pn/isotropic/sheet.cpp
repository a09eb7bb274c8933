// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/sheet.hpp"

#include <cmath>

namespace pn {

using Eigen::Vector3d;
using Eigen::Vector4d;

FamilyInDoubles::FamilyInDoubles(const QuadraticFamily& family) {
  const auto power = family.power();
  for (std::size_t i = 0; i < power.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) {
      power_(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(i)) = power[i][c].to_double();
    }
  }
}

Vector4d FamilyInDoubles::at(double u, double v) const {
  Eigen::Matrix<double, 6, 1> factors;
  factors << u * u / 2, u * v, v * v / 2, u, v, 1;
  return power_ * factors;
}

Vector4d FamilyInDoubles::by_u(double u, double v) const {
  return u * power_.col(0) + v * power_.col(1) + power_.col(3);
}

Vector4d FamilyInDoubles::by_v(double u, double v) const {
  return u * power_.col(1) + v * power_.col(2) + power_.col(4);
}

Vector3d FamilyInDoubles::normal(Sheet sheet, double u, double v) const {
  const Vector4d fu = by_u(u, v), fv = by_v(u, v);
  const Vector3d mu = fu.head<3>(), mv = fv.head<3>(), across = mu.cross(mv);
  const double e = mu.dot(mu), f = mu.dot(mv), g = mv.dot(mv), pu = fu(3), pv = fv(3);
  const double square = across.squaredNorm();
  const double root = std::sqrt(square - (g * pu * pu - 2 * f * pu * pv + e * pv * pv));
  const double sign = sheet == Sheet::kOuter ? 1 : -1;
  const Vector3d n =
      ((g * pu - f * pv) * mu + (e * pv - f * pu) * mv + sign * root * across) / square;
  return n.normalized();
}

}  // namespace pn
