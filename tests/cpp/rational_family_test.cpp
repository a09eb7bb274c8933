// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/rational_family.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "envelope_sheets.hpp"
#include "pn/geometry_error.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const Coefficients kZero, kOne = {{1}}, kU = {{0}, {1}}, kV = {{0, 1}}, kUV = {{0}, {0, 1}};
const BivariateFunction u(BivariatePolynomial(Variable::kU)), v(BivariatePolynomial(Variable::kV));

template <class Make>
ErrorCode refusal(Make make) {
  try {
    make();
  } catch (const GeometryError& error) {
    return error.code();
  }
  FAIL("not refused");
  return ErrorCode::kNotFinite;
}

}  // namespace

TEST_CASE("A net with its support functions and the spheres themselves give one family",
          "[rational_family]") {
  const Coefficients square_of_u = {{0}, {0}, {0.25}}, square_of_v = {{0, 0, 0.5}};
  const RationalFamily net =
      family_from_net({kOne, kZero, kU, kZero}, {kZero, kOne, kZero, kV}, square_of_u, square_of_v);
  // f1 + u f3 = u^2/4 and f2 - v f4 = v^2/2, with the derivatives f3 = u/2 and -f4 = v.
  const Coefficients half_u = {{0}, {0.5}}, radius = kV, f1 = {{0}, {0}, {-0.25}},
                     f2 = {{0, 0, -0.5}};
  const RationalFamily surface = family_from_surface({f1, f2, half_u, radius}, kOne);
  CHECK(net.spheres == surface.spheres);
  CHECK(net.is_over_normals());
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(net.envelope.sheets[i].point == surface.envelope.sheets[i].point);
    CHECK(is_envelope(net.envelope.sheets[i], net.envelope.spheres));
  }
}

TEST_CASE("Spheres have one weight, and rational normals keep their parameters",
          "[rational_family]") {
  const Coefficients weight = {{2, 0, 1}};
  const RationalFamily family = family_from_surface({kU, kV, kUV, kUV}, weight);
  const BivariateFunction w = BivariateFunction(2L) + v * v;
  CHECK(family.spheres == SphereSurface{u / w, v / w, u * v / w, -(u * v) / w});
  CHECK_FALSE(family.is_over_normals());
}

TEST_CASE("A part of a sheet is the sheet over its rectangle", "[rational_family]") {
  const RationalFamily family = family_from_surface({kU, kV, kUV, kUV}, kOne);
  const OrientedSurface& sheet = family.envelope.sheets[0];
  const RationalSections part = part_of(sheet, {{-0.5, 0.25}, {0.5, 0.75}});
  const Rational p = Rational(1L) / Rational(3L), q = Rational(2L) / Rational(5L),
                 s = p - Rational(1L) / Rational(2L),
                 t = (q + Rational(1L) / Rational(2L)) / Rational(2L);
  CHECK(part.squared_length == Rational(1L));
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational weight = part.sections.weight.at(p, q);
    CHECK(part.sections.point[i].at(p, q) == weight * sheet.point[i](s, t));
    CHECK(part.sections.direction[i].at(p, q) == weight * sheet.normal[i](s, t));
  }
}

TEST_CASE("Bad families and bad bounds are refused", "[rational_family]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::array<Coefficients, 4> spheres = {kU, kV, kUV, kUV};
  CHECK(refusal([&] {
          family_from_surface({kU, kV, {{nan}}, kU}, kOne);
        }) == ErrorCode::kNotFinite);
  CHECK(refusal([&] { family_from_surface(spheres, kZero); }) == ErrorCode::kNonPositiveWeight);
  CHECK(refusal([&] { family_from_surface({kU, kU, kU, kOne}, kOne); }) == ErrorCode::kZeroLength);
  CHECK(refusal([&] {
          family_from_surface({kU, kV, {{0, 0, 0, 1}, {0}, {0}, {1}}, kUV}, kOne);
        }) == ErrorCode::kNotRational);
  const OrientedSurface sheet = family_from_surface(spheres, kOne).envelope.sheets[0];
  CHECK(refusal([&] { part_of(sheet, {{0, 0}, {1, 0}}); }) == ErrorCode::kBadBounds);
  CHECK(refusal([&] { part_of(sheet, {{0, nan}, {1, 1}}); }) == ErrorCode::kNotFinite);
}
