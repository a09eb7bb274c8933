// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/moving_conic.hpp"

#include <catch2/catch.hpp>

#include "cone_families.hpp"
#include "error_code.hpp"
#include "pn/conics/interval_substitution.hpp"
#include "pn/conics/rational_conic_family.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Matrix4 = Matrix4OfPolynomials;

RationalPolynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

Vector3<int> degrees(const std::array<Vector3<RationalPolynomial>, 4>& frame) {
  return family_of({frame, diagonal(1L, 1L, -poly({1}))}).degree;
}

}  // namespace

TEST_CASE("A basis of a plane lies in it, spans it everywhere and has its degree",
          "[moving_conic]") {
  RandomConics random(5);
  for (int degree = 0; degree <= 4; ++degree) {
    for (int repeat = 0; repeat < 5; ++repeat) {
      const Vector4OfPolynomials g = {random.any(degree), random.any(degree), random.any(degree),
                                      poly({1}) + power_of_t(degree)};
      RationalPolynomial common;
      int highest = 0;
      for (const auto& x : g) {
        common = gcd(common, x);
        highest = std::max(highest, x.degree());
      }
      if (common.degree() > 0) continue;
      const auto basis = plane_basis(g);
      for (std::size_t j = 0; j < 3; ++j) {
        RationalPolynomial incidence;
        for (std::size_t i = 0; i < 4; ++i) incidence += g[i] * basis[i][j];
        CHECK(incidence.is_zero());
      }
      const Vector3<int> f = degrees(basis);
      CHECK(f[0] + f[1] + f[2] == highest);
      // The minors are the coordinates of the plane, up to a constant.
      const RationalPolynomial minor = determinant({basis[0], basis[1], basis[2]});
      CHECK(minor.degree() == g[3].degree());
      CHECK(remainder(minor, g[3]).is_zero());
    }
  }
}

TEST_CASE("Points of conics given by their tangent planes", "[moving_conic]") {
  // The circle x^2 + y^2 = 4 in z = 0 is touched by e4^2 = 4 (e1^2 + e2^2); z = t moves it.
  const RationalPolynomial t = poly({0, 1}), zero;
  const Matrix4 circle = {{{4L, 0L, 0L, 0L}, {0L, 4L, 0L, 0L}, {}, {0L, 0L, 0L, -poly({1})}}};
  const Matrix4 back = {
      {{1L, 0L, 0L, 0L}, {0L, 1L, 0L, 0L}, {0L, 0L, 1L, 0L}, {zero, zero, t, 1L}}};
  const MovingConic conic = conic_of_tangent_planes(congruent(circle, back));
  const RationalConicFamily points(family_of(conic));
  CHECK(points.least_degree() == 1);
  const QuadraticPoints y = points.points(128);
  const RealBall at(3L), u0(2L), u1(5L);
  std::array<RealBall, 4> x;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < 3; ++i) {
      const RealBall b(conic.frame[c][i](Rational(3)), 128);
      x[c] += b * (y.coordinate[i][0](at) * u0 * u0 + y.coordinate[i][1](at) * u0 * u1 +
                   y.coordinate[i][2](at) * u1 * u1);
    }
  }
  CHECK((x[2] / x[3] - at).contains_zero());
  CHECK((x[0] * x[0] + x[1] * x[1] - RealBall(4L) * x[3] * x[3]).contains_zero());
  CHECK(x[3].magnitude_upper() > 0);
}

TEST_CASE("The example of the dissertation has degree (4, 2)", "[moving_conic]") {
  const ConicFamily family = family_of(conic_of_tangent_planes(conics_of_the_dissertation()));
  const RationalConicFamily points(family);
  CHECK(points.least_degree() == 4);
  CHECK(points.degree() == 4);
}

TEST_CASE("Matrices that are no tangent planes of conics are refused", "[moving_conic]") {
  Matrix4 d = {{{1L, 0L, 0L, 0L}, {0L, 1L, 0L, 0L}, {}, {}}};
  CHECK(code_of([&] { conic_of_tangent_planes(d); }) == ErrorCode::kSingularConics);
  d[2][2] = d[3][3] = RationalPolynomial(1L);
  CHECK(code_of([&] { conic_of_tangent_planes(d); }) == ErrorCode::kWrongShape);
  d[3][3] = d[0][1] = RationalPolynomial();
  d[1][0] = RationalPolynomial(1L);
  CHECK(code_of([&] { conic_of_tangent_planes(d); }) == ErrorCode::kWrongShape);
}
