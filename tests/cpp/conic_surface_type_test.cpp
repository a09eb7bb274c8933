// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/conic_surface_type.hpp"

#include <catch2/catch.hpp>

#include "cone_families.hpp"
#include "pn/conics/stereographic_projection.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Polynomial = RationalPolynomial;

Polynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

/// The conic x^T M x = 0 of the plane z = t, or of another frame.
QuadraticCones planes_of(const Conic& conic, const std::array<Vector3<Polynomial>, 4>& frame) {
  return tangent_planes_of({frame, conic});
}

/// Planes through the x-axis at z = 0, turning: y cos = z sin, by t = tan; coordinates (1, x, y').
const std::array<Vector3<Polynomial>, 4> kTurning = {
    {{0L, 1L, 0L}, {0L, 0L, 1L}, {0L, 0L, power_of_t(1)}, {1L, 0L, 0L}}};

}  // namespace

TEST_CASE("Conics in planes through an axis: their real points on it", "[conic_surface_type]") {
  // Circles of radius 1 around (0, m) in the coordinates (x, y'): the axis y' = 0 is met for |m| <
  // 1.
  const auto circle = [](const Polynomial& m) -> Conic {
    const Polynomial zero;
    return {{{m * m - 1L, zero, -m}, {zero, 1L, zero}, {-m, zero, 1L}}};
  };
  const Rational at(3L);
  CHECK(conic_type(planes_of(circle(2L), kTurning), at) == ConicType::kElliptic);
  CHECK(conic_type(planes_of(circle(1L), kTurning), at) == ConicType::kParabolic);
  CHECK(conic_type(planes_of(circle(Polynomial()), kTurning), at) == ConicType::kHyperbolic);
  // With m = t the type changes at t = 1.
  const QuadraticCones changing = planes_of(circle(power_of_t(1)), kTurning);
  CHECK(conic_type(changing, Rational(2L)) == ConicType::kElliptic);
  CHECK(conic_type(changing, Rational(1L)) == ConicType::kParabolic);
  CHECK(conic_type(changing, Rational(0L)) == ConicType::kHyperbolic);
}

TEST_CASE("Cones with a vertex that moves inside, on and outside of them", "[conic_surface_type]") {
  const auto moving = [](const Vector3<Polynomial>& v) {
    return quadratic_cones({v[0], v[1], v[2], 1L}, diagonal(1L, 1L, poly({-1})));
  };
  const Polynomial t = power_of_t(1);
  CHECK(conic_type(moving({0L, 0L, t}), Rational(5L)) == ConicType::kElliptic);
  CHECK(conic_type(moving({t, 0L, t}), Rational(5L)) == ConicType::kParabolic);
  CHECK(conic_type(moving({t, 0L, 0L}), Rational(5L)) == ConicType::kHyperbolic);
  // A vertex at rest has no tangent.
  CHECK_FALSE(conic_type(moving({t * t, 0L, 0L}), Rational(0L)).has_value());
}

TEST_CASE("The identities of the tangent of singular quadrics", "[conic_surface_type]") {
  RandomConics random(21);
  for (int repeat = 0; repeat < 5; ++repeat) {
    const QuadraticCones cones = quadratic_cones(random_cone_matrix(random, {0, 1, 1}, 4));
    const Matrix4OfPolynomials slope = derivative(cones.matrix);
    const Vector4OfPolynomials &v = cones.vertex, moved = derivative(v);
    CHECK(polar_form(slope, v, v).is_zero());  // (1.6), (2.4), (3.2), (5.2)
    const Vector4OfPolynomials p = polar_of(slope, v), minus_p = polar_of(cones.matrix, moved);
    for (std::size_t i = 0; i < 4; ++i)
      CHECK((p[i] + minus_p[i]).is_zero());  // (1.8), (2.6), (3.3)
    CHECK((polar_form(derivative(slope), v, v) + Polynomial(2L) * contraction(p, moved)).is_zero());
    CHECK_FALSE(polar_form(derivative(slope), v, v).is_zero());  // so (1.6) as printed is wrong
    // a is minus the discriminant of the type times the square of a constant.
    const Polynomial a = tangent_pencil(cones)[0], discriminant = type_discriminant(cones);
    REQUIRE(a.degree() == discriminant.degree());
    const Rational ratio = a.coefficient(a.degree()) / discriminant.coefficient(a.degree());
    CHECK(a == discriminant * Polynomial(ratio));
    CHECK(square_root(-ratio).has_value());
    CHECK(thomsen_class(cones) == ThomsenClass::kA);
  }
}

