// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/laguerre_models.hpp"

#include <catch2/catch.hpp>

#include "minkowski_cases.hpp"

using namespace pn;
using namespace pn::test;

namespace {

OrientedPlane<Rational> random_plane(RandomRationals& random) {
  return {RandomRationals::isotropic(random(), random() + Rational(31L)), random()};
}

/// (w, c) of the same plane with w4 = 1.
OrientedPlane<Rational> normalized(const OrientedPlane<Rational>& plane) {
  return plane_of_blaschke_point(blaschke_point(plane));
}

void check_same(const OrientedPlane<Rational>& a, const OrientedPlane<Rational>& b) {
  CHECK(normalized(a).w == normalized(b).w);
  CHECK(normalized(a).c == normalized(b).c);
}

/// e0, n of the worked examples: e0 + n.x = 0.
std::array<Rational, 4> plane_coordinates(const OrientedPlane<Rational>& plane) {
  const auto [n1, n2, n3, e0] = blaschke_point(plane);
  return {e0, n1, n2, n3};
}

}  // namespace

TEST_CASE("Every model gives back its planes and spheres", "[minkowski]") {
  RandomRationals random(16);
  for (int i = 0; i < 10; ++i) {
    const auto plane = random_plane(random);
    check_same(plane_of_blaschke_point(blaschke_point(plane)), plane);
    check_same(plane_of_isotropic_point(isotropic_point(plane)), plane);
    check_same(plane_of_dual_isotropic_plane(dual_isotropic_plane(plane)), plane);
    const Sphere sphere = sphere_of(random.vector());
    CHECK(point_of(sphere_of(isotropic_sphere(sphere))) == point_of(sphere));
    const auto x = blaschke_point(plane);
    CHECK(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] == Rational(1L));
  }
}

TEST_CASE("Planes that touch a sphere are the points of its images", "[minkowski]") {
  RandomRationals random(17);
  for (int i = 0; i < 10; ++i) {
    const Sphere sphere = sphere_of(random.vector());
    auto plane = random_plane(random);
    for (const bool contact : {false, true}) {
      if (contact) plane.c = minkowski(plane.w, point_of(sphere));
      const auto y = isotropic_point(plane);
      CHECK((isotropic_sphere(sphere)(y[0], y[1]) == y[2]) == contact);
      const auto x = blaschke_point(plane);
      const auto& m = sphere.centre;
      CHECK((x[3] + x[0] * m[0] + x[1] * m[1] + x[2] * m[2] + sphere.radius).is_zero() == contact);
      CHECK(in_contact(sphere, plane) == contact);
    }
  }
}

TEST_CASE("The isotropic model is that of the literature", "[minkowski]") {
  const auto& example = minkowski_cases()["isotropic_model"];
  RandomRationals random(18);
  std::map<std::string, Rational> at;
  for (const char* name : {"y1", "y2", "y3", "m1", "m2", "m3", "r", "a1", "a2", "a3", "dd"})
    at[name] = random();
  const std::array<Rational, 3> y = {at["y1"], at["y2"], at["y3"]};
  const auto plane = plane_of_isotropic_point(y);
  CHECK(plane_coordinates(plane) == values<4>(example["plane"], at));

  const Sphere sphere = {{at["m1"], at["m2"], at["m3"]}, at["r"]};
  CHECK(Rational(2L) * (y[2] - isotropic_sphere(sphere)(y[0], y[1])) ==
        value<Rational>(example["sphere"], at));

  // The translation adds a.n to e0, the dilatation d: both move against the model's sign.
  const auto moved = LaguerreMap::translation({-at["a1"], -at["a2"], -at["a3"], 0L})(plane);
  CHECK(isotropic_point(moved) == values<3>(example["translation"], at));
  const auto dilated = LaguerreMap::offset(-at["dd"])(plane);
  CHECK(isotropic_point(dilated) == values<3>(example["dilatation"], at));
}

TEST_CASE("The dual isotropic model bisects, and is that of the literature", "[minkowski]") {
  RandomRationals random(19);
  std::map<std::string, Rational> at;
  for (const char* name : {"y0", "y1", "y2", "y3"}) at[name] = random() + Rational(50L);
  const std::array<Rational, 4> y = {at["y0"], at["y1"], at["y2"], at["y3"]};
  const auto plane = plane_of_dual_isotropic_plane(y);
  const std::array<Rational, 4> e = {-plane.c, plane.w[0], plane.w[1], plane.w[2]};
  CHECK(proportional(e, values<4>(minkowski_cases()["dual_isotropic_model"]["plane"], at)));
  CHECK(minkowski(plane.w, plane.w).is_zero());

  // A point of y has the same signed distance from both planes.
  const Rational x1 = random(), x2 = random(), x3 = -(y[0] + y[1] * x1 + y[2] * x2) / y[3];
  const auto [e0, n1, n2, n3] = plane_coordinates(plane);
  CHECK(e0 + n1 * x1 + n2 * x2 + n3 * x3 == x3);
}

TEST_CASE("The pe circles of a Dupin cyclide are spheres in contact", "[minkowski]") {
  RandomRationals random(20);
  for (const auto& example : minkowski_cases()["dupin_cyclides"]) {
    std::map<std::string, Rational> at;
    for (const char* name : {"k", "l", "rho"}) at[name] = random() + Rational(50L);
    at["a"] = random();
    at["b"] = random() + Rational(70L);
    CHECK(
        in_contact(sphere_of(values<4>(example["C"], at)), sphere_of(values<4>(example["D"], at))));
    auto elsewhere = values<4>(example["D"], at);
    elsewhere[3] += Rational(1L);
    CHECK_FALSE(in_contact(sphere_of(values<4>(example["C"], at)), sphere_of(elsewhere)));
  }
}

TEST_CASE("A quadratic graph in the isotropic model is a parabolic Dupin cyclide", "[minkowski]") {
  const auto& example = minkowski_cases()["parabolic_dupin_cyclide"];
  RandomRationals random(21);
  std::map<std::string, Rational> at;
  for (const char* name : {"u", "v", "al", "be"}) at[name] = random();
  const auto plane = plane_of_isotropic_point(values<3>(example["graph"], at));
  const auto e = plane_coordinates(plane);
  CHECK(e == values<4>(example["plane"], at));
  const auto x = values<3>(example["point"], at);
  CHECK((e[0] + e[1] * x[0] + e[2] * x[1] + e[3] * x[2]).is_zero());
}
