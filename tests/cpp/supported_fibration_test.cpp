// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/supported_fibration.hpp"

#include <catch2/catch.hpp>

#include "envelope_sheets.hpp"
#include "pn/geometry_error.hpp"
#include "random_surfaces.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const BivariateFunction u(BivariatePolynomial(Variable::kU)), v(BivariatePolynomial(Variable::kV));

std::string refusal(const SupportedFibration& fibration) {
  try {
    supported_surface(fibration);
  } catch (const GeometryError& error) {
    CHECK(error.code() == ErrorCode::kNotRational);
    return error.what();
  }
  FAIL("not refused");
  return {};
}

}  // namespace

TEST_CASE("Lines that join two lines take any support functions of one variable each",
          "[supported_fibration]") {
  for (unsigned seed = 1; seed < 6; ++seed) {
    RandomSurfaces random(seed);
    const SupportedFibration fibration = {{1L, 0L, u, 0L},
                                          {0L, 1L, 0L, v},
                                          random.polynomial(4, 0) / (u + BivariateFunction(11L)),
                                          random.polynomial(0, 3)};
    const SphereSurface f = supported_surface(fibration);
    CHECK(minkowski(fibration.c, f) == fibration.a);
    CHECK(minkowski(fibration.d, f) == fibration.b);
    for (const auto& x : tangent_plane(f)) {
      const MinkowskiVector<BivariateFunction> vector = {x[0], x[1], x[2], x[3]};
      CHECK(minkowski(fibration.c, vector).is_zero());
      CHECK(minkowski(fibration.d, vector).is_zero());
    }
    const RationalEnvelope envelope = rational_envelope(f);
    for (const OrientedSurface& sheet : envelope.sheets) {
      CHECK(is_pn_surface(sheet, 2L));
      CHECK(is_envelope(sheet, envelope.spheres));
    }
  }
}

TEST_CASE("Support functions that do not fit, and lines that are too few, are refused",
          "[supported_fibration]") {
  CHECK(refusal({{1L, 0L, u, 0L}, {0L, 1L, 0L, v}, u * v, v * v}).find("do not fit") !=
        std::string::npos);
  CHECK(refusal({{1L, 0L, u, 0L}, {0L, 1L, v, 0L}, u, v}).find("open") != std::string::npos);
}
