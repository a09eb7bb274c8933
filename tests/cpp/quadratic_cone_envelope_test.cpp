// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/quadratic_cone_envelope.hpp"

#include <catch2/catch.hpp>

#include "cone_families.hpp"
#include "enclosures.hpp"
#include "error_code.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/conics/stereographic_projection.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Polynomial = RationalPolynomial;

Polynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

constexpr long kBits = 512;
/// What 512 bits leave of a zero.
constexpr double kTiny = 1e-60;

/// A matrix over Q[t] as polynomials in t and u.
std::array<HomogeneousCoordinates<RealBall>, 4> in_balls(const Matrix4OfPolynomials& m) {
  std::array<HomogeneousCoordinates<RealBall>, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      TensorPolynomial<RealBall> p(std::max(m[i][j].degree(), 0), 0);
      for (int d = 0; d <= m[i][j].degree(); ++d) p(d, 0) = RealBall(m[i][j].coefficient(d), kBits);
      result[i][j] = std::move(p);
    }
  }
  return result;
}

double largest(const HomogeneousCoordinates<RealBall>& x) {
  double size = 0;
  for (const auto& p : x) {
    for (const RealBall& c : p.coefficients()) size = std::max(size, c.magnitude_upper());
  }
  return size;
}

/// x y = 0 identically.
void check_incident(const HomogeneousCoordinates<RealBall>& x,
                    const HomogeneousCoordinates<RealBall>& y) {
  const double scale = kTiny * largest(x) * largest(y);
  const TensorPolynomial<RealBall> sum = contraction(x, y);
  for (const RealBall& c : sum.coefficients()) CHECK(encloses_zero(c, scale));
}

HomogeneousCoordinates<RealBall> derivative_of(const HomogeneousCoordinates<RealBall>& x,
                                               Variable variable) {
  return {x[0].derivative(variable), x[1].derivative(variable), x[2].derivative(variable),
          x[3].derivative(variable)};
}

/// The plane touches the surface of the points.
void check_tangency(const ContactElements<RealBall>& e) {
  check_incident(e.plane, e.point);
  check_incident(e.plane, derivative_of(e.point, Variable::kU));
  check_incident(e.plane, derivative_of(e.point, Variable::kV));
  // And so, dually, the point is where planes meet their neighbours.
  check_incident(derivative_of(e.plane, Variable::kU), e.point);
  check_incident(derivative_of(e.plane, Variable::kV), e.point);
}

/// Some coefficient of this power of t is not zero.
bool has_power(const HomogeneousCoordinates<RealBall>& x, int power) {
  for (const auto& p : x) {
    for (int j = 0; j <= p.degree(Variable::kV); ++j) {
      if (power <= p.degree(Variable::kU) && !p(power, j).contains_zero()) return true;
    }
  }
  return false;
}

/// The points form a surface: x, x_t and x_u are independent somewhere.
bool is_surface(const HomogeneousCoordinates<RealBall>& x) {
  const RealBall t(0.375), u(0.625);
  std::array<std::array<RealBall, 4>, 3> rows;
  for (std::size_t i = 0; i < 4; ++i) {
    rows[0][i] = x[i].at(t, u);
    rows[1][i] = x[i].derivative(Variable::kU).at(t, u);
    rows[2][i] = x[i].derivative(Variable::kV).at(t, u);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t a = (k + 1) % 4, b = (k + 2) % 4, c = (k + 3) % 4;
    const RealBall minor = rows[0][a] * (rows[1][b] * rows[2][c] - rows[1][c] * rows[2][b]) -
                           rows[0][b] * (rows[1][a] * rows[2][c] - rows[1][c] * rows[2][a]) +
                           rows[0][c] * (rows[1][a] * rows[2][b] - rows[1][b] * rows[2][a]);
    if (!minor.contains_zero()) return true;
  }
  return false;
}

