// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/translational_form.hpp"

#include <catch2/catch.hpp>

#include "special_sphere_families.hpp"

using namespace pn;
using namespace pn::test;

namespace {

Rational at(const std::array<Rational, 3>& linear, const Rational& u, const Rational& v) {
  return linear[0] + linear[1] * u + linear[2] * v;
}

MinkowskiVector<Rational> at(const SphereParabola& c, const Rational& t) {
  return c.part(t, 1L).start;
}

/// f(u, v) = c(p) + d(q), with the triangle in the unit square, and the same sense.
void check_form(const QuadraticFamily& family) {
  const auto form = translational_form(family);
  REQUIRE(form);
  const auto& [p, q] = form->parameters;
  CHECK((p[1] * q[2] - p[2] * q[1]).sign() > 0);
  const Rational zero, one(1L), third = one / Rational(3L);
  for (const auto& [u, v] : {std::array{zero, zero}, {one, zero}, {zero, one}, {third, third}}) {
    const Rational at_p = at(p, u, v), at_q = at(q, u, v);
    for (const Rational& x : {at_p, at_q}) CHECK((!(x < zero) && !(x > one)));
    const auto expected = jet(family, u, v).value, c = at(form->family.c, at_p),
               d = at(form->family.d, at_q);
    for (std::size_t i = 0; i < 4; ++i) CHECK(c[i] + d[i] == expected[i]);
    const auto place = form->at({u.to_double(), v.to_double()});
    CHECK(place[0] == Approx(at_p.to_double()));
    CHECK(place[1] == Approx(at_q.to_double()));
  }
}

bool is_line(const SphereParabola& c) {
  return std::all_of(c.second.begin(), c.second.end(),
                     [](const Rational& x) { return x.is_zero(); });
}

/// f of two parabolas along p = a u + b v and q = c u + d v.
QuadraticFamily in_directions(double a, double b, double c, double d) {
  return family_of(spheres_of([=](double u, double v) {
    const double p = a * u + b * v, q = c * u + d * v;
    return std::array{64 * u + p * p, 64 * v - q * q, 8 * p * p + 4 * q * q, 4 + p * p / 2};
  }));
}

}  // namespace

TEST_CASE("Families of two parabolas are found in their own parameters", "[translational_form]") {
  check_form(in_directions(1, 0, 0, 1));
  check_form(in_directions(0, 1, 1, 0));
  check_form(in_directions(1, 0.5, -0.25, 1));
  check_form(in_directions(1, 1, 1, -1));
  check_form(in_directions(0.5, -1, 0, 2));
}

TEST_CASE("Parabolic cylinders are found with their rulings", "[translational_form]") {
  for (const auto& [name, spheres] : developable_spheres()) {
    INFO(name);
    const QuadraticFamily family = family_of(spheres);
    check_form(family);
    const auto form = translational_form(family);
    CHECK(is_line(form->family.c) != is_line(form->family.d));
  }
}

TEST_CASE("Other families have no translational form over Q", "[translational_form]") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    CHECK_FALSE(translational_form(family_of(RandomSphereFamily(seed).spheres())));
  }
  // Harmonic second derivatives: the directions are imaginary.
  CHECK_FALSE(translational_form(family_of(spheres_of([](double u, double v) {
    return std::array{64 * u + u * u - v * v, 64 * v + 2 * u * v, 0.0, 4.0};
  }))));
  // One direction only: B^2 = 4 A C.
  CHECK_FALSE(translational_form(family_of(spheres_of([](double u, double v) {
    return std::array{64 * u + u * u, 64 * v + 2 * u * v, 0.0, 4.0};
  }))));
  // p^2 - 2 q^2 and p q: the directions are irrational.
  CHECK_FALSE(translational_form(family_of(spheres_of([](double u, double v) {
    return std::array{64 * u + u * u + 2 * v * v, 64 * v + 2 * u * v, 0.0, 4.0};
  }))));
  // Multiples of one vector, not a square.
  CHECK_FALSE(translational_form(family_of(spheres_of([](double u, double v) {
    return std::array{64 * u, 64 * v, 8 * u * v, 4.0};
  }))));
  CHECK_FALSE(translational_form(family_of(spheres_of([](double u, double v) {
    return std::array{64 * u, 64 * v, 0.0, 4.0};
  }))));
}
