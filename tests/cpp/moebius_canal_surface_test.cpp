// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/moebius_canal_surface.hpp"

#include <catch2/catch.hpp>

#include "error_code.hpp"
#include "pn/conics/interval_substitution.hpp"
#include "pn/conics/rational_conic_family.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const Curve kSpine = Curve::bezier({{0, 0, 0}, {10, 5, 0}, {20, -5, 5}, {30, 0, 0}});

bool is_pn(const CanalSurfaceFromSquares& surface) {
  return std::holds_alternative<EnvelopeChain>(surface);
}

std::optional<ErrorCode> code_with(const std::vector<double>& squared_radius) {
  return code_of([&] { moebius_canal_surface(kSpine, Law::bezier(squared_radius)); });
}

RationalPolynomial poly(const std::vector<Rational>& c) { return RationalPolynomial(c); }

/// c0 + c1 t + c2 t^2 with spheres around (0, 0, 0), (3, 1, 0) and (6, 0, 0) as control points.
MoebiusCurve conic() {
  const auto sphere = [](long x, long y, long z, long square) {
    return moebius_point(UnorientedSphere<Rational>{{x, y, z}, square});
  };
  const auto a = sphere(0, 0, 0, 4), b = sphere(3, 1, 0, 12), c = sphere(6, 0, 0, 3);
  MoebiusCurve curve;
  const Rational two(2L);
  for (std::size_t i = 0; i < 5; ++i) {
    curve[i] = poly({a[i], two * (b[i] - a[i]), a[i] - two * b[i] + c[i]});
  }
  return curve;
}

/// <p, v(y)> of homogeneous coordinates (y, y0).
RealBall incidence(const MoebiusPoint<Rational>& p, const std::array<RealBall, 4>& y) {
  const auto [w, q, z] = sphere_equation(p);
  const auto ball = [](const Rational& x) { return RealBall(x, 256); };
  RealBall sum = ball(z) * y[3] * y[3];
  for (std::size_t i = 0; i < 3; ++i) {
    sum += ball(w) * y[i] * y[i] - RealBall(2L) * ball(q[i]) * y[i] * y[3];
  }
  return sum;
}

}  // namespace

TEST_CASE("A rational radius makes a canal surface with offsets", "[moebius_canal_surface]") {
  // The radii 2, 2 + t and 3 t; and roots.
  CHECK(is_pn(moebius_canal_surface(kSpine, Law::constant(4))));
  CHECK(is_pn(moebius_canal_surface(kSpine, Law::bezier({4, 6, 9}))));
  CHECK(is_pn(moebius_canal_surface(kSpine, Law::bezier({0, 0, 9}))));
  CHECK(!is_pn(moebius_canal_surface(kSpine, Law::constant(2))));
  CHECK(!is_pn(moebius_canal_surface(kSpine, Law::bezier({4, 5}))));
  CHECK(!is_pn(moebius_canal_surface(kSpine, Law::bezier({4, 6, 9.5}))));
  const auto surface = moebius_canal_surface(kSpine, Law::bezier({4, 6, 9}));
  const auto& chain = std::get<EnvelopeChain>(surface);
  const auto& spheres = chain.links.front().spheres->curve;
  CHECK(spheres.radius == (poly({2, 1}) * spheres.denominator));
}

TEST_CASE("The same curve in P^4 gives the same kind of surface", "[moebius_canal_surface]") {
  const RationalPolynomial t = poly({0, 1}), two(2L);
  const auto along = [&](const RationalPolynomial& square) {
    const SphereEquation<RationalPolynomial> sphere{
        1L, {t, t * t, 0L}, t * t + t * t * t * t - square};
    return moebius_canal_surface(moebius_point(sphere));
  };
  CHECK(is_pn(along(two * two)));
  CHECK(!is_pn(along(two)));
  CHECK(!is_pn(along(two + t)));
}

