// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/laguerre_map.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

#include "minkowski_cases.hpp"

using namespace pn;
using namespace pn::test;

namespace {

/// The parameters of the sphere that has the normal w, by Cramer's rule, and this sphere.
struct ContactSphere {
  Rational u, v;
  MinkowskiVector<Rational> point;
};

ContactSphere contact_sphere(const QuadraticFamily& family, const MinkowskiVector<Rational>& w) {
  const auto a = family.power();
  std::array<Rational, 5> q;
  for (std::size_t i = 0; i < 5; ++i) q[i] = minkowski(w, a[i]);
  const Rational e = q[0] * q[2] - q[1] * q[1];
  const Rational u = (q[1] * q[4] - q[2] * q[3]) / e, v = (q[1] * q[3] - q[0] * q[4]) / e;
  const Rational half = Rational(1L) / Rational(2L);
  MinkowskiVector<Rational> f = a[5];
  const std::array<Rational, 5> powers = {half * u * u, u * v, half * v * v, u, v};
  for (std::size_t i = 0; i < 5; ++i) f = translated(f, powers[i], a[i]);
  return {u, v, f};
}

}  // namespace

TEST_CASE("Laguerre transformations keep contact of spheres and of planes", "[minkowski]") {
  RandomRationals random(13);
  for (int i = 0; i < 10; ++i) {
    const LaguerreMap map = random_laguerre_map(random);
    const auto w = RandomRationals::isotropic(random(), random());
    const Sphere a = sphere_of(random.vector());
    const Sphere b = sphere_of(translated(point_of(a), random() + Rational(50L), w));
    CHECK(in_contact(map(a), map(b)));
    const OrientedPlane<Rational> plane = {w, minkowski(w, point_of(a))};
    const OrientedPlane<Rational> image = map(plane);
    CHECK(minkowski(image.w, image.w).is_zero());
    CHECK(in_contact(map(a), image));
    CHECK(in_contact(map(b), image));
    CHECK_FALSE(in_contact(map(Sphere{a.centre, a.radius + Rational(1L)}), image));
  }
}

TEST_CASE("Laguerre transformations form a group", "[minkowski]") {
  RandomRationals random(14);
  const LaguerreMap f = random_laguerre_map(random), g = random_laguerre_map(random);
  const auto x = random.vector();
  CHECK((f * g)(x) == f(g(x)));
  CHECK(f.inverse()(f(x)) == x);
  CHECK((f.inverse() * f).linear() == LaguerreMap::identity().linear());
  CHECK((f * g).square_factor() == f.square_factor() * g.square_factor());
  const auto a = random.vector();
  const LaguerreMap mirror = LaguerreMap::reflection(a);
  CHECK((mirror * mirror)(x) == x);
  CHECK(mirror(a) == translated({}, Rational(-1L), a));
  const Sphere sphere = sphere_of(x);
  CHECK(LaguerreMap::offset(Rational(2L))(sphere).radius == sphere.radius + Rational(2L));
}

TEST_CASE("The image of an envelope is the envelope of the images", "[minkowski]") {
  RandomRationals random(15);
  for (int i = 0; i < 10; ++i) {
    const LaguerreMap map = random_laguerre_map(random);
    QuadraticFamily::Control control;
    for (auto& b : control) b = random.vector();
    const QuadraticFamily family(control), image(map(control));
    const auto w = RandomRationals::isotropic(random(), random());
    const ContactSphere before = contact_sphere(family, w);
    const ContactSphere after = contact_sphere(image, map.direction(w));
    CHECK(after.u == before.u);
    CHECK(after.v == before.v);
    CHECK(after.point == map(before.point));
    // The tangent planes of the envelopes.
    const OrientedPlane<Rational> mapped =
        map(OrientedPlane<Rational>{w, minkowski(w, before.point)});
    CHECK(mapped.w == map.direction(w));
    CHECK(mapped.c == minkowski(mapped.w, after.point));
  }
}

TEST_CASE("Other linear maps are no Laguerre transformations", "[minkowski]") {
  LaguerreMap::Matrix shear = LaguerreMap::identity().linear();
  shear[0][1] = Rational(1L);
  CHECK_THROWS_AS(LaguerreMap(shear, {}), std::domain_error);
  CHECK_THROWS_AS(LaguerreMap(LaguerreMap::Matrix{}, {}), std::domain_error);
  CHECK_THROWS_AS(LaguerreMap::dilation(Rational()), std::domain_error);
  CHECK_THROWS_AS(LaguerreMap::reflection({3L, 0L, 4L, 5L}), std::domain_error);
}
