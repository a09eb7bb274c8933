// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/bspline_surface.hpp"

#include <catch2/catch.hpp>

TEST_CASE("Poles are counted from knots", "[bspline_surface]") {
  CHECK(pn::pole_count(3, {4, 4}) == 4);
  CHECK(pn::pole_count(3, {4, 1, 2, 4}) == 7);
  CHECK(pn::pole_count(1, {2, 1, 1, 2}) == 4);
  pn::BSplineSurface surface;
  surface.u_degree = 2;
  surface.v_degree = 4;
  surface.u_multiplicities = {3, 1, 3};
  surface.v_multiplicities = {5, 3, 3, 5};
  CHECK(surface.u_count() == 4);
  CHECK(surface.v_count() == 11);
}
