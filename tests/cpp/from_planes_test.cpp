// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/from_planes.hpp"

#include <catch2/catch.hpp>

#include "error_code.hpp"

using namespace pn;

namespace {

using Polynomial = BivariatePolynomial;
using Function = BivariateFunction;
using Vector = std::array<Function, 3>;

const Polynomial kU(Variable::kU), kV(Variable::kV), kOne(1L), kTwo(2L);

Function dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector derivative(const Vector& a, Variable by) {
  return {a[0].derivative(by), a[1].derivative(by), a[2].derivative(by)};
}

/// n is the unit normal of x: identities of rational functions.
void check_unit_normal(const OrientedSurface& x) {
  CHECK(dot(x.normal, x.normal) == Function(1L));
  CHECK(dot(x.normal, derivative(x.point, Variable::kU)).is_zero());
  CHECK(dot(x.normal, derivative(x.point, Variable::kV)).is_zero());
}

bool equal(const Vector& a, const Vector& b) {
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/// The spheres (m, r) touch x with normal n: x = m - p n, (x - m).m_u + r r_u = 0, likewise v.
void check_envelope(const MinkowskiVector<Function>& f, const OrientedSurface& x) {
  const Vector from_centre = {x.point[0] - f[0], x.point[1] - f[1], x.point[2] - f[2]};
  CHECK(dot(from_centre, from_centre) == f[3] * f[3]);
  for (const Variable by : {Variable::kU, Variable::kV}) {
    const Vector centre = {f[0], f[1], f[2]};
    CHECK((dot(from_centre, derivative(centre, by)) + f[3] * f[3].derivative(by)).is_zero());
  }
}

const auto kW = universal_isotropic_vector({kU, kV + kOne, kOne, kU* kV});
const Function kH(kU* kU - kV, kTwo + kV);

}  // namespace

TEST_CASE("The universal parametrization is isotropic", "[from_planes]") {
  CHECK((kW[0] * kW[0] + kW[1] * kW[1] + kW[2] * kW[2] - kW[3] * kW[3]).is_zero());
}

TEST_CASE("The planes touch the surface that they give", "[from_planes]") {
  const OrientedSurface q = from_planes(kW, kH);
  check_unit_normal(q);
  CHECK(dot(q.point, q.normal) == kH / Function(kW[3]));
}

TEST_CASE("An offset comes from the planes moved along their normals", "[from_planes]") {
  const OrientedSurface q = from_planes(kW, kH);
  const Rational d = Rational(7L) / Rational(3L);
  const OrientedSurface moved = from_planes(kW, kH + Function(kW[3]) * Function(d));
  const RationalSections sections = rational_sections(q);
  const Rational u = Rational(2L) / Rational(5L), v = Rational(1L) / Rational(7L);
  REQUIRE(sections.squared_length == Rational(1L));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(moved.point[i] == q.point[i] + Function(d) * q.normal[i]);
    const auto& [point, direction, weight] = sections.sections;
    CHECK((point[i].at(u, v) + d * direction[i].at(u, v)) / weight.at(u, v) ==
          moved.point[i](u, v));
  }
}

TEST_CASE("The planes of the parabolic Dupin cyclide", "[from_planes]") {
  // 2 a u x + 2 b v y + (a^2 u^2 + b^2 v^2 - 1) z = a u^2 + b v^2 (Peternell, section 5.3)
  const Rational a(3L), b = Rational(1L) / Rational(2L);
  const Polynomial p(a), q(b);
  const Polynomial above = p * p * kU * kU + q * q * kV * kV;
  const OrientedSurface x = from_planes({kTwo * p * kU, kTwo * q * kV, above - kOne, above + kOne},
                                        p * kU * kU + q * kV * kV);
  const Polynomial n = above + kOne;
  CHECK(equal(x.point, {Function(kU * (kOne + q * kV * kV * (q - p)), n),
                        Function(kV * (kOne + p * kU * kU * (p - q)), n),
                        Function(p * kU * kU + q * kV * kV, n)}));
}

TEST_CASE("Spheres along a PN surface are a MOS surface with both sheets rational",
          "[from_planes]") {
  const OrientedSurface q = from_planes(kW, kU * kV + kOne);
  const MinkowskiVector<Function> f = spheres_along(q, Function(kOne + kU, kTwo));
  const auto root = mos_root(f);
  REQUIRE(root.has_value());
  const auto sheets = envelope_sheets(f);
  for (const OrientedSurface& sheet : sheets) {
    check_unit_normal(sheet);
    check_envelope(f, sheet);
  }
  CHECK(equal(sheets[0].point, q.point) != equal(sheets[1].point, q.point));
}

TEST_CASE("A family without rational normals is refused with that reason", "[from_planes]") {
  // A = (1 - r_u^2) - r_v^2 for a plane of centres: with r = u v / 2 it is no square.
  const MinkowskiVector<Function> f = {Function(kU), Function(kV), Function(),
                                       Function(kU * kV, kTwo)};
  CHECK_FALSE(mos_root(f).has_value());
  CHECK(test::code_of([&] { envelope_sheets(f); }) == ErrorCode::kNotRational);
}

TEST_CASE("Centres on a curve and planes with normals on a curve are refused", "[from_planes]") {
  const MinkowskiVector<Function> f = {Function(kU), Function(), Function(), Function(kV)};
  CHECK(test::code_of([&] { envelope_sheets(f); }) == ErrorCode::kZeroLength);
  const auto w = universal_isotropic_vector({kU, kOne, kU * kU, kTwo});
  CHECK(test::code_of([&] { from_planes(w, kV); }) == ErrorCode::kDevelopable);
}
