// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/rational_envelope.hpp"

#include <catch2/catch.hpp>

#include "envelope_sheets.hpp"
#include "pn/geometry_error.hpp"
#include "random_surfaces.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const BivariateFunction u(BivariatePolynomial(Variable::kU)), v(BivariatePolynomial(Variable::kV));

/// Both sheets are PN surfaces and touch the spheres, and they differ.
void check_sheets(const RationalEnvelope& envelope) {
  for (const OrientedSurface& sheet : envelope.sheets) {
    CHECK(is_pn_surface(sheet, 0L));
    CHECK(is_pn_surface(sheet, Rational(5L) / Rational(3L)));
    CHECK(is_envelope(sheet, envelope.spheres));
  }
  CHECK(envelope.sheets[0].normal != envelope.sheets[1].normal);
}

/// The parameters are those of f, and one sheet has the normal of w.
void check_has_normal(const RationalEnvelope& envelope, const SphereSurface& f,
                      const IsotropicField& w) {
  CHECK(envelope.spheres == f);
  const std::array<BivariateFunction, 3> n = {w[0] / w[3], w[1] / w[3], w[2] / w[3]};
  CHECK(((envelope.sheets[0].normal == n) != (envelope.sheets[1].normal == n)));
}

}  // namespace

TEST_CASE("Six control spheres give two sheets, also in a 3-space or with equal radii",
          "[rational_envelope]") {
  for (unsigned seed = 0; seed < 4; ++seed) {
    RandomSurfaces random(seed);
    SphereSurface f = surface_of(random.power_form());
    check_sheets(rational_envelope(f));
    f[3] = f[0] / BivariateFunction(3L) - f[1] / BivariateFunction(4L);
    check_sheets(rational_envelope(f));
    f[3] = BivariateFunction(2L);
    check_sheets(rational_envelope(f));
  }
}

TEST_CASE("A PN surface plus any rational radius keeps its normals", "[rational_envelope]") {
  for (unsigned seed = 0; seed < 3; ++seed) {
    RandomSurfaces random(seed);
    // The parabolic cyclide that touches 2 a u x + 2 b v y + (a^2 u^2 + b^2 v^2 - 1) z = a u^2 + b
    // v^2.
    const BivariateFunction a(2L), b(-3L), one(1L), two(2L);
    const BivariateFunction square = a * a * u * u + b * b * v * v, weight = one + square;
    const IsotropicField w = {two * a * u, two * b * v, square - one, weight};
    const BivariateFunction radius = random.polynomial(2, 1) / (one + random.polynomial(1, 1) * u);
    const std::array<BivariateFunction, 3> cyclide = {u * (one + b * v * v * (b - a)) / weight,
                                                      v * (one + a * u * u * (a - b)) / weight,
                                                      (a * u * u + b * v * v) / weight};
    SphereSurface f;
    for (std::size_t i = 0; i < 3; ++i) f[i] = cyclide[i] + radius * w[i] / weight;
    f[3] = radius;
    const RationalEnvelope envelope = rational_envelope(f);
    check_sheets(envelope);
    check_has_normal(envelope, f, w);
    CHECK((envelope.sheets[0].point == cyclide || envelope.sheets[1].point == cyclide));
  }
}

TEST_CASE("Surfaces in isotropic hyperplanes touch one plane", "[rational_envelope]") {
  for (unsigned seed = 0; seed < 3; ++seed) {
    RandomSurfaces random(seed);
    const BivariateFunction height = random.polynomial(3, 2);
    const SphereSurface f = {random.polynomial(1, 2), random.polynomial(2, 1), height, height};
    const RationalEnvelope envelope = rational_envelope(f);
    check_sheets(envelope);
    check_has_normal(envelope, f, {0L, 0L, 1L, 1L});
  }
}

TEST_CASE("Spheres through one point touch it, and a second sheet", "[rational_envelope]") {
  for (unsigned seed = 0; seed < 3; ++seed) {
    RandomSurfaces random(seed);
    SphereSurface f = random.isotropic_field();
    const BivariateFunction factor = random.polynomial(1, 1);
    for (BivariateFunction& x : f) x *= factor;
    // The point is a sheet without a tangent plane; its normals are those of the spheres.
    const RationalEnvelope envelope = rational_envelope(f);
    check_sheets(envelope);
    check_has_normal(envelope, f, f);
  }
}

TEST_CASE("Sheets are reflections of each other in the tangent planes of the centres",
          "[rational_envelope]") {
  RandomSurfaces random(1);
  const RationalEnvelope normals = rational_envelope(surface_of(random.power_form()));
  CHECK(other_sheet(normals.sheets[1], normals.spheres).normal == normals.sheets[0].normal);
  // The sheets of a MOS surface are found together, by a root.
  const BivariateFunction height = random.polynomial(2, 2);
  const RationalEnvelope mos = rational_envelope({u, v, height, height});
  CHECK(other_sheet(mos.sheets[0], mos.spheres).normal == mos.sheets[1].normal);
  CHECK(other_sheet(mos.sheets[0], mos.spheres).point == mos.sheets[1].point);
}

TEST_CASE("Osculating spheres have one sheet twice", "[rational_envelope]") {
  // (x1, x2, x4) is a curve with isotropic tangents: spheres along lines of curvature.
  const BivariateFunction third = BivariateFunction(1L) / BivariateFunction(3L);
  const SphereSurface f = {u * u, u - third * u * u * u, v, u + third * u * u * u};
  const RationalEnvelope envelope = rational_envelope(f);
  CHECK(envelope.sheets[0].normal == envelope.sheets[1].normal);
  CHECK(is_pn_surface(envelope.sheets[0], 1L));
  CHECK(is_envelope(envelope.sheets[0], f));
}

TEST_CASE("Families without a rational envelope are refused by their reason",
          "[rational_envelope]") {
  const auto refusal = [](const SphereSurface& f) {
    try {
      rational_envelope(f);
    } catch (const GeometryError& error) {
      return error.code();
    }
    FAIL("not refused");
    return ErrorCode::kNotFinite;
  };
  CHECK(refusal({u, v, u * u * u * v + v * v, u * v * v}) == ErrorCode::kNotRational);
  CHECK(refusal({u, u * u, u, v}) == ErrorCode::kZeroLength);
  // Cones of revolution with parallel axes.
  CHECK(refusal({u * u, u, BivariateFunction(3L) * v, v + u}) == ErrorCode::kDevelopable);
  // A plane of spheres touches two planes, whose angle is not rational.
  CHECK(refusal({u, v, 0L, u / BivariateFunction(2L)}) == ErrorCode::kDevelopable);
}
