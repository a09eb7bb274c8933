// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/family_spline.hpp"

#include <catch2/catch.hpp>

#include "pn/isotropic/sheet.hpp"
#include "random_triangulations.hpp"

using namespace pn;
using namespace pn::test;

TEST_CASE("The orientation is that of the corners", "[family_spline]") {
  const PlanePoint a = {Rational(0L), Rational(0L)}, b = {Rational(2L), Rational(1L)},
                   c = {Rational(1L), Rational(3L)};
  CHECK(orientation(a, b, c) == Rational(5L));
  CHECK(orientation(b, a, c) == Rational(-5L));
  CHECK(orientation(a, b, b).is_zero());
}

TEST_CASE("Where the spline is C1 the normals of both sheets do not jump", "[family_spline]") {
  std::mt19937_64 random(5);
  const FamilySpline spline = grid(2, 0.3, random, Dome()).family().spline;
  const DirectedEdges edges = spline.edges();
  const auto point = [](std::size_t edge, double at) {
    const std::array<std::array<double, 2>, 3> corners = {{{0, 0}, {1, 0}, {0, 1}}};
    const auto &from = corners[edge], &to = corners[(edge + 1) % 3];
    return std::array{from[0] * (1 - at) + to[0] * at, from[1] * (1 - at) + to[1] * at};
  };
  for (std::size_t i = 0; i < spline.pieces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto neighbour = edges.opposite({i, k});
      if (!neighbour) continue;
      const FamilyInDoubles own(spline.pieces[i].family),
          other(spline.pieces[neighbour->triangle].family);
      for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
        const auto p = point(k, 0.3), q = point(neighbour->edge, 0.7);
        CHECK((own.at(p[0], p[1]) - other.at(q[0], q[1])).norm() < 1e-11);
        CHECK((own.normal(sheet, p[0], p[1]) - other.normal(sheet, q[0], q[1])).norm() < 1e-11);
      }
    }
  }
}
