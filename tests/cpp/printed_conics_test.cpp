// SPDX-License-Identifier: LGPL-2.1-or-later
// The examples and formulas of conic surfaces and cones that are printed in the literature.
//
// data/conics.json has them with their source, and with misprints corrected; what is printed
// wrongly is there too and must fail.
#include <catch2/catch.hpp>

#include "cone_families.hpp"
#include "enclosures.hpp"
#include "error_code.hpp"
#include "expression.hpp"
#include "pn/algebra/rational_function.hpp"
#include "pn/conics/conic_surface_type.hpp"
#include "pn/conics/polar_frame.hpp"
#include "pn/conics/quadratic_cone_envelope.hpp"
#include "pn/conics/stereographic_projection.hpp"
#include "test_data.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using nlohmann::json;
using Polynomial = RationalPolynomial;

const json& conic_cases() {
  static const json cases = test_data("conics.json");
  return cases;
}

const std::map<std::string, Polynomial>& in_t() {
  static const std::map<std::string, Polynomial> names = {{"t", power_of_t(1)}};
  return names;
}

template <std::size_t N>
std::array<Polynomial, N> vector_of(const json& texts) {
  return values<N>(texts, in_t());
}

template <std::size_t Rows>
std::array<std::array<Polynomial, Rows>, Rows> matrix_of(const json& texts) {
  std::array<std::array<Polynomial, Rows>, Rows> result;
  for (std::size_t i = 0; i < Rows; ++i) result[i] = vector_of<Rows>(texts[i]);
  return result;
}

/// The same point: all 2x2 minors vanish.
template <std::size_t N>
bool are_proportional(const std::array<Polynomial, N>& a, const std::array<Polynomial, N>& b) {
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (a[i] * b[j] != a[j] * b[i]) return false;
    }
  }
  return true;
}

Conic diagonal_of(const json& texts) {
  const auto [l, m, n] = vector_of<3>(texts);
  return diagonal(l, m, n);
}

}  // namespace

TEST_CASE("The conic surface of the dissertation: matrix, plane, polar triangle",
          "[printed_conics]") {
  const json& example = conic_cases()["conic_surface"];
  const auto c = matrix_of<4>(example["C"]);
  CHECK(congruent(matrix_of<4>(example["base"]), matrix_of<4>(example["M"])) == c);
  CHECK(conics_of_the_dissertation() == c);
  const QuadraticCones cones = quadratic_cones(c);
  const auto gamma = vector_of<4>(example["gam"]);
  CHECK(are_proportional(cones.vertex, gamma));
  // As printed the matrix is not symmetric.
  CHECK(code_of([&] { quadratic_cones(matrix_of<4>(example["printed"]["C"])); }) ==
        ErrorCode::kWrongShape);

  // T C T^T is (t^2 - 1)^4 times a conic of the plane z = 0; (1.11).
  const auto t = matrix_of<4>(example["T"]);
  const auto projected = matrix_of<4>(example["TCT"]);
  Matrix4OfPolynomials transposed, multiple = projected;
  const Polynomial q = conic_polynomial({-1, 0, 1}), factor = q * q * q * q;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) transposed[j][i] = t[i][j], multiple[i][j] *= factor;
  }
  CHECK(congruent(c, transposed) == multiple);
  CHECK(value(example["printed"]["TCT02"].get<std::string>(), in_t()) != projected[0][2]);

  // g, eta, zeta are conjugate in pairs and p is the pole of g, also in space.
  Conic k;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) k[i][j] = projected[i][j];
  }
  const auto g = vector_of<3>(example["g"]), eta = vector_of<3>(example["eta"]),
             zeta = vector_of<3>(example["zeta"]), pole = vector_of<3>(example["pole"]);
  CHECK(polar_form(k, g, eta).is_zero());
  CHECK(polar_form(k, g, zeta).is_zero());
  CHECK(polar_form(k, eta, zeta).is_zero());
  CHECK(are_proportional(polar_of(k, g), pole));
  const auto p = in_space(cones, polar_frame(cones).p);
  CHECK(are_proportional<3>({p[0], p[1], p[2]}, pole));

  // (1.35): the diagonal form with the rows g, zeta, eta, and not with g, eta, zeta.
  const auto points = vector_of<3>(example["point_conic"]);
  const auto is_dual = [&](const Vector3<Polynomial>& second, const Vector3<Polynomial>& third) {
    const Vector3<Polynomial> products = {points[0] * polar_form(k, g, g),
                                          points[1] * polar_form(k, second, second),
                                          points[2] * polar_form(k, third, third)};
    return products[0] == products[1] && products[0] == products[2];
  };
  CHECK(is_dual(zeta, eta));
  CHECK_FALSE(is_dual(eta, zeta));
}

