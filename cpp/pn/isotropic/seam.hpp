// SPDX-License-Identifier: LGPL-2.1-or-later
// The seam and its lines: how the circle parameter u is carried along the spine.
//
// A real factor F(t) in GL2(R) of the spinor matrix moves the lines u = const over the surface and
// changes nothing else. With G = Re(A* A), the factor F = G^{-1/2} Rot(theta) makes the weight of A
// F constant on the circle at t, that is, u even in angle; theta puts the line u = (1 : 0) on a
// given normal. The seam follows the rotation-minimizing frame of the axis (R. L. Bishop, There is
// more than one way to frame a curve, Amer. Math. Monthly 82, 1975): the least possible twist.
//
// All of this is a free choice, made in doubles. It decides how even the lines are, never where the
// surface is.
#pragma once

#include <Eigen/Dense>

#include "pn/isotropic/isotropic_hypersurface.hpp"

namespace pn {

/// Some unit vector perpendicular to the axis.
Eigen::Vector3d any_perpendicular(const Eigen::Vector3d& axis);

/// The unit vector `e`, perpendicular to `from`, carried by the least rotation that turns the
/// direction of `from` into that of `to`.
Eigen::Vector3d transported(const Eigen::Vector3d& e, const Eigen::Vector3d& from,
                            const Eigen::Vector3d& to);

/// The angle about `axis` from unit vector `a` to unit vector `b`, both perpendicular to it, in
/// (-pi, pi].
double angle_about(const Eigen::Vector3d& axis, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

Eigen::Vector3d axis_at(const CircleForms<double>& circles, double t);

/// The normal of the circle n.axis + level = 0 on the side of `e`, a unit vector perpendicular to
/// axis.
Eigen::Vector3d circle_normal(const CircleForms<double>& circles, double t,
                              const Eigen::Vector3d& e);

Eigen::Matrix2cd value_at(const SpinorMatrix<std::complex<double>>& a, double t);

/// The real u with n(A u) = normal and |A u| = 1, up to its sign; the normal lies on the circle of
/// A.
Eigen::Vector2d parameter_of(const Eigen::Matrix2cd& a, const Eigen::Vector3d& normal);

/// F with Re((A F)* (A F)) = 1 whose first column is the spinor of `normal`; det F > 0. The sign of
/// F is free and chosen arbitrarily.
Eigen::Matrix2d even_factor(const Eigen::Matrix2cd& a, const Eigen::Vector3d& normal);

/// +F or -F, whichever is nearer to `previous` as a step previous^{-1} F of the lines.
Eigen::Matrix2d continued(const Eigen::Matrix2d& previous, const Eigen::Matrix2d& factor);

/// How far the lines of A move against the rotation-minimizing frame over [0, 1]: the sum of
/// |F_i^{-1} F_{i+1} - 1|^2 over equal steps. Zero when the lines are even and do not twist.
double twist_energy(const CircleForms<double>& circles,
                    const SpinorMatrix<std::complex<double>>& spinor);

}  // namespace pn
