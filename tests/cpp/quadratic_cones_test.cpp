// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/quadratic_cones.hpp"

#include <catch2/catch.hpp>

#include "cone_families.hpp"
#include "error_code.hpp"
#include "pn/conics/rational_conic_family.hpp"
#include "pn/conics/stereographic_projection.hpp"

using namespace pn;
using namespace pn::test;

namespace {

RationalPolynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

/// The degrees of the reduction are those of the theorem, and it gives the matrix back.
void check_reduction(const QuadraticCones& cones) {
  CHECK(cone_matrix(cones.planes, cones.conic) == cones.matrix);
  const Vector4OfPolynomials zero{};
  CHECK(polar_of(cones.matrix, cones.vertex) == zero);
  int sum = 0;
  const ConicFamily family = family_of(cones);
  for (std::size_t i = 0; i < 3; ++i) {
    sum -= family.degree[i];
    for (std::size_t j = 0; j < 3; ++j) {
      RationalPolynomial one;
      for (std::size_t c = 0; c < 4; ++c) one += cones.planes[c][i] * cones.inverse[c][j];
      CHECK(one == RationalPolynomial(i == j ? 1L : 0L));
      CHECK(cones.conic[i][j].degree() <= cones.degree() + family.degree[i] + family.degree[j]);
    }
  }
  CHECK(sum == cones.vertex_degree());
  CHECK(family.twist == cones.degree());
}

}  // namespace

TEST_CASE("Cones of rank 3 are conics in the bundles of their vertices", "[quadratic_cones]") {
  RandomConics random(11);
  for (const Vector3<int>& f :
       {Vector3<int>{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0, 0, 2}, {0, 1, 2}}) {
    for (int k = 2 * f[2]; k <= 2 * f[2] + 2; k += 2) {
      const QuadraticCones cones = quadratic_cones(random_cone_matrix(random, f, k));
      check_reduction(cones);
      CHECK(cones.vertex_degree() == f[0] + f[1] + f[2]);
      CHECK(cones.degree() == k);
    }
  }
}

TEST_CASE("Common factors of the cones are removed", "[quadratic_cones]") {
  RandomConics random(12);
  const Matrix4OfPolynomials c = random_cone_matrix(random, {0, 1, 1}, 2);
  Matrix4OfPolynomials multiple = c;
  for (auto& row : multiple) {
    for (auto& x : row) x *= poly({1, 0, 1}) * poly({-3, 1});
  }
  CHECK(quadratic_cones(multiple).matrix == quadratic_cones(c).matrix);
  check_reduction(quadratic_cones(multiple));
}

TEST_CASE("Cones by their vertices and their conics at infinity", "[quadratic_cones]") {
  // Vertices (t, t^2, t^3), cones of revolution about z with the slope 1.
  const RationalPolynomial t = poly({0, 1});
  const QuadraticCones cones =
      quadratic_cones({t, t * t, t * t * t, 1L}, diagonal(1L, 1L, poly({-1})));
  check_reduction(cones);
  const Vector4OfPolynomials given = {t, t * t, t * t * t, 1L};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(cones.vertex[i] == given[i] * cones.vertex[3]);
  }
  const Rational at(2L);
  const auto value = [&](long x, long y, long z) {
    const Vector4OfPolynomials point = {x, y, z, 1L};
    return polar_form(cones.matrix, point, point)(at);
  };
  CHECK(value(2 + 3, 4 + 4, 8 + 5).is_zero());
  CHECK(value(2 + 3, 4 + 4, 8 - 5).is_zero());
  CHECK_FALSE(value(2 + 3, 4 + 4, 8 + 6).is_zero());
}

TEST_CASE("The planes that touch a moving conic lead back to it", "[quadratic_cones]") {
  RandomConics random(13);
  MovingConic conic;
  for (auto& row : conic.frame) {
    for (auto& x : row) x = random.any(1);
  }
  conic.conic = diagonal(random.positive(1), 1L, -random.positive(1));
  const QuadraticCones planes = tangent_planes_of(conic);
  check_reduction(planes);
  // The same points, by a basis of least degrees.
  const MovingConic back = conic_of_tangent_planes(planes.matrix);
  CHECK(RationalConicFamily(family_of(back)).least_degree() <=
        RationalConicFamily(family_of(conic)).least_degree());
  for (std::size_t j = 0; j < 3; ++j) {
    RationalPolynomial incidence;
    for (std::size_t i = 0; i < 4; ++i) incidence += planes.vertex[i] * conic.frame[i][j];
    CHECK(incidence.is_zero());
  }
}

TEST_CASE("Matrices that are no cones are refused", "[quadratic_cones]") {
  Matrix4OfPolynomials c = {{{1L, 0L, 0L, 0L}, {0L, 1L, 0L, 0L}, {}, {}}};
  CHECK(code_of([&] { quadratic_cones(c); }) == ErrorCode::kSingularConics);
  c[2][2] = c[3][3] = RationalPolynomial(1L);
  CHECK(code_of([&] { quadratic_cones(c); }) == ErrorCode::kWrongShape);
  c[3][3] = c[0][1] = RationalPolynomial();
  c[1][0] = RationalPolynomial(1L);
  CHECK(code_of([&] { quadratic_cones(c); }) == ErrorCode::kWrongShape);
}