TEST_CASE("The printed points of the conic surface are on it, in three times the degree",
          "[printed_conics]") {
  const json& example = conic_cases()["conic_surface"];
  const auto points = vector_of<3>(example["point_conic"]);
  const auto solution = vector_of<3>(example["solution"]);
  CHECK(polar_form(diagonal(points[0], points[1], points[2]), solution, solution).is_zero());

  // Stereographic projection from the solution, and back by adj(S), in Q[t, u].
  using P = BivariatePolynomial;
  const auto in_t_u = [](const Polynomial& p) { return P(p, Variable::kU); };
  const auto vector_in_t_u = [&](const Vector3<Polynomial>& x) {
    return std::array<P, 3>{in_t_u(x[0]), in_t_u(x[1]), in_t_u(x[2])};
  };
  const std::array<P, 3> zero{};
  std::array<std::array<P, 3>, 3> form = {zero, zero, zero};
  for (std::size_t i = 0; i < 3; ++i) form[i][i] = in_t_u(points[i]);
  const std::array<P, 3> y =
      stereographic_projection<P, 3>(form, vector_in_t_u(solution), {P(), P(1L), P(Variable::kV)});
  const Matrix3<Polynomial> s = {vector_of<3>(example["g"]), vector_of<3>(example["zeta"]),
                                 vector_of<3>(example["eta"])};
  const Matrix3<Polynomial> back = adjugate(s);
  const std::array<P, 3> z =
      polar_of<P, 3>({vector_in_t_u(back[0]), vector_in_t_u(back[1]), vector_in_t_u(back[2])}, y);
  const P t(Variable::kU), q = in_t_u(conic_polynomial({1, 0, -2, 0, 1}));
  std::array<P, 4> x = {q * z[0], q * z[1], q * z[2], t * q * z[0] - P(2L) * t * z[2]};
  P common;
  for (const P& entry : x) common = gcd(common, entry);
  int degree = 0;
  for (P& entry : x) {
    entry = *quotient(entry, common);
    degree = std::max(degree, entry.degree(Variable::kU));
  }
  CHECK(degree == 12);

  // On the conic of the library: x = b w with w^T adj(K) w = 0 is the same as x^T r adj(K) r^T x.
  const QuadraticCones cones = quadratic_cones(matrix_of<4>(example["C"]));
  std::array<P, 3> w;
  P incidence;
  for (std::size_t i = 0; i < 4; ++i) {
    incidence += in_t_u(cones.vertex[i]) * x[i];
    for (std::size_t j = 0; j < 3; ++j) w[j] += in_t_u(cones.inverse[i][j]) * x[i];
  }
  CHECK(incidence.is_zero());
  const Matrix3<Polynomial> conic = adjugate(cones.conic);
  CHECK(polar_form<P, 3>(
            {vector_in_t_u(conic[0]), vector_in_t_u(conic[1]), vector_in_t_u(conic[2])}, w, w)
            .is_zero());
  CHECK(RationalConicFamily(family_of(conic_of_tangent_planes(cones.matrix))).degree() == 4);
}

TEST_CASE("The families of the paper: solutions, substitutions, degrees", "[printed_conics]") {
  for (const json& example : conic_cases()["families"]) {
    INFO(example["source"]);
    const Conic conic = diagonal_of(example["conic"]);
    CHECK(RationalConicFamily(conic_family(conic)).degree() == example["degree"]);
    if (example.contains("solution")) {
      const auto solution = vector_of<3>(example["solution"]);
      CHECK(polar_form(conic, solution, solution).is_zero());
      const auto z = stereographic_projection<Polynomial, 3>(conic, solution, {0L, 1L, 2L});
      CHECK(polar_form(conic, z, z).is_zero());
      CHECK_FALSE(are_proportional(z, solution));
    } else {
      const auto [x, y, z] = vector_of<3>(example["substitution"]);
      Conic reduced = diagonal_of(example["reduced"]);
      const Polynomial factor = value(example["factor"].get<std::string>(), in_t());
      for (auto& row : reduced) {
        for (Polynomial& entry : row) entry *= factor;
      }
      CHECK(transformed(conic, diagonal(x, y, z)) == reduced);
    }
  }
}

