// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/characteristic_circle.hpp"

#include <catch2/catch.hpp>

#include "conic_families.hpp"
#include "pn/algebra/common_factor.hpp"
#include "pn/conics/interval_substitution.hpp"
#include "pn/conics/rational_conic_family.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Polynomial = RationalPolynomial;
using Curve4 = MoebiusPoint<Polynomial>;

Polynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

/// Centre a / d and squared radius b / d^2.
Curve4 spheres(const std::array<Polynomial, 3>& a, const Polynomial& b, const Polynomial& d) {
  return coprime(moebius_point(SphereEquation<Polynomial>{
      d * d, {d * a[0], d * a[1], d * a[2]}, a[0] * a[0] + a[1] * a[1] + a[2] * a[2] - b}));
}

/// The point (y, y0) of the circle of t at u, in balls.
std::array<RealBall, 4> point_of_circle(const MovingConic& circle, const QuadraticPoints& points,
                                        const Rational& t, long u) {
  const RealBall at(t, 256), parameter(u);
  std::array<RealBall, 4> x;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& y = points.coordinate[i];
      x[c] += RealBall(circle.frame[c][i](t), 256) *
              (y[0](at) + y[1](at) * parameter + y[2](at) * parameter * parameter);
    }
  }
  return x;
}

/// <p, v(y)> for the point of Q that (y, y0) is, times y0^2.
RealBall incidence(const Curve4& curve, const Rational& t, const std::array<RealBall, 4>& y) {
  const auto [w, q, z] = sphere_equation(curve);
  const auto value = [&](const Polynomial& p) { return RealBall(p(t), 256); };
  RealBall sum = value(z) * y[3] * y[3];
  for (std::size_t i = 0; i < 3; ++i) {
    sum += value(w) * y[i] * y[i] - RealBall(2L) * value(q[i]) * y[i] * y[3];
  }
  return sum;
}

Curve4 derivative(const Curve4& curve) { return tangent_pencil(curve).second; }

Curve4 random_spheres(RandomConics& random, int degree) {
  const std::array<Polynomial, 3> centre = {random.any(degree), random.any(degree),
                                            random.any(degree)};
  // Small against the motion of the centre, on [0, 1] at least where the discriminant says so.
  return spheres(centre, random.positive(1), Polynomial(1L));
}

}  // namespace

TEST_CASE("The circle lies on the sphere and on its neighbour", "[characteristic_circle]") {
  RandomConics random(3);
  int tried = 0;
  for (int i = 0; i < 12; ++i) {
    const Curve4 curve = random_spheres(random, 1 + i % 3);
    const Polynomial discriminant = circle_discriminant(line_coordinates(tangent_pencil(curve)));
    if (discriminant(Rational(0)).sign() <= 0) continue;
    const MovingConic circle = shared_circle(tangent_pencil(curve));
    if (interval_without_real_points(family_of(circle))) continue;
    const QuadraticPoints points = RationalConicFamily(family_of(circle)).points(256);
    for (const long u : {-2L, 0L, 5L}) {
      for (const Rational& t : {Rational(0), Rational(2), Rational(1L) / Rational(3L)}) {
        const auto y = point_of_circle(circle, points, t, u);
        CHECK(y[3].magnitude_upper() > 0);
        CHECK(incidence(curve, t, y).contains_zero());
        CHECK(incidence(derivative(curve), t, y).contains_zero());
      }
    }
    ++tried;
  }
  CHECK(tried >= 3);
}

TEST_CASE("Spheres share real points exactly where the discriminant is positive",
          "[characteristic_circle]") {
  // The centre (t, 0, 0) and the squared radius 1 + 4 t^3: |m'|^2 r^2 - (r r')^2 = 1 + 4 t^3 - 36
  // t^4.
  const Curve4 curve = spheres({poly({0, 1}), poly({}), poly({})}, poly({1, 0, 0, 4}), 1L);
  const Polynomial discriminant = circle_discriminant(line_coordinates(tangent_pencil(curve)));
  const Polynomial expected = poly({1, 0, 0, 4, -36});
  CHECK(discriminant * Polynomial(expected.coefficient(0)) ==
        expected * Polynomial(discriminant.coefficient(0)));
  CHECK(discriminant.coefficient(0).sign() == 1);
  const ConicFamily family = family_of(shared_circle(tangent_pencil(curve)));
  const Rational half = Rational(1L) / Rational(2L), third = Rational(1L) / Rational(3L);
  CHECK(!interval_without_real_points(family, Rational(0), third));
  CHECK(interval_without_real_points(family, Rational(0), half));
}

TEST_CASE("Where the centre stands still for a moment the circle goes on",
          "[characteristic_circle]") {
  // t in place of t^2 would be a cylinder.
  const Curve4 curve = spheres({poly({0, 0, 1}), poly({}), poly({})}, poly({2}), 1L);
  const Polynomial discriminant = circle_discriminant(line_coordinates(tangent_pencil(curve)));
  CHECK(discriminant.degree() == 0);
  CHECK(discriminant(Rational(0)).sign() == 1);
}

// The degrees of ../docs/canal_surfaces_from_squared_radii.md. Circles are real for all t, infinity
// included: the centre moves faster than the radius changes.
TEST_CASE("The degrees of polynomial centres and squared radii", "[characteristic_circle]") {
  RandomConics random(11);
  const std::array<int, 6> expected = {0, 1, 4, 5, 8, 9};
  const Polynomial small(Rational(1L) / Rational(16L));
  for (int k = 1; k <= 5; ++k) {
    int tried = 0;
    for (int repeat = 0; repeat < 4; ++repeat) {
      const std::array<Polynomial, 3> centre = {random.any(k), random.any(k), random.any(k)};
      const int half_degree = repeat % (k + 1);
      const Curve4 curve = spheres(centre, small * random.positive(half_degree), 1L);
      const ConicFamily family = family_of(shared_circle(tangent_pencil(curve)));
      if (interval_without_real_points(family)) continue;
      ++tried;
      INFO("k = " << k << ", degree of r^2 = " << 2 * half_degree);
      CHECK(RationalConicFamily(family).degree() == expected[static_cast<std::size_t>(k)]);
    }
    CHECK(tried >= 2);
  }
}

TEST_CASE("The degrees of rational centres and squared radii", "[characteristic_circle]") {
  RandomConics random(12);
  const Polynomial small(Rational(1L) / Rational(16L));
  int tried = 0;
  for (int k = 1; k <= 4; ++k) {
    for (int repeat = 0; repeat < 4; ++repeat) {
      const Polynomial d = random.any(k % 2) * random.positive(k / 2);
      const std::array<Polynomial, 3> centre = {random.any(k), random.any(k), random.any(k)};
      const Curve4 curve = spheres(centre, small * random.positive(k), d);
      const ConicFamily family = family_of(shared_circle(tangent_pencil(curve)));
      if (interval_without_real_points(family)) continue;
      ++tried;
      INFO("k = " << k);
      CHECK(RationalConicFamily(family).degree() == 3 * k - 2);
    }
  }
  CHECK(tried >= 4);
}