TEST_CASE("Thomsen's classes by the zeros of det(lambda C + mu C')", "[conic_surface_type]") {
  // Vertices t w and the directions K + t N with K = diag(1, 1, -1): at t = 0 the determinant is
  // -mu^2 (K w)^T adj(lambda K + mu N) (K w).
  struct Expected {
    std::array<long, 3> w;
    std::array<std::array<long, 3>, 3> n;
    ThomsenClass thomsen_class;
  };
  const Expected table[] = {
      {{0, 0, 1}, {{{1, 0, 0}, {0, 2, 0}, {0, 0, 0}}}, ThomsenClass::kA},
      {{1, 0, 0}, {{{0, 0, 0}, {0, 1, 3}, {0, 3, 0}}}, ThomsenClass::kA},
      {{1, 0, 0}, {{{5, 1, 0}, {1, 2, 1}, {0, 1, 0}}}, ThomsenClass::kB},
      {{0, 0, 1}, {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, ThomsenClass::kC},
      {{0, 0, 1}, {{{3, 0, 1}, {0, 3, 2}, {1, 2, 7}}}, ThomsenClass::kC},
      {{1, 0, 0}, {{{4, 0, 0}, {0, 1, 0}, {0, 0, -1}}}, ThomsenClass::kC},
      {{1, 0, 1}, {{{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, ThomsenClass::kD},
      {{1, 0, 1}, {{{0, 1, 0}, {1, 0, 0}, {0, 0, 0}}}, ThomsenClass::kE},
      {{1, 0, 1}, {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, ThomsenClass::kF},
      {{1, 0, 1}, {{{1, 2, 3}, {2, 5, -2}, {3, -2, -7}}}, ThomsenClass::kF},
  };
  for (const Expected& row : table) {
    Conic directions = diagonal(1L, 1L, poly({-1}));
    Vector4OfPolynomials vertex = {Polynomial(), Polynomial(), Polynomial(), 1L};
    for (std::size_t i = 0; i < 3; ++i) {
      vertex[i] = poly({0, row.w[i]});
      for (std::size_t j = 0; j < 3; ++j) directions[i][j] += poly({0, row.n[i][j]});
    }
    const QuadraticCones cones = quadratic_cones(vertex, directions);
    CHECK(thomsen_class(cones, Rational(0L)) == row.thomsen_class);
    const bool is_parabolic = row.thomsen_class >= ThomsenClass::kD;
    CHECK((conic_type(cones, Rational(0L)) == ConicType::kParabolic) == is_parabolic);
  }
}

TEST_CASE("Classes of all conics of a family", "[conic_surface_type]") {
  const Polynomial t = power_of_t(1), one(1L), zero;
  const Conic revolution = diagonal(1L, 1L, poly({-1}));
  // Translated cones: C' is a pair of planes, the plane at infinity and a polar one.
  CHECK(thomsen_class(quadratic_cones({zero, zero, t, one}, revolution)) == ThomsenClass::kC);
  CHECK(thomsen_class(quadratic_cones({t, zero, t, one}, revolution)) == ThomsenClass::kF);
  // Cones that are translated and open: of class A but at t = 0.
  const QuadraticCones opening =
      quadratic_cones({zero, zero, t, one}, diagonal(one + t * t, one, poly({-1})));
  CHECK(thomsen_class(opening) == ThomsenClass::kA);
  CHECK(thomsen_class(opening, Rational(0L)) == ThomsenClass::kC);
  CHECK(thomsen_class(quadratic_cones(conics_of_the_dissertation())).has_value());
  // The conics of contact of translated cones are at infinity.
  const auto plane = contact_plane(quadratic_cones({zero, zero, t, one}, revolution));
  REQUIRE(plane);
  CHECK(((*plane)[0].is_zero() && (*plane)[1].is_zero() && (*plane)[2].is_zero()));
  CHECK_FALSE(contact_plane(opening));
  // A fixed vertex or plane has none.
  const QuadraticCones fixed = quadratic_cones({0L, 0L, 0L, 1L}, diagonal(one + t, 1L, poly({-1})));
  CHECK_FALSE(thomsen_class(fixed).has_value());
  CHECK_FALSE(thomsen_class(fixed, Rational(1L)).has_value());
}