TEST_CASE("Identity (1.6) holds with the first derivative and not with the second",
          "[printed_conics]") {
  const json& example = conic_cases()["plane_conic"];
  const auto c = matrix_of<3>(example["C"]);
  const auto gamma = vector_of<3>(example["gam"]);
  const auto derivative_of = [](Conic m) {
    for (auto& row : m) {
      for (Polynomial& entry : row) entry = entry.derivative();
    }
    return m;
  };
  const Conic first = derivative_of(c), second = derivative_of(first);
  CHECK(polar_of(c, gamma) == Vector3<Polynomial>{});
  CHECK(polar_form(first, gamma, gamma).is_zero());
  CHECK_FALSE(polar_form(second, gamma, gamma).is_zero());
  const Vector3<Polynomial> moved = {gamma[0].derivative(), gamma[1].derivative(),
                                     gamma[2].derivative()};
  CHECK(polar_form(second, gamma, gamma) ==
        Polynomial(-2L) * contraction(polar_of(first, gamma), moved));
}

TEST_CASE("The vertex of the cones lies on the derived quadric, (5.2)", "[printed_conics]") {
  const json& example = conic_cases()["cones"];
  const QuadraticCones cones =
      quadratic_cones(vector_of<4>(example["vertex"]), matrix_of<3>(example["directions"]));
  CHECK(are_proportional(cones.vertex, vector_of<4>(example["vertex"])));
  const auto slope = derivative(cones.matrix);
  CHECK(polar_form(slope, cones.vertex, cones.vertex).is_zero());
  const auto phi = polar_of(slope, cones.vertex),
             minus = polar_of(cones.matrix, derivative(cones.vertex));
  for (std::size_t i = 0; i < 4; ++i) CHECK((phi[i] + minus[i]).is_zero());
  CHECK(contraction(phi, cones.vertex).is_zero());
}

TEST_CASE("A canal surface with only r^2 rational is the envelope of its cones, (2.14)",
          "[printed_conics]") {
  const json& example = conic_cases()["canal"];
  const auto m = vector_of<3>(example["m"]);
  const Polynomial rr = value(example["squared_radius"].get<std::string>(), in_t());
  // S and the plane p of S': the cone that touches S along p is (p^T S^-1 p) S - p p^T, times r^2.
  Matrix4OfPolynomials sphere, cone;
  Vector4OfPolynomials plane;
  Polynomial mm = -rr, speed;
  plane[3] = Polynomial(Rational(1L) / Rational(2L)) * rr.derivative();
  for (std::size_t i = 0; i < 3; ++i) {
    sphere[i][i] = Polynomial(1L);
    sphere[i][3] = sphere[3][i] = -m[i];
    plane[i] = m[i].derivative();
    plane[3] -= m[i] * plane[i];
    mm += m[i] * m[i];
    speed += plane[i] * plane[i];
  }
  sphere[3][3] = mm;
  const Polynomial slope = rr.derivative();
  const Polynomial factor = rr * speed - Polynomial(Rational(1L) / Rational(4L)) * slope * slope;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j)
      cone[i][j] = factor * sphere[i][j] - rr * plane[i] * plane[j];
  }
  const QuadraticConeEnvelope envelope(quadratic_cones(cone));
  constexpr long kBits = 512;
  const auto [x, planes] = envelope.contact_elements(kBits);
  const auto on = [&](const RealBall& t, const RealBall& u) {
    std::array<RealBall, 4> point;
    for (std::size_t i = 0; i < 4; ++i) point[i] = x[i].at(t, u);
    return point;
  };
  for (long numerator : {-3L, 1L, 5L}) {
    const Rational t = Rational(numerator) / Rational(4L);
    const auto point = on(RealBall(t, kBits), RealBall(0.3125));
    RealBall on_sphere, on_plane, size;
    for (std::size_t i = 0; i < 4; ++i) {
      on_plane += RealBall(plane[i](t), kBits) * point[i];
      size += point[i] * point[i];
      for (std::size_t j = 0; j < 4; ++j) {
        on_sphere += RealBall(sphere[i][j](t), kBits) * point[i] * point[j];
      }
    }
    CHECK(encloses_zero(on_sphere / size, 1e-60));
    CHECK(encloses_zero(on_plane * on_plane / size, 1e-60));
    CHECK_FALSE(point[3].contains_zero());
  }
}
