// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/evaluation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"

using pn::BSplineSurface;
using pn::evaluate;
using namespace pn::test;

namespace {

/// Inner knots of multiplicity one and two, uneven weights.
BSplineSurface surface() {
  BSplineSurface s;
  s.u_degree = 3;
  s.v_degree = 2;
  s.u_knots = {-1, 0.5, 2, 3};
  s.u_multiplicities = {4, 1, 2, 4};
  s.v_knots = {0, 1, 4};
  s.v_multiplicities = {3, 1, 3};
  for (std::size_t i = 0; i < s.u_count(); ++i) {
    for (std::size_t j = 0; j < s.v_count(); ++j) {
      const double x = static_cast<double>(i), y = static_cast<double>(j);
      s.poles.push_back({x, y + 0.1 * x * x, x * y - 0.3 * y * y});
      s.weights.push_back(1 + static_cast<double>((3 * i + 5 * j) % 7) / 4);
    }
  }
  return s;
}

}  // namespace

TEST_CASE("Values are those of de Boor's algorithm in balls", "[evaluation]") {
  const BSplineSurface s = surface();
  for (const double u : {-1.0, 0.0, 0.5, 1.9, 2.0, 2.5, 3.0}) {
    for (const double v : {0.0, 0.7, 1.0, 3.9, 4.0}) {
      const auto point = evaluate(s, u, v);
      const auto expected = enclosed_point(s, u, v, 128);
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(point[c] == Approx(expected[c].midpoint()).margin(1e-13));
    }
  }
}

TEST_CASE("The basis functions sum to one", "[evaluation]") {
  BSplineSurface s = surface();
  for (auto& pole : s.poles) pole = {3, -5, 7};
  for (const double u : {-1.0, 0.2, 0.5, 2.0, 3.0}) {
    const auto point = evaluate(s, u, 1.3);
    CHECK(point[0] == Approx(3));
    CHECK(point[1] == Approx(-5));
  }
}

TEST_CASE("Parameters outside the knots are taken at the nearest end", "[evaluation]") {
  const BSplineSurface s = surface();
  CHECK(evaluate(s, -7, 9) == evaluate(s, -1, 4));
  CHECK(evaluate(s, 5, -1) == evaluate(s, 3, 0));
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(evaluate(s, -1, 0)[c] == Approx(s.poles.front()[c]));
    CHECK(evaluate(s, 3, 4)[c] == Approx(s.poles.back()[c]));
  }
}

TEST_CASE("The active basis is positive inside, sums to one and reproduces its variable",
          "[evaluation]") {
  const std::vector<double> knots = {-1, 0.5, 2, 3};
  const std::vector<int> multiplicities = {4, 1, 2, 4};
  const std::vector<double> flat = {-1, -1, -1, -1, 0.5, 2, 2, 3, 3, 3, 3};
  const pn::SplineBasis spline(3, knots, multiplicities);
  for (const double u : {-1.0, -0.3, 0.5, 1.99, 2.0, 2.7, 3.0}) {
    const pn::ActiveBasis basis = spline.at(u);
    REQUIRE(basis.values.size() == 4);
    CHECK(basis.first + 4 <= pn::pole_count(3, multiplicities));
    double sum = 0, mean = 0;
    for (int i = 0; i < 4; ++i) {
      const std::size_t pole = basis.first + static_cast<std::size_t>(i);
      CHECK(basis.values[i] >= 0);
      sum += basis.values[i];
      mean += basis.values[i] * (flat[pole + 1] + flat[pole + 2] + flat[pole + 3]) / 3;
    }
    CHECK(sum == Approx(1));
    CHECK(mean == Approx(u));  // the Greville abscissae are the poles of the identity
  }
}

TEST_CASE("The basis of the largest degree is that of Bernstein on a single span", "[evaluation]") {
  const pn::SplineBasis spline(pn::kLargestDegree, {0, 1},
                               {pn::kLargestDegree + 1, pn::kLargestDegree + 1});
  const double t = 0.3;
  const pn::ActiveBasis basis = spline.at(t);
  double expected = std::pow(1 - t, pn::kLargestDegree);  // C(n, i) t^i (1 - t)^(n - i)
  for (int i = 0; i <= pn::kLargestDegree; ++i) {
    CHECK(basis.values[i] == Approx(expected));
    expected *= (pn::kLargestDegree - i) / (i + 1.0) * t / (1 - t);
  }
}

TEST_CASE("An evaluation of many points is that of each", "[evaluation]") {
  const BSplineSurface s = surface();
  const pn::SurfaceEvaluation evaluation(s);
  for (const double u : {-1.0, 0.7, 3.0}) CHECK(evaluation(u, 2.5) == evaluate(s, u, 2.5));
}

TEST_CASE("The normal is the product of the derivatives", "[evaluation]") {
  const BSplineSurface s = surface();
  const pn::SurfaceEvaluation evaluation(s);
  constexpr double kStep = 1e-5;
  const auto at = [&](double u, double v) { return Eigen::Vector3d(evaluation(u, v).data()); };
  for (const double u : {-0.7, 0.3, 1.2, 2.4}) {
    for (const double v : {0.4, 1.7, 3.1}) {
      const Eigen::Vector3d along = at(u + kStep, v) - at(u - kStep, v),
                            across = at(u, v + kStep) - at(u, v - kStep);
      const Eigen::Vector3d expected = along.cross(across) / (4 * kStep * kStep);
      CHECK((Eigen::Vector3d(evaluation.normal(u, v).data()) - expected).norm() <
            1e-7 * expected.norm());
    }
  }
  // One-sided at the ends.
  const Eigen::Vector3d along = at(-1 + kStep, 0) - at(-1, 0), across = at(-1, kStep) - at(-1, 0);
  const Eigen::Vector3d expected = along.cross(across) / (kStep * kStep);
  CHECK((Eigen::Vector3d(evaluation.normal(-1, 0).data()) - expected).norm() <
        1e-3 * expected.norm());
}
