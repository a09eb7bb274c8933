// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/mass.hpp"

#include <catch2/catch.hpp>

#include "pn/occt/caps.hpp"
#include "pn/occt/shell.hpp"
#include "surfaces_of_revolution.hpp"

using pn::area;
using pn::make_shell;
using pn::volume;
using pn::test::kPi;

TEST_CASE("Area and volume of a torus") {
  const TopoDS_Shell shell = make_shell({pn::test::torus(5, 2)});
  CHECK(area(shell) == Approx(4 * kPi * kPi * 5 * 2).epsilon(1e-13));
  CHECK(volume(shell) == Approx(2 * kPi * kPi * 5 * 4).epsilon(1e-13));
}

TEST_CASE("Area and volume of a sphere, in spite of its poles") {
  const TopoDS_Shell shell = make_shell(pn::test::sphere_halves());
  CHECK(area(shell) == Approx(4 * kPi).epsilon(1e-9));
  CHECK(volume(shell) == Approx(4 * kPi / 3).epsilon(1e-9));
}

TEST_CASE("Area of an open cone") {
  const TopoDS_Shell shell = make_shell({pn::test::tube(1, 0, 4, 4)});
  CHECK(area(shell) == Approx(kPi * (1 + 4) * 5).epsilon(1e-13));
}

TEST_CASE("Volume is negative where faces point inwards") {
  const TopoDS_Shape inwards = make_shell({pn::test::torus(5, 2)}).Reversed();
  CHECK(volume(inwards) == Approx(-2 * kPi * kPi * 5 * 4).epsilon(1e-13));
}

TEST_CASE("An open shell has no volume") {
  CHECK_THROWS_AS(volume(make_shell({pn::test::tube(1, 0, 4, 4)})), std::invalid_argument);
}
