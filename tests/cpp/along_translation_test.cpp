// SPDX-License-Identifier: LGPL-2.1-or-later
// Identities over Q, for circles that have rational points: those of a parabola in the plane with
// constant radius, c = (u, u^2 / 2, 0), D = 1 + u^2.
#include "pn/isotropic/along_translation.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "random_translational_families.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Polynomial = TensorPolynomial<Rational>;

Polynomial constant(long x) { return Polynomial::constant(Rational(x)); }

bool is_zero(const Polynomial& p) {
  return std::all_of(p.coefficients().begin(), p.coefficients().end(),
                     [](const Rational& c) { return c.is_zero(); });
}

/// The spinor (1, i (1 + i u) s): normals orthogonal to (1, u, 0).
IsotropicPolynomials<Rational> circles() {
  const Polynomial u = Polynomial::linear(0L, 1L, 0L), s = Polynomial::linear(0L, 0L, 1L);
  return isotropic_polynomials(
      SpinorPolynomials<Rational>{{constant(1), u * s * Rational(-1L)}, {constant(0), s}});
}

TranslatedCurve<Rational> curve() {
  Polynomial u = Polynomial::linear(0L, 1L, 0L);
  const Rational half = Rational(1L) / Rational(2L);
  return {{u, u * u * half, constant(0), constant(-3)}, constant(1)};
}

TranslatingParabola<Rational> random_parabola(std::mt19937_64& random) {
  const auto vector = [&] {
    const auto number = [&] {
      return Rational(static_cast<long>(random() % 41) - 20) /
             Rational(static_cast<long>(1 + random() % 7));
    };
    return MinkowskiVector<Rational>{number(), number(), number(), number()};
  };
  return {vector(), vector(), vector()};
}

}  // namespace

TEST_CASE("The normals are those of the circles", "[along_translation]") {
  const auto w = circles();
  CHECK(is_zero(w[0] * w[0] + w[1] * w[1] + w[2] * w[2] - w[3] * w[3]));
  CHECK(is_zero(w[0] + w[1] * Polynomial::linear(0L, 1L, 0L)));
}

TEST_CASE("The direction is a unit normal of every section, as polynomials",
          "[along_translation]") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 10; ++i) {
    const SurfaceSections<Rational> x = sections(curve(), random_parabola(random), circles());
    Polynomial square;
    for (const Polynomial& n : x.direction) square += n * n;
    CHECK(is_zero(square - x.weight * x.weight));
    for (const Variable variable : {Variable::kU, Variable::kV}) {
      for (const long d : {0L, 2L}) {
        Polynomial along;
        for (std::size_t c = 0; c < 3; ++c) {
          const Polynomial moved = x.point[c] + x.direction[c] * Rational(d);
          along += x.direction[c] *
                   (moved.derivative(variable) * x.weight - moved * x.weight.derivative(variable));
        }
        CHECK(is_zero(along));
      }
    }
  }
}

TEST_CASE("Every point lies on its sphere, at its contact", "[along_translation]") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20; ++i) {
    const TranslatingParabola<Rational> d = random_parabola(random);
    const auto w = circles();
    const SurfaceSections<Rational> x = sections(curve(), d, w);
    const Rational u = Rational(static_cast<long>(random() % 19)) / Rational(7L),
                   s = Rational(static_cast<long>(random() % 23) - 11) / Rational(5L);
    MinkowskiVector<Rational> at;
    for (std::size_t c = 0; c < 4; ++c) at[c] = w[c].at(u, s);
    const Rational q = minkowski(at, d.second);
    if (q.is_zero()) continue;
    const Rational v = -minkowski(at, d.first) / q;
    const auto sphere = [&](std::size_t c) {
      return curve().numerator[c].at(u, s) + d.second[c] * v * v / Rational(2L) + d.first[c] * v +
             d.start[c];
    };
    const Rational weight = x.weight.at(u, s), r = -sphere(3);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(x.point[c].at(u, s) / weight == sphere(c) + r * at[c] / at[3]);
    }
  }
}

TEST_CASE("Sections of two parabolas have the bidegree (8, 6)", "[along_translation]") {
  std::mt19937_64 random(11);
  const SurfaceSections<Rational> x = sections(curve(), random_parabola(random), circles());
  // Not only formally: without a common factor.
  BivariatePolynomial common = in_ring(x.weight);
  int along = 0, around = 0;
  for (const Polynomial& p : x.point) {
    along = std::max(along, in_ring(p).degree(Variable::kU));
    around = std::max(around, in_ring(p).degree(Variable::kV));
    common = gcd(common, in_ring(p));
  }
  CHECK(along == 8);
  CHECK(around == 6);
  CHECK(common.degree(Variable::kU) == 0);
  CHECK(common.degree(Variable::kV) == 0);
}
