// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/moebius_model.hpp"

#include <catch2/catch.hpp>

#include "minkowski_cases.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Point = std::array<Rational, 3>;
using UnorientedSphereQ = UnorientedSphere<Rational>;

const Rational kTwo(2L);

Point random_point(RandomRationals& random) { return {random(), random(), random()}; }

Rational squared_distance(const Point& a, const Point& b) {
  Rational sum;
  for (std::size_t i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/// The image of y under the inversion at a sphere.
Point inverse(const Point& y, const UnorientedSphereQ& sphere) {
  const Rational factor = sphere.squared_radius / squared_distance(y, sphere.centre);
  Point image;
  for (std::size_t i = 0; i < 3; ++i)
    image[i] = sphere.centre[i] + factor * (y[i] - sphere.centre[i]);
  return image;
}

Point space_point(const MoebiusPoint<Rational>& x) { return sphere_of(x)->centre; }

}  // namespace

TEST_CASE("A point of P^4 is the sphere of its centre and squared radius", "[moebius]") {
  RandomRationals random(40);
  for (int i = 0; i < 20; ++i) {
    const Point m = random_point(random), y = random_point(random);
    const Rational square = squared_distance(m, y);
    const auto p = moebius_point(UnorientedSphereQ{m, square});
    CHECK(sphere_of(p)->centre == m);
    CHECK(sphere_of(p)->squared_radius == square);
    CHECK(moebius_product(p, moebius_point(y)).is_zero());
    CHECK(!moebius_product(p, moebius_point(m)).is_zero());
    CHECK(moebius_product(moebius_point(y), moebius_point(y)).is_zero());
    // (2.13): the square is positive outside Q.
    CHECK(moebius_product(p, p).sign() == 1);
    CHECK(sphere_of(moebius_point(UnorientedSphereQ{m, -square}))->squared_radius == -square);
  }
}

TEST_CASE("Points of the tangent hyperplane at N are planes", "[moebius]") {
  RandomRationals random(41);
  for (int i = 0; i < 10; ++i) {
    const Point n = random_point(random), y = random_point(random);
    const Rational h = n[0] * y[0] + n[1] * y[1] + n[2] * y[2];
    const MoebiusPoint<Rational> plane = {h, n[0], n[1], n[2], h};
    CHECK(!sphere_of(plane));
    CHECK(moebius_product(plane, moebius_point(y)).is_zero());
    CHECK(moebius_point(sphere_equation(plane)) ==
          MoebiusPoint<Rational>{kTwo * h, kTwo * n[0], kTwo * n[1], kTwo * n[2], kTwo * h});
  }
}

TEST_CASE("Spheres are orthogonal exactly when their points are conjugate", "[moebius]") {
  RandomRationals random(42);
  for (int i = 0; i < 10; ++i) {
    const Point m = random_point(random), other = random_point(random);
    const Rational square = squared_distance(m, other), share = Rational(1L) / Rational(3L);
    const auto p = moebius_point(UnorientedSphereQ{m, share * square});
    const auto orthogonal =
        moebius_point(UnorientedSphereQ{other, (Rational(1L) - share) * square});
    const auto oblique = moebius_point(UnorientedSphereQ{other, square});
    CHECK(moebius_product(p, orthogonal).is_zero());
    CHECK(!moebius_product(p, oblique).is_zero());
  }
}

TEST_CASE("Inversions are the collineations that keep a sphere and all orthogonal to it",
          "[moebius]") {
  RandomRationals random(43);
  for (int i = 0; i < 10; ++i) {
    const UnorientedSphereQ mirror = {random_point(random), random() + Rational(31L)};
    const auto z = moebius_point(mirror);
    const Point y = random_point(random), m = random_point(random);
    CHECK(space_point(inverted(moebius_point(y), z)) == inverse(y, mirror));
    // Incidence is kept, also with spheres, and a second inversion undoes the first.
    const auto sphere = moebius_point(UnorientedSphereQ{m, squared_distance(m, y)});
    const auto image = inverted(sphere, z);
    CHECK(moebius_product(image, moebius_point(inverse(y, mirror))).is_zero());
    const auto back = sphere_of(inverted(image, z));
    CHECK(back->centre == m);
    CHECK(back->squared_radius == squared_distance(m, y));
    // A plane reflects.
    const MoebiusPoint<Rational> plane = {y[0], Rational(1L), Rational(), Rational(), y[0]};
    CHECK(space_point(inverted(moebius_point(m), plane)) == Point{kTwo * y[0] - m[0], m[1], m[2]});
  }
}

TEST_CASE("The three kinds of pencils", "[moebius]") {
  const auto sphere = [](long x, long square) {
    return moebius_point(
        UnorientedSphereQ{{Rational(x), Rational(), Rational()}, Rational(square)});
  };
  CHECK(pencil_kind(sphere(0, 4), sphere(3, 4)) == PencilKind::kThroughCircle);
  CHECK(pencil_kind(sphere(0, 4), sphere(3, 1)) == PencilKind::kTouching);
  CHECK(pencil_kind(sphere(0, 4), sphere(1, 1)) == PencilKind::kTouching);
  CHECK(pencil_kind(sphere(0, 4), sphere(5, 4)) == PencilKind::kWithPoints);
  CHECK(pencil_kind(sphere(0, 4), sphere(0, 1)) == PencilKind::kWithPoints);
  const Rational zero, one(1L);
  const MoebiusPoint<Rational> plane = {zero, one, zero, zero, zero};
  const MoebiusPoint<Rational> parallel = {one, one, zero, zero, one};
  CHECK(pencil_kind(plane, parallel) == PencilKind::kTouching);
  CHECK(pencil_kind(plane, {one, zero, one, zero, one}) == PencilKind::kThroughCircle);
  CHECK(pencil_kind(plane, sphere(1, 1)) == PencilKind::kTouching);
  CHECK(pencil_kind(plane, sphere(1, 2)) == PencilKind::kThroughCircle);

  // A touching pencil contains its point, one with points two of them, on Q.
  const auto p = sphere(0, 4), q = sphere(3, 1);
  const Rational pq = moebius_product(p, q), pp = moebius_product(p, p);
  MoebiusPoint<Rational> contact;
  for (std::size_t i = 0; i < 5; ++i) contact[i] = pp * q[i] - pq * p[i];
  CHECK(moebius_product(contact, contact).is_zero());
  CHECK(space_point(contact) == Point{Rational(2L), zero, zero});
}