/// Generators on the cones, cones that touch the surface along quartics, tangent planes.
void check_envelope(const QuadraticConeEnvelope& envelope) {
  const ContactElements<RealBall> e = envelope.contact_elements(kBits);
  const HomogeneousCoordinates<RealBall> z = envelope.generators(kBits);
  const auto c = in_balls(envelope.cones().matrix),
             slope = in_balls(derivative(envelope.cones().matrix));
  check_incident(z, polar_of(c, z));
  check_incident(e.point, polar_of(c, e.point));
  check_incident(e.point, polar_of(slope, e.point));
  check_incident(e.plane, z);
  for (const auto& row : in_balls({{envelope.cones().vertex, {}, {}, {}}})) {
    check_incident(e.plane, row);
  }
  check_tangency(e);
  CHECK(is_surface(e.point));
}

}  // namespace

TEST_CASE("Cones touch their envelope along quartics, and its degree is that of the theorem",
          "[quadratic_cone_envelope]") {
  RandomConics random(41);
  int odd = 0;
  for (const Vector3<int>& f :
       {Vector3<int>{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0, 0, 2}, {0, 1, 2}}) {
    const int h = f[0] + f[1] + f[2];
    for (int k = 2 * f[2]; k <= 2 * f[2] + 2; k += 2) {
      INFO("h = " << h << ", k = " << k);
      const QuadraticConeEnvelope envelope(quadratic_cones(random_cone_matrix(random, f, k)));
      const int n = envelope.generator_degree();
      CHECK(n >= k - h);
      CHECK(n <= k - h + 1);
      odd += n - (k - h);
      check_envelope(envelope);
      if (envelope.rational_contact_elements()) continue;
      CHECK(envelope.degree() == std::array<int, 2>{2 * n + h + k - 2, 4});
      CHECK(has_power(envelope.contact_elements(kBits).point, 2 * n + h + k - 2));
      CHECK(has_power(envelope.contact_elements(kBits).plane, n + k));
    }
  }
  INFO(odd << " of odd parity");
}

TEST_CASE("Cones of revolution that open along a parabola", "[quadratic_cone_envelope]") {
  // Vertices (t, 0, t^2), x^2 + y^2 = (1 + t^2) z^2.
  const Polynomial t = power_of_t(1);
  const QuadraticConeEnvelope envelope(
      quadratic_cones({t, 0L, t * t, 1L}, diagonal(1L, 1L, poly({-1, 0, -1}))));
  check_envelope(envelope);
}

TEST_CASE("Rational generators give points and planes over Q, exactly tangent",
          "[quadratic_cone_envelope]") {
  // x^2 + (1 + t^2)^2 y^2 = 2 t (t - 1) y z, with the vertex (t, 0, 0).
  const Polynomial t = power_of_t(1), zero, one(1L), c = poly({1, 0, 1});
  const Conic directions = {
      {{one, zero, zero}, {zero, c * c, -t * (t - one)}, {zero, -t * (t - one), zero}}};
  const QuadraticConeEnvelope envelope(quadratic_cones({t, zero, zero, one}, directions));
  check_envelope(envelope);
  const auto& exact = envelope.rational_contact_elements();
  REQUIRE(exact);
  const auto vanishes = [](const TensorPolynomial<Rational>& p) { return in_ring(p).is_zero(); };
  CHECK(vanishes(contraction(exact->point, exact->plane)));
  for (const Variable variable : {Variable::kU, Variable::kV}) {
    HomogeneousCoordinates<Rational> moved;
    for (std::size_t i = 0; i < 4; ++i) moved[i] = exact->point[i].derivative(variable);
    CHECK(vanishes(contraction(moved, exact->plane)));
  }
  // A common factor of the formula is gone: 2 n + h + k - 2 = 11.
  CHECK(envelope.generator_degree() == 4);
  CHECK(envelope.degree()[0] < 11);
}

