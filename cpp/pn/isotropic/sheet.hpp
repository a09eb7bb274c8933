// SPDX-License-Identifier: LGPL-2.1-or-later
// Sheets: the two normals that a family of spheres has at every parameter.
//
// With E, F, G the products of the derivatives of the centre m, N = m_u x m_v and p = -r, the unit
// vectors n with n.m_u = p_u and n.m_v = p_v are
//
//     n = ((G p_u - F p_v) m_u + (E p_v - F p_u) m_v +- sqrt(Delta) N) / |N|^2,
//     Delta = |N|^2 - (G p_u^2 - 2 F p_u p_v + E p_v^2).
//
// The sign is that of n.N. In doubles: for choices, paths and estimates.
#pragma once

#include <Eigen/Dense>

#include "pn/isotropic/quadratic_family.hpp"

namespace pn {

enum class Sheet {
  kOuter,  ///< n.(m_u x m_v) > 0
  kInner,  ///< n.(m_u x m_v) < 0
};

/// The other sheet; the same one with u and v exchanged.
inline Sheet opposite(Sheet sheet) {
  return sheet == Sheet::kOuter ? Sheet::kInner : Sheet::kOuter;
}

/// A family in doubles.
class FamilyInDoubles {
 public:
  explicit FamilyInDoubles(const QuadraticFamily& family);

  /// (m, -r) and its derivatives.
  Eigen::Vector4d at(double u, double v) const;
  Eigen::Vector4d by_u(double u, double v) const;
  Eigen::Vector4d by_v(double u, double v) const;

  /// The unit normal of a sheet; not finite where Delta < 0.
  Eigen::Vector3d normal(Sheet sheet, double u, double v) const;

 private:
  Eigen::Matrix<double, 4, 6> power_;  ///< a1, ..., a6
};

}  // namespace pn
