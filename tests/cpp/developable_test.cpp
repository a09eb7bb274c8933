// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/developable.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "surface_concept.hpp"

using namespace pn;
using namespace pn::test;

namespace {

RationalPolynomial polynomial(std::initializer_list<long> coefficients) {
  return RationalPolynomial(std::vector<Rational>(coefficients.begin(), coefficients.end()));
}

/// A quarter of an ellipse (a (1 - t^2), 2 b t) / (1 + t^2), in the plane of this height.
SphereCurve ellipse(long a, long b, long height) {
  const RationalPolynomial weight = polynomial({1, 0, 1});
  return {{polynomial({a, 0, -a}), polynomial({0, 2 * b}), RationalPolynomial(height) * weight},
          RationalPolynomial(0L),
          weight};
}

SphereCurve curve(const RationalPolynomial& x, const RationalPolynomial& y,
                  const RationalPolynomial& z) {
  return {{x, y, z}, RationalPolynomial(0L), RationalPolynomial(1L)};
}

std::array<SphereCurve, 2> parabolic_cylinder() {
  return {curve(polynomial({0, 1}), 0L, polynomial({0, 0, 1})),
          curve(polynomial({0, 1}), 3L, polynomial({0, 0, 1}))};
}

/// The strips of the theorem with their degrees of q.
std::vector<std::pair<std::array<SphereCurve, 2>, int>> rational_strips() {
  return {{{curve(polynomial({0, 1}), 0L, 0L), curve(polynomial({1, 2}), 1L, 0L)}, 0},
          {{ellipse(2, 2, 0), ellipse(2, 2, 5)}, 0},
          {{ellipse(4, 4, 0), ellipse(2, 2, 1)}, 0},
          {parabolic_cylinder(), 2}};
}

RationalPolynomial dot(const std::array<RationalPolynomial, 3>& a,
                       const std::array<RationalPolynomial, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

TEST_CASE("The normal is orthogonal to all tangents, its square splits", "[developable]") {
  for (const auto& [directrices, degree] : rational_strips()) {
    const auto strip = developable_strip(directrices);
    REQUIRE(strip);
    CHECK(strip->double_cover.degree() == degree);
    const RationalPolynomial& p = strip->root;
    CHECK(dot(strip->normal, strip->normal) ==
          RationalPolynomial(strip->factor) * strip->double_cover * p * p);
    for (const SphereCurve& c : directrices) {
      std::array<RationalPolynomial, 3> motion;
      for (std::size_t i = 0; i < 3; ++i) {
        motion[i] =
            c.centre[i].derivative() * c.denominator - c.centre[i] * c.denominator.derivative();
      }
      CHECK(dot(strip->normal, motion).is_zero());
    }
  }
}

TEST_CASE("Elliptic cylinders and cones have no rational offsets", "[developable]") {
  CHECK_FALSE(developable_strip({ellipse(3, 2, 0), ellipse(3, 2, 5)}));
  CHECK_FALSE(developable_strip({ellipse(3, 2, 0), ellipse(6, 4, 5)}));
  // A circle, but an oblique cone over it.
  SphereCurve moved = ellipse(1, 1, 4);
  moved.centre[0] += moved.denominator;
  CHECK_FALSE(developable_strip({ellipse(2, 2, 0), moved}));
}

TEST_CASE("A strip through an apex is refused", "[developable]") {
  CHECK_FALSE(developable_strip({ellipse(2, 2, 1), ellipse(-2, -2, -1)}));
}

TEST_CASE("Sections of a strip lie along unit normals over its rulings", "[developable]") {
  for (const auto& [directrices, degree] : rational_strips()) {
    const LocalForms forms = local_forms(*developable_strip(directrices), 256);
    CHECK(forms.is_substituted == (degree == 2));
    const auto surface = sections(forms.carrier, IsotropicVector<RealBall>{});
    for (const double t : {0.0, 0.25, 0.625, 1.0}) {
      for (const double v : {0.0, 0.5, 1.0}) {
        check_identities(surface, RealBall(t), RealBall(1 - v), RealBall(v));
      }
    }
    // Neighbours meet with the same weights: those of the normal are 1 at both ends.
    const auto& strip = std::get<DevelopableForms<RealBall>>(forms.carrier);
    for (const long end : {0L, 1L}) {
      CHECK(encloses_zero(strip.length(RealBall(end)) - RealBall(1), kNarrow));
    }
  }
}

TEST_CASE("The substituted parameter runs from end to end", "[developable]") {
  const LocalForms forms = local_forms(*developable_strip(parabolic_cylinder()), 256);
  const auto& directrix = std::get<DevelopableForms<RealBall>>(forms.carrier).directrices[0];
  for (const long end : {0L, 1L}) {
    const RealBall at(end);
    CHECK(encloses_zero(directrix.centre[0](at) / directrix.denominator(at) - at, kNarrow));
    CHECK(encloses_zero(directrix.centre[2](at) / directrix.denominator(at) - at, kNarrow));
  }
}