TEST_CASE("Point and dual forms of a conic surface agree", "[quadratic_cone_envelope]") {
  // Ellipses in the normal planes of a parabola, by frame and conic.
  const Polynomial t = power_of_t(1), zero, one(1L);
  const MovingConic conic = {
      {{{t, t + t, zero}, {t * t, poly({-1}), zero}, {zero, zero, one}, {one, zero, zero}}},
      diagonal(-poly({1, 0, 1}), poly({2, 0, 1}), poly({5, -2, 1}))};
  const QuadraticConeEnvelope envelope(tangent_planes_of(conic));
  check_envelope(envelope);
  const ContactElements<RealBall> surface = dual(envelope.contact_elements(kBits));
  check_tangency(surface);
  CHECK(is_surface(surface.point));
  // The points x are those of the conic: x = frame y with y = (w, xi, eta).
  const auto& [x, y, z, w] = surface.point;
  const auto at = [](const TensorPolynomial<RealBall>& p) {
    return p.at(RealBall(0.25), RealBall(0.5));
  };
  const RealBall T(0.25), xi = (at(x) - at(w) * T) / (T + T), eta = at(z);
  CHECK((at(y) - at(w) * T * T + xi).contains_zero());
  const RealBall tt = T * T;
  CHECK((RealBall(-1L) * (RealBall(1L) + tt) * at(w) * at(w) + (RealBall(2L) + tt) * xi * xi +
         (RealBall(5L) - T - T + tt) * eta * eta)
            .contains_zero());
}

TEST_CASE("The tangent planes of the example of the dissertation", "[quadratic_cone_envelope]") {
  const QuadraticConeEnvelope envelope(quadratic_cones(conics_of_the_dissertation()));
  check_envelope(envelope);
}

TEST_CASE("Cones that envelop a curve are found exactly", "[quadratic_cone_envelope]") {
  const Polynomial t = power_of_t(1), zero, one(1L), minus = poly({-1});
  // Translated cones touch the curve at infinity only.
  const QuadraticCones translated =
      quadratic_cones({t, t * t, zero, one}, diagonal(one, one, minus));
  CHECK(envelops_curve(translated));
  CHECK_FALSE(is_surface(QuadraticConeEnvelope(translated).contact_elements(kBits).point));
  // Cones that join a circle with the points of a line: y z = t (...) in the plane z = 0.
  const QuadraticCones over_circle = quadratic_cones({{{one, zero, zero, zero},
                                                       {zero, one, -t, zero},
                                                       {zero, -t, t * t - one, one},
                                                       {zero, zero, one, minus}}});
  CHECK(envelops_curve(over_circle));
  // The same cones opening are surfaces.
  CHECK_FALSE(
      envelops_curve(quadratic_cones({t, t * t, zero, one}, diagonal(one + t * t, one, minus))));
  RandomConics random(43);
  CHECK_FALSE(envelops_curve(quadratic_cones(random_cone_matrix(random, {0, 1, 1}, 4))));
  // The tangent planes of a conic surface that is a cylinder: circles of one radius along z.
  const MovingConic circle = {
      {{{zero, one, zero}, {zero, zero, one}, {t, zero, zero}, {one, zero, zero}}},
      diagonal(minus, one, one)};
  CHECK(envelops_curve(quadratic_cones(tangent_planes_of(circle).matrix)));
}

TEST_CASE("A vertex at rest and cones without real generators are refused",
          "[quadratic_cone_envelope]") {
  const Polynomial t = power_of_t(1);
  const auto code = [](const Vector4OfPolynomials& v, const Conic& directions) {
    return code_of([&] { QuadraticConeEnvelope(quadratic_cones(v, directions)); });
  };
  CHECK(code({1L, 2L, 3L, 1L}, diagonal(poly({1, 0, 1}), 1L, poly({-1}))) ==
        ErrorCode::kZeroLength);
  CHECK(code({t, 2L, 3L, 1L}, diagonal(1L, 1L, 1L)) == ErrorCode::kNoRealPoints);
  CHECK(code({t, 2L, 3L, 1L}, diagonal(1L, 1L, poly({-2, 0, 1}))) == ErrorCode::kNoRealPoints);
}
