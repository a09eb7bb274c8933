// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_parameter.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pn;

namespace {

/// c, Re p, Im p and a matrix Z, as constant forms.
ConicForms<double> ellipse_of(const Eigen::Vector3d& c, const Eigen::Vector3d& re,
                              const Eigen::Vector3d& im, const Eigen::Matrix2d& z) {
  const auto form = [&](double constant, double real, double imaginary) {
    Eigen::Matrix2d in_z;
    in_z << constant + real, -imaginary, -imaginary, constant - real;
    const Eigen::Matrix2d in_u = z.transpose() * in_z * z;
    return FormInU<double>{{Form<double>::constant(in_u(0, 0)), Form<double>::constant(in_u(0, 1)),
                            Form<double>::constant(in_u(1, 1))}};
  };
  return {
      {form(c[0], re[0], im[0]), form(c[1], re[1], im[1]), form(c[2], re[2], im[2]), form(1, 0, 0)},
      {}};
}

Eigen::Vector3d point(const ConicForms<double>& x, const Eigen::Vector2d& u) {
  Eigen::Vector3d result;
  for (int c = 0; c < 3; ++c)
    result[c] = value(x.point[static_cast<std::size_t>(c)], 0.0, u[0], u[1]);
  return result / value(x.point[3], 0.0, u[0], u[1]);
}

const Eigen::Vector3d kCentre(1, 2, 3), kReal(2, 0, 1), kImaginary(-1, 1, 0.5);

Eigen::Matrix2d matrix(double a, double b, double c, double d) {
  Eigen::Matrix2d result;
  result << a, b, c, d;
  return result;
}

}  // namespace

TEST_CASE("The frame of an ellipse gives its points by the eccentric angle", "[conic_parameter]") {
  const auto x = ellipse_of(kCentre, kReal, kImaginary, matrix(2, 1, 0.5, -3));
  const ConicFrame<double> frame = conic_frame(x, 0.0);
  const Eigen::Matrix2d circle = lines::midpoint(frame.circle);
  for (const double angle : {0.0, 0.4, 1.1, 2.5}) {
    const Eigen::Vector2d z(std::cos(angle), std::sin(angle));
    const Eigen::Vector3d expected = kCentre +
                                     std::cos(2 * angle) * Eigen::Vector3d(frame.real.data()) -
                                     std::sin(2 * angle) * Eigen::Vector3d(frame.imaginary.data());
    CHECK((point(x, circle.inverse() * z) - expected).norm() < 1e-13);
  }
}

TEST_CASE("Two parameters of one ellipse are taken to each other, with equal weights",
          "[conic_parameter]") {
  const auto x = ellipse_of(kCentre, kReal, kImaginary, matrix(1, 0, 0, 1));
  // The second runs in the same direction, the third in the other.
  for (const Eigen::Matrix2d& z : {matrix(2, 1, 0.5, 3), matrix(-1, 0.3, 1, 2)}) {
    const auto y = ellipse_of(kCentre, kReal, kImaginary, z);
    const ConicFrame<double> from = conic_frame(x, 0.0), to = conic_frame(y, 0.0);
    using lines::operator*;
    const Eigen::Matrix2d change =
        lines::midpoint(lines::inverse(to.circle) * (least_turn(from, to) * from.circle));
    for (const double angle : {0.0, 0.7, 1.9, 2.8}) {
      const Eigen::Vector2d u(std::cos(angle), std::sin(angle)), v = change * u;
      CHECK((point(x, u) - point(y, v)).norm() < 1e-13);
      CHECK(value(x.point[3], 0.0, u[0], u[1]) ==
            Approx(value(y.point[3], 0.0, v[0], v[1])).epsilon(1e-13));
    }
  }
}

TEST_CASE("A turned frame is turned back the short way", "[conic_parameter]") {
  ConicFrame<double> from{{{{1, 0}, {0, 1}}}, {1, 0, 0, 0}, {0, 1, 0, 0}};
  for (const double alpha : {0.3, 2.0, 3.1, -1.2, -2.9}) {
    ConicFrame<double> to = from;
    for (std::size_t c = 0; c < 4; ++c) {
      to.real[c] = std::cos(alpha) * from.real[c] - std::sin(alpha) * from.imaginary[c];
      to.imaginary[c] = std::sin(alpha) * from.real[c] + std::cos(alpha) * from.imaginary[c];
    }
    const Eigen::Matrix2d turn = lines::midpoint(least_turn(from, to));
    const Eigen::Matrix2d expected = Eigen::Rotation2Dd(-alpha / 2).toRotationMatrix();
    CHECK(std::min((turn - expected).norm(), (turn + expected).norm()) < 1e-14);
  }
}

TEST_CASE("An arc is half of the circle of its definite form", "[conic_parameter]") {
  // q has the zeros 2 + 3^(1/2) and 2 - 3^(1/2), w is positive between them and indefinite.
  const auto constant = [](double a, double b, double c) {
    return FormInU<double>{
        {Form<double>::constant(a), Form<double>::constant(b), Form<double>::constant(c)}};
  };
  const ConicForms<double> arc{
      {constant(1, 0, 0), constant(0, 1, 0), constant(0, 0, 1), constant(1, 0.45, -0.1)},
      constant(-1, 2, -1)};
  const Eigen::Matrix2d circle = lines::midpoint(conic_frame(arc, 0.0).circle);
  const double root = std::sqrt(3.0);
  const Eigen::Vector2d low = circle * Eigen::Vector2d(2 + root, 1),
                        high = circle * Eigen::Vector2d(2 - root, 1);
  CHECK(low.dot(high) == Approx(0).margin(1e-13));
}
