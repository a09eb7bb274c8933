// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/parameter_curve.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"
#include "error_code.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Point = std::array<double, 2>;

double largest_error(const ParameterCurve& curve, const ParameterPath& path) {
  double largest = 0;
  for (int i = 0; i <= 997; ++i) {
    const double at = i / 997.0;
    const Point a = path(at), b = evaluate(curve, at);
    largest = std::max({largest, std::abs(a[0] - b[0]), std::abs(a[1] - b[1])});
  }
  return largest;
}

void check_clamped(const ParameterCurve& curve) {
  CHECK(curve.poles.size() == pole_count(curve.degree, curve.multiplicities));
  CHECK(curve.knots.front() == 0);
  CHECK(curve.knots.back() == 1);
  CHECK(curve.multiplicities.front() == curve.degree + 1);
  CHECK(curve.multiplicities.back() == curve.degree + 1);
  for (std::size_t i = 1; i < curve.knots.size(); ++i) CHECK(curve.knots[i - 1] < curve.knots[i]);
}

}  // namespace

TEST_CASE("The spline follows its path to within the tolerance", "[parameter_curve]") {
  const std::vector<ParameterPath> paths = {[](double t) {
                                              return Point{t, std::sin(3 * t)};
                                            },
                                            [](double t) {
                                              return Point{1 + 2 * t, 1 / (1 + 25 * t * t)};
                                            },
                                            [](double t) {
                                              return Point{t, std::tanh(40 * (t - 0.3))};
                                            }};
  for (const double tolerance : {1e-6, 1e-12}) {
    for (const ParameterPath& path : paths) {
      const ParameterCurve curve = interpolated(path, tolerance);
      check_clamped(curve);
      CHECK(largest_error(curve, path) / tolerance <= 16);
      CHECK(curve.poles.front() == path(0));
      CHECK(curve.poles.back() == path(1));
    }
  }
}

TEST_CASE("The ends are those of the path, bit for bit", "[parameter_curve]") {
  for (int k = 0; k < 50; ++k) {
    const auto path = [k](double t) {
      return Point{k / 7.0 + t / 3, std::sin(k + 11 * t) / (k + 1)};
    };
    const ParameterCurve curve = interpolated(path, 1e-3);
    CHECK(curve.poles.front() == path(0));
    CHECK(curve.poles.back() == path(1));
  }
}

TEST_CASE("A polynomial path of its degree is met with few poles", "[parameter_curve]") {
  const auto path = [](double t) { return Point{t, 1 + t * (2 - t * t * (3 - std::pow(t, 6)))}; };
  const ParameterCurve curve = interpolated(path, 1e-14);
  CHECK(largest_error(curve, path) < 1e-14);
  CHECK(curve.poles.size() < 12);
}

TEST_CASE("The spline is smooth: inner knots are simple", "[parameter_curve]") {
  const auto path = [](double t) { return Point{t, 1 / (1 + 25 * t * t)}; };
  const ParameterCurve curve = interpolated(path, 1e-12);
  REQUIRE(curve.knots.size() > 2);
  for (std::size_t i = 1; i + 1 < curve.knots.size(); ++i) CHECK(curve.multiplicities[i] == 1);
}

TEST_CASE("A tighter tolerance takes more spans only where the path asks for them",
          "[parameter_curve]") {
  const auto path = [](double t) { return Point{t, std::tanh(40 * (t - 0.3))}; };
  const ParameterCurve coarse = interpolated(path, 1e-4), fine = interpolated(path, 1e-10);
  CHECK(coarse.poles.size() < fine.poles.size());
  double shortest = 1, longest = 0;
  for (std::size_t i = 1; i < fine.knots.size(); ++i) {
    shortest = std::min(shortest, fine.knots[i] - fine.knots[i - 1]);
    longest = std::max(longest, fine.knots[i] - fine.knots[i - 1]);
  }
  CHECK(longest > 4 * shortest);
}

TEST_CASE("A path that jumps is followed as nearly as doubles allow, or refused",
          "[parameter_curve]") {
  const auto path = [](double t) { return Point{t, t < 0.3 ? 0.0 : 1.0}; };
  const auto code = code_of([&] {
    const ParameterCurve curve = interpolated(path, 1e-13);
    check_clamped(curve);
    CHECK(evaluate(curve, 0.1)[1] == Approx(0).margin(1e-3));
    CHECK(evaluate(curve, 0.9)[1] == Approx(1).margin(1e-3));
  });
  if (code) CHECK(*code == ErrorCode::kRegionUnsupported);
}

TEST_CASE("A path that is not finite is refused", "[parameter_curve]") {
  const auto path = [](double t) { return Point{t, 1 / (t - 0.5)}; };
  const auto nowhere = [](double t) { return Point{t, t > 0.7 ? NAN : 0.0}; };
  CHECK(code_of([&] { interpolated(path, 1e-13); }) == ErrorCode::kRegionUnsupported);
  CHECK(code_of([&] { interpolated(nowhere, 1e-13); }) == ErrorCode::kRegionUnsupported);
}

TEST_CASE("Evaluation is that of de Boor's algorithm", "[parameter_curve]") {
  const ParameterCurve curve = interpolated(
      [](double t) {
        return Point{t, std::exp(-5 * t)};
      },
      1e-9);
  const auto ball = [](double x) { return RealBall(x).at_precision(128); };
  const auto flat = flat_knots<RealBall>(curve.knots, curve.multiplicities, ball);
  for (const double at : {0.0, 0.1, 0.25, 0.7, 1.0}) {
    const std::size_t last = span_at(curve.knots, curve.multiplicities, at);
    for (const std::size_t c : {0, 1}) {
      std::vector<RealBall> active;
      for (std::size_t i = last - static_cast<std::size_t>(curve.degree); i <= last; ++i) {
        active.push_back(ball(curve.poles[i][c]));
      }
      const RealBall expected = de_boor(curve.degree, flat, last, std::move(active), ball(at));
      CHECK(evaluate(curve, at)[c] == Approx(expected.midpoint()).margin(1e-14));
    }
  }
}

TEST_CASE("A straight line", "[parameter_curve]") {
  const ParameterCurve line = straight_line({1, 2}, {3, -2});
  check_clamped(line);
  CHECK(evaluate(line, 0) == Point{1, 2});
  CHECK(evaluate(line, 0.25) == Point{1.5, 1});
  CHECK(evaluate(line, 1) == Point{3, -2});
}
