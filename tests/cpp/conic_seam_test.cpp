// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_seam.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "moving_ellipses.hpp"

using namespace pn;
using namespace pn::test;

namespace {

RationalPolynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

ConicForms<double> estimate(const MovingConic& conic) {
  return midpoint(ConicPoints({conic, {}})(128));
}

Eigen::Matrix2d weight(const ConicForms<double>& x, double t) {
  Eigen::Matrix2d result;
  const auto& c = x.point[3].coefficient;
  result << c[0](t), c[1](t), c[1](t), c[2](t);
  return result;
}

Eigen::Vector3d point(const ConicForms<double>& x, double t, const Eigen::Vector2d& u) {
  Eigen::Vector3d result;
  for (int c = 0; c < 3; ++c)
    result[c] = value(x.point[static_cast<std::size_t>(c)], t, u[0], u[1]);
  return result / value(x.point[3], t, u[0], u[1]);
}

/// Ellipses in planes through the z-axis from angle 90 i to 90 (i + 1) degrees.
MovingConic quarter(int i, const Conic& conic) {
  const RationalPolynomial one = poly({1, 0, 1}), cos = poly({1, 0, -1}), sin = poly({0, 2});
  const std::array<std::array<RationalPolynomial, 2>, 4> turned = {
      {{cos, sin}, {-sin, cos}, {-cos, -sin}, {sin, -cos}}};
  const auto& [c, s] = turned[static_cast<std::size_t>(i)];
  MovingConic result = moving({5L * c, 5L * s, 0L}, {c, s, 0L}, {0L, 0L, one}, conic);
  result.frame[3][0] = one;
  return result;
}

}  // namespace

TEST_CASE("Even lines have a constant weight on the circle", "[conic_seam]") {
  const auto x = estimate(upright(ellipse(poly({2, 1, 3}), poly({5, -2, 1}))));
  const ConicSeam seam({x}, false);
  for (const double t : {0.0, 0.3, 0.77, 1.0}) {
    const Eigen::Matrix2d f = seam.at(0, t);
    CHECK((f.transpose() * weight(x, t) * f - Eigen::Matrix2d::Identity()).norm() < 1e-12);
  }
}

TEST_CASE("The lines turn with the circles and not around them", "[conic_seam]") {
  // In planes through an axis the rotation-minimizing frame turns about the axis.
  const auto x = estimate(quarter(0, ellipse(1L, 1L)));
  const ConicSeam seam({x}, false);
  const auto in_plane = [&](double t, const Eigen::Vector2d& u) {
    const Eigen::Vector3d p = point(x, t, seam.at(0, t) * u);
    return Eigen::Vector2d(std::hypot(p[0], p[1]), p[2]);
  };
  for (const double t : {0.2, 0.6, 1.0}) {
    for (const Eigen::Vector2d& u : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0.3, 2)}) {
      CHECK((in_plane(t, u) - in_plane(0, u)).norm() < 1e-12);
    }
  }
}

TEST_CASE("Around a closed surface the seam closes", "[conic_seam]") {
  std::vector<ConicForms<double>> spans;
  for (int i = 0; i < 4; ++i) spans.push_back(estimate(quarter(i, ellipse(4L, 1L))));
  const ConicSeam seam(spans, true);
  for (const Eigen::Vector2d& u : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0.3, 2)}) {
    CHECK((point(spans[0], 0, seam.at(0, 0) * u) - point(spans[3], 1, seam.at(3, 1) * u)).norm() <
          1e-12);
    for (std::size_t i = 1; i < 4; ++i) {
      CHECK((point(spans[i - 1], 1, seam.at(i - 1, 1) * u) - point(spans[i], 0, seam.at(i, 0) * u))
                .norm() < 1e-12);
    }
  }
}

TEST_CASE("The lines of arcs end where the arcs do, and beyond by the margin", "[conic_seam]") {
  // Ellipses, parabolas and hyperbolas x^2 + (1/2 - t) y^2 = y below y = 1.
  Conic conic = diagonal(0L, 2L, poly({1, -2}));
  conic[0][2] = conic[2][0] = -1L;
  const auto x =
      midpoint(ConicPoints({upright(conic), Vector3<RationalPolynomial>{1L, 0L, -1L}})(128));
  const ArcLines at_ends({x}, 0), beyond({x}, 0.1);
  for (const double t : {0.0, 0.4, 0.5, 0.8, 1.0}) {
    const Eigen::Matrix2d f = at_ends.at(0, t), wide = beyond.at(0, t);
    for (int k = 0; k < 2; ++k) {
      CHECK(point(x, t, f.col(k))[1] == Approx(1).epsilon(1e-12));
      CHECK(point(x, t, wide.col(k))[1] > 1);
    }
    CHECK(point(x, t, f * Eigen::Vector2d(1, 1))[1] < 1);
    // The weights are 1, l k, 1.
    const Eigen::Matrix2d weights = f.transpose() * weight(x, t) * f;
    CHECK(weights(0, 0) == Approx(1).epsilon(1e-12));
    CHECK(weights(1, 1) == Approx(1).epsilon(1e-12));
  }
}