TEST_CASE("A conic in P^4 gives a Darboux cyclide of order four", "[moebius_canal_surface]") {
  const MoebiusCurve curve = conic();
  const auto surface = moebius_canal_surface(curve);
  const auto& spans = std::get<std::vector<ConicSpan>>(surface);
  REQUIRE(spans.size() == 1);
  const MovingConic& circle = spans.front().conic;
  const ConicFamily family = family_of(circle);
  const IntervalSubstitution t = interval_substitution(family, Rational(0), Rational(1));
  const QuadraticPoints points = RationalConicFamily(substituted(family, t)).points(256);
  MoebiusPoint<Rational> c0, c1, c2;
  for (std::size_t i = 0; i < 5; ++i) {
    c0[i] = curve[i].coefficient(0);
    c1[i] = curve[i].coefficient(1);
    c2[i] = curve[i].coefficient(2);
  }
  for (const long s : {1L, 2L, 3L}) {
    const Rational at = Rational(s) / Rational(3L);
    for (const long u : {-1L, 0L, 4L}) {
      std::array<RealBall, 4> y;
      for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t i = 0; i < 3; ++i) {
          const auto& form = points.coordinate[i];
          const RealBall x(at, 256), parameter(u);
          y[c] += RealBall(t(circle.frame[c][i], family.degree[i])(at), 256) *
                  (form[0](x) + form[1](x) * parameter + form[2](x) * parameter * parameter);
        }
      }
      // The discriminant of <c(t), v(y)>, of degree four in y.
      const RealBall a = incidence(c0, y), b = incidence(c1, y), c = incidence(c2, y);
      CHECK((b * b - RealBall(4L) * a * c).contains_zero());
      CHECK(!(b * b).contains_zero());
      CHECK(y[3].magnitude_upper() > 0);
    }
  }
}

TEST_CASE("Squared radii without an envelope are refused", "[moebius_canal_surface]") {
  CHECK(code_with({4, -9, 5}) == ErrorCode::kNegativeRadius);
  CHECK(code_with({-1, 5}) == ErrorCode::kNegativeRadius);
  CHECK(code_with({0, 5}) == ErrorCode::kNegativeRadius);
  CHECK(code_with({1, 900}) == ErrorCode::kRadiusTooSteep);
  CHECK(code_with({0}) == ErrorCode::kWrongShape);
  const auto of_curve = [](const MoebiusCurve& curve) {
    return code_of([&] { moebius_canal_surface(curve); });
  };
  const RationalPolynomial t = poly({0, 1}), one(1L), zero;
  CHECK(of_curve({}) == ErrorCode::kWrongShape);
  CHECK(of_curve({t, one, zero, zero, t}) == ErrorCode::kDevelopable);
  // One sphere, with a factor; and a pencil through a circle.
  CHECK(of_curve({one + t, zero, zero, zero, -(one + t) * RationalPolynomial(2L)}) ==
        ErrorCode::kZeroLength);
  CHECK(of_curve({one, t, zero, zero, -RationalPolynomial(2L)}) == ErrorCode::kDevelopable);
}

TEST_CASE("A refusal names the interval", "[moebius_canal_surface]") {
  // r^2 = 4 - 8 t is negative behind t = 1/2, where the spine is at (15, 0, 1.875).
  CHECK_THROWS_WITH(moebius_canal_surface(kSpine, Law::bezier({4, -4})),
                    Catch::Contains("parameters 0.5 to 1"));
}

TEST_CASE("Spans join where the circles are the same, and corners are refused",
          "[moebius_canal_surface]") {
  const Law law = Law::bezier({4, 5});
  const auto spine = [](double y) {
    return Curve::bspline({2,
                           {0, 0.5, 1},
                           {3, 2, 3},
                           {{0, 0, 0}, {5, 5, 0}, {10, 5, 0}, {15, y, 0}, {20, 0, 0}},
                           {}});
  };
  const auto smooth = moebius_canal_surface(spine(5), law);
  CHECK(std::get<std::vector<ConicSpan>>(smooth).size() == 2);
  CHECK(code_of([&] { moebius_canal_surface(spine(6), law); }) == ErrorCode::kCornerTooSharp);
  // With a rational radius a corner is closed by a zone.
  CHECK(is_pn(moebius_canal_surface(spine(6), Law::constant(4))));
}
