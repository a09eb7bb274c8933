// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/sphere.hpp"

#include <catch2/catch.hpp>

#include "minkowski_cases.hpp"

using namespace pn;
using namespace pn::test;

TEST_CASE("Spheres on an isotropic line touch in one point with one normal", "[minkowski]") {
  RandomRationals random(2);
  for (int i = 0; i < 20; ++i) {
    const auto w = RandomRationals::isotropic(random(), random());
    const Sphere a = sphere_of(random.vector());
    const Sphere b = sphere_of(translated(point_of(a), random() + Rational(100L), w));
    CHECK(in_contact(a, b));
    CHECK(contact_point(a, w) == contact_point(b, w));
    // Touching from outside, as for unoriented spheres, is no contact.
    CHECK_FALSE(
        in_contact(a, Sphere{b.centre, -b.radius + Rational(2L) * a.radius + Rational(1L)}));
    const OrientedPlane<Rational> plane = {w, minkowski(w, point_of(a))};
    CHECK(in_contact(a, plane));
    CHECK(in_contact(b, plane));
    CHECK_FALSE(in_contact(Sphere{a.centre, a.radius + Rational(1L)}, plane));
  }
}

TEST_CASE("The plane of an isotropic hyperplane touches its spheres from the right side",
          "[minkowski]") {
  RandomRationals random(3);
  const auto w = RandomRationals::isotropic(random(), random());
  const Sphere sphere = sphere_of(random.vector());
  const Rational c = minkowski(w, point_of(sphere));
  const auto x = contact_point(sphere, w);
  CHECK((w[0] * x[0] + w[1] * x[1] + w[2] * x[2]) == c);
  Rational square;
  for (std::size_t i = 0; i < 3; ++i)
    square += (x[i] - sphere.centre[i]) * (x[i] - sphere.centre[i]);
  CHECK(square == sphere.radius * sphere.radius);
}
