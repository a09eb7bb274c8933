// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/seam.hpp"

#include <cmath>

namespace pn {

using Eigen::Matrix2cd;
using Eigen::Matrix2d;
using Eigen::Vector2cd;
using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d any_perpendicular(const Vector3d& axis) {
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  return axis.cross(Vector3d::Unit(smallest)).normalized();
}

Vector3d transported(const Vector3d& e, const Vector3d& from, const Vector3d& to) {
  const Vector3d moved = Eigen::Quaterniond::FromTwoVectors(from, to) * e;
  const Vector3d direction = to.normalized();
  return (moved - moved.dot(direction) * direction).normalized();
}

double angle_about(const Vector3d& axis, const Vector3d& a, const Vector3d& b) {
  return std::atan2(axis.normalized().dot(a.cross(b)), a.dot(b));
}

Vector3d axis_at(const CircleForms<double>& circles, double t) {
  return {circles.axis[0](t), circles.axis[1](t), circles.axis[2](t)};
}

Vector3d circle_normal(const CircleForms<double>& circles, double t, const Vector3d& e) {
  const Vector3d axis = axis_at(circles, t);
  const double cosine = -circles.level(t) / axis.norm();
  return cosine * axis.normalized() + std::sqrt(std::max(0.0, 1 - cosine * cosine)) * e;
}

Matrix2cd value_at(const SpinorMatrix<std::complex<double>>& a, double t) {
  Matrix2cd value;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) value(i, j) = a.entry[i][j](t);
  }
  return value;
}

namespace {

/// A spinor a with a* a = 1 whose unit vector is `normal`.
Vector2cd spinor_of(const Vector3d& normal) {
  const std::complex<double> planar(normal.x(), normal.y());
  if (normal.z() >= 0) {
    const double a0 = std::sqrt((1 + normal.z()) / 2);
    return {a0, planar / (2 * a0)};
  }
  const double a1 = std::sqrt((1 - normal.z()) / 2);
  return {std::conj(planar) / (2 * a1), a1};
}

/// The real direction of a vector that is a real one times a phase.
Vector2d without_phase(const Vector2cd& u) {
  const std::complex<double> larger = std::norm(u(0)) >= std::norm(u(1)) ? u(0) : u(1);
  return (u * (std::conj(larger) / std::abs(larger))).real();
}

}  // namespace

Vector2d parameter_of(const Matrix2cd& a, const Vector3d& normal) {
  const Vector2d u = without_phase(a.inverse() * spinor_of(normal));
  return u / (a * u).norm();
}

Matrix2d even_factor(const Matrix2cd& a, const Vector3d& normal) {
  const Matrix2d g = (a.adjoint() * a).real();
  const Vector2d first = parameter_of(a, normal);
  const Vector2d conormal = g * first;
  const Vector2d second = Vector2d(-conormal.y(), conormal.x()) / std::sqrt(g.determinant());
  Matrix2d factor;
  factor << first, second;
  return factor;
}

Matrix2d continued(const Matrix2d& previous, const Matrix2d& factor) {
  return (previous.inverse() * factor).trace() >= 0 ? factor : Matrix2d(-factor);
}

double twist_energy(const CircleForms<double>& circles,
                    const SpinorMatrix<std::complex<double>>& spinor) {
  constexpr int kSteps = 8;  // enough to rank root choices, whose energies differ by factors
  Vector3d axis = axis_at(circles, 0), e = any_perpendicular(axis);
  Matrix2d factor = even_factor(value_at(spinor, 0), circle_normal(circles, 0, e));
  double energy = 0;
  for (int i = 1; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    const Vector3d next_axis = axis_at(circles, t);
    e = transported(e, axis, next_axis);
    axis = next_axis;
    const Matrix2d next =
        continued(factor, even_factor(value_at(spinor, t), circle_normal(circles, t, e)));
    energy += (factor.inverse() * next - Matrix2d::Identity()).squaredNorm();
    factor = next;
  }
  return energy;
}

}  // namespace pn
