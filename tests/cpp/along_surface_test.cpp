// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/along_surface.hpp"

#include <catch2/catch.hpp>

#include "random_sphere_families.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Polynomial = TensorPolynomial<Rational>;

bool is_zero(const Polynomial& p) {
  for (const Rational& c : p.coefficients()) {
    if (!c.is_zero()) return false;
  }
  return true;
}

/// A spinor (1, s + i t) turned and moved by small integers.
IsotropicPolynomials<Rational> turned_sphere(std::mt19937_64& random) {
  const auto number = [&] { return Rational(static_cast<long>(random() % 19) - 9); };
  const auto linear = [&] { return Polynomial::linear(number(), number(), number()); };
  return isotropic_polynomials(
      SpinorPolynomials<Rational>{{linear(), linear()}, {linear(), linear()}});
}

}  // namespace

TEST_CASE("w is isotropic and the contact solves both equations, as polynomials",
          "[along_surface]") {
  std::mt19937_64 random(7);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const QuadraticFamily family = family_of(RandomSphereFamily(seed).spheres());
    const auto w = turned_sphere(random);
    CHECK(is_zero(pn::minkowski(w, w)));
    const PowerForm<Rational> f = family.power();
    const auto [a, b, e] = contact_of(f, w);
    const auto q = [&](std::size_t i) { return pn::minkowski(w, f[i]); };
    CHECK(is_zero(q(0) * a + q(1) * b + q(3) * e));
    CHECK(is_zero(q(1) * a + q(2) * b + q(4) * e));
    CHECK_FALSE(is_zero(e));
  }
}

TEST_CASE("Sections touch the spheres of the family, exactly, and so do their offsets",
          "[along_surface]") {
  std::mt19937_64 random(11);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const QuadraticFamily family = family_of(RandomSphereFamily(seed).spheres());
    const auto w = turned_sphere(random);
    const IntegerPowerForm f = integer_power_form(family);
    const Contact<Rational> contact = contact_of(f.form, w);
    const SurfaceSections<Rational> x = scaled_sections(f, w, contact);
    for (int trial = 0; trial < 3; ++trial) {
      const auto number = [&] {
        return Rational(static_cast<long>(random() % 41) - 20) / Rational(7L);
      };
      const Rational s = number(), t = number(), d = number();
      const Rational e = contact.e.at(s, t), weight = x.weight.at(s, t);
      if (e.is_zero() || weight.is_zero()) continue;
      const SphereJet sphere = jet(family, contact.a.at(s, t) / e, contact.b.at(s, t) / e);
      const Rational r = -sphere.value[3];
      Rational square, square_of_offset, along_u = -(sphere.by_u[3] * r),
                                         along_v = -(sphere.by_v[3] * r);
      for (std::size_t i = 0; i < 3; ++i) {
        const Rational from = x.point[i].at(s, t) / weight - sphere.value[i];
        const Rational moved = from + d * x.direction[i].at(s, t) / weight;
        square += from * from;
        square_of_offset += moved * moved;
        along_u += from * sphere.by_u[i];
        along_v += from * sphere.by_v[i];
      }
      CHECK(square == r * r);
      CHECK(square_of_offset == (r + d) * (r + d));
      CHECK(along_u.is_zero());
      CHECK(along_v.is_zero());
    }
  }
}

TEST_CASE("The direction is a unit normal of the section, as polynomials", "[along_surface]") {
  std::mt19937_64 random(13);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const QuadraticFamily family = family_of(RandomSphereFamily(seed).spheres());
    const auto w = turned_sphere(random);
    const IntegerPowerForm f = integer_power_form(family);
    const SurfaceSections<Rational> x = scaled_sections(f, w, contact_of(f.form, w));
    Polynomial square;
    for (const Polynomial& n : x.direction) square += n * n;
    CHECK(is_zero(square - x.weight * x.weight));
    for (const Variable variable : {Variable::kU, Variable::kV}) {
      Polynomial along;
      for (std::size_t i = 0; i < 3; ++i) {
        along += x.direction[i] * (x.point[i].derivative(variable) * x.weight -
                                   x.point[i] * x.weight.derivative(variable));
      }
      CHECK(is_zero(along));
    }
  }
}

TEST_CASE("Common factors are cancelled: a height field with constant radius is of degree 6",
          "[along_surface]") {
  // m = (u, v, quadratic): a1, a2, a3 are multiples of (0, 0, 1, 0).
  const QuadraticFamily family = family_of({{{2, 0, 1, 0.25},
                                             {1, 1, -1, 0.25},
                                             {0, 2, 2, 0.25},
                                             {1, 0, 0, 0.25},
                                             {0, 1, 0, 0.25},
                                             {0, 0, 0, 0.25}}});
  std::mt19937_64 random(3);
  const auto w = turned_sphere(random);
  const IntegerPowerForm f = integer_power_form(family);
  const Contact<Rational> contact = contact_of(f.form, w);
  const SurfaceSections<Rational> x =
      without_common_factor(scaled_sections(f, w, contact), contact.e);
  CHECK(x.weight.degree(Variable::kU) == 6);
  CHECK(x.weight.degree(Variable::kV) == 6);
  for (const Polynomial& p : x.point) {
    CHECK(p.degree(Variable::kU) <= 6);
    CHECK(p.degree(Variable::kV) <= 6);
  }
  const auto general = family_of(RandomSphereFamily(1).spheres());
  const IntegerPowerForm g = integer_power_form(general);
  const Contact<Rational> other = contact_of(g.form, w);
  const auto full = without_common_factor(scaled_sections(g, w, other), other.e);
  CHECK(full.weight.degree(Variable::kU) == 10);
}
