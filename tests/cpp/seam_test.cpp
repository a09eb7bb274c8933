// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/seam.hpp"

#include <catch2/catch.hpp>

#include "circle_families.hpp"
#include "pn/isotropic/along_curve.hpp"

using Eigen::Matrix2cd;
using Eigen::Matrix2d;
using Eigen::Vector2cd;
using Eigen::Vector3d;
using namespace pn;
using namespace pn::test;

namespace {

constexpr double kRounding = 1e-12;

Vector3d normal_of(const Vector2cd& a) {
  const auto mixed = std::conj(a(0)) * a(1);
  return Vector3d(2 * mixed.real(), 2 * mixed.imag(), std::norm(a(0)) - std::norm(a(1))) /
         a.squaredNorm();
}

IsotropicHypersurface<double> gamma_of(const SphereCurve& curve) {
  return midpoint(along_curve(curve, tangent_direction(curve).circles).enclosure(128));
}

double twist_of(const SphereCurve& curve) {
  const auto gamma = gamma_of(curve);
  return twist_energy(gamma.circles, gamma.spinor);
}

const SphereCurve kHelical{
    {polynomial({0, 5, 1}), polynomial({1, 0, 3, 1}), polynomial({2, -1, 0, 4})},
    polynomial({1, 1, -1}),
    1L};

}  // namespace

TEST_CASE("Some unit vector perpendicular to the axis", "[seam]") {
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(-3, 2, 1e-9), Vector3d(1e6, 1e6, 1e6)}) {
    const Vector3d e = any_perpendicular(axis);
    CHECK(e.norm() == Approx(1));
    CHECK(std::abs(e.dot(axis.normalized())) < kRounding);
  }
}

TEST_CASE("The least rotation keeps the frame and does not spin", "[seam]") {
  const Vector3d from(1, 2, -1), to(0, 3, 2), e = any_perpendicular(from);
  const Vector3d moved = transported(e, from, to);
  CHECK(moved.norm() == Approx(1));
  CHECK(std::abs(moved.dot(to.normalized())) < kRounding);
  // It turns about from x to: that vector stays, and the angle to it too.
  const Vector3d fixed = from.cross(to).normalized();
  CHECK((transported(fixed, from, to) - fixed).norm() < kRounding);
  CHECK(moved.dot(fixed) == Approx(e.dot(fixed)));
  CHECK((transported(moved, to, from) - e).norm() < kRounding);
}

TEST_CASE("Angles about an axis are signed", "[seam]") {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  CHECK(angle_about(2 * z, x, y) == Approx(M_PI / 2));
  CHECK(angle_about(-z, x, y) == Approx(-M_PI / 2));
  CHECK(angle_about(z, x, -x) == Approx(M_PI));
  CHECK(angle_about(z, x, x) == Approx(0));
}

TEST_CASE("The normal of a circle on a given side", "[seam]") {
  const auto gamma = gamma_of(kHelical);
  for (const double t : {0.0, 0.3, 1.0}) {
    const Vector3d axis = axis_at(gamma.circles, t), e = any_perpendicular(axis);
    const Vector3d n = circle_normal(gamma.circles, t, e);
    CHECK(n.norm() == Approx(1));
    CHECK(std::abs(n.dot(axis) + gamma.circles.level(t)) < kRounding * axis.norm());
    CHECK(n.dot(e) > 0);
    CHECK(std::abs(n.dot(axis.cross(e))) < kRounding * axis.norm());
  }
}

TEST_CASE("The even factor makes the weight constant and puts the seam on its normal", "[seam]") {
  const auto gamma = gamma_of(kHelical);
  for (const double t : {0.0, 0.4, 1.0}) {
    const Matrix2cd a = value_at(gamma.spinor, t);
    for (int turn = 0; turn < 8; ++turn) {
      const Vector3d axis = axis_at(gamma.circles, t);
      const Vector3d e =
          Eigen::AngleAxisd(turn * M_PI / 4, axis.normalized()) * any_perpendicular(axis);
      const Vector3d n = circle_normal(gamma.circles, t, e);
      const Matrix2d f = even_factor(a, n);
      const Matrix2cd lined = a * f;
      CHECK(((lined.adjoint() * lined).real() - Matrix2d::Identity()).norm() < 1e-9);
      CHECK((normal_of(lined.col(0)) - n).norm() < 1e-9);
      CHECK(f.determinant() > 0);
    }
  }
}

TEST_CASE("The sign of a factor follows the one before", "[seam]") {
  Matrix2d f;
  f << 2, 1, 0.5, 3;
  const Matrix2d near = f * Eigen::Rotation2Dd(0.3).toRotationMatrix();
  CHECK((continued(f, near) - near).norm() == 0);
  CHECK((continued(f, -near) - near).norm() == 0);
}

TEST_CASE("Lines of a cylinder do not twist, and twist has no units", "[seam]") {
  const SphereCurve cylinder{{polynomial({0, 2}), polynomial({0, 1}), polynomial({0, 2})}, 3L, 1L};
  CHECK(twist_of(cylinder) < kRounding);
  const double energy = twist_of(kHelical);
  CHECK(energy > 1e-3);
  SphereCurve larger = kHelical;
  for (auto& p : larger.centre) p *= RationalPolynomial(1000L);
  larger.radius *= RationalPolynomial(1000L);
  CHECK(twist_of(larger) == Approx(energy).epsilon(1e-3));
}

TEST_CASE("The parameter of a normal gives it back", "[seam]") {
  const auto gamma = gamma_of(kHelical);
  for (const double t : {0.0, 0.4, 1.0}) {
    const Matrix2cd a = value_at(gamma.spinor, t);
    for (int turn = 0; turn < 8; ++turn) {
      const Eigen::Vector2d u(std::cos(0.3 + turn * M_PI / 8), std::sin(0.3 + turn * M_PI / 8));
      const Eigen::Vector2d found = parameter_of(a, normal_of(a * u));
      CHECK(std::abs(found.normalized().dot(u)) == Approx(1).epsilon(1e-9));
      CHECK((a * found).norm() == Approx(1));
    }
  }
}
