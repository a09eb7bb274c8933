// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/mass.hpp"

#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <catch2/catch.hpp>
#include <cmath>

#include "pn/occt/caps.hpp"
#include "pn/occt/shell.hpp"
#include "pn/occt/thick_solid.hpp"
#include "trimmed_surfaces.hpp"

using pn::area;
using pn::make_shell;
using pn::volume;
using pn::test::kPi;
using pn::test::oval;
using pn::test::within;

namespace {

// Point and velocity of a cubic Bezier curve.
struct Motion {
  double u, v, du, dv;
};
Motion motion(const pn::ParameterCurve& cubic, double t) {
  const auto& p = cubic.poles;
  const double s = 1 - t;
  const auto at = [&](int k) {
    return s * s * s * p[0][k] + 3 * s * s * t * p[1][k] + 3 * s * t * t * p[2][k] +
           t * t * t * p[3][k];
  };
  const auto speed = [&](int k) {
    return 3 * (s * s * (p[1][k] - p[0][k]) + 2 * s * t * (p[2][k] - p[1][k]) +
                t * t * (p[3][k] - p[2][k]));
  };
  return {at(0), at(1), speed(0), speed(1)};
}

// Integral of form(motion) dt around a loop of cubic Bezier curves, by Simpson's rule.
template <class Form>
double around(const pn::TrimLoop& loop, const Form& form) {
  constexpr int kSteps = 20000;
  double sum = 0;
  for (const pn::ParameterCurve& curve : loop) {
    for (int i = 0; i <= kSteps; ++i) {
      const double weight = i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2;
      sum += weight * form(motion(curve, i / double(kSteps))) / (3. * kSteps);
    }
  }
  return sum;
}

// The area element of `paraboloid`, integrated from 0 to u, times dv.
double paraboloid_strip(const Motion& m) {
  const double b = std::sqrt(1 + 4 * m.v * m.v);
  return (m.u * std::hypot(b, 2 * m.u) / 2 + b * b / 4 * std::asinh(2 * m.u / b)) * m.dv;
}

// The angle that `circle` has turned at v: twice that of (p, q).
double angle(double v) {
  const double arc = std::floor(v);
  const double s = v - arc;
  const double c = std::sqrt(0.5);
  const double p = (1 + c) / 2 * ((1 - s) * (1 - s) + s * s) + 2 * s * (1 - s);
  const double q = c / 2 * (s * s - (1 - s) * (1 - s));
  return arc * kPi / 2 + 2 * std::atan2(q, p);
}

// Legendre's formula for a >= b >= c.
double ellipsoid_area(double a, double b, double c) {
  const double phi = std::acos(c / a);
  const double k = a / b * std::sqrt((b * b - c * c) / (a * a - c * c));
  const double sine = std::sin(phi), cosine = std::cos(phi);
  return 2 * kPi *
         (c * c +
          a * b / sine *
              (std::ellint_2(k, phi) * sine * sine + std::ellint_1(k, phi) * cosine * cosine));
}

}  // namespace

TEST_CASE("Area and volume of a torus") {
  const TopoDS_Shell shell = make_shell({pn::test::torus(5, 2)});
  CHECK(area(shell) == Approx(4 * kPi * kPi * 5 * 2).epsilon(1e-13));
  CHECK(volume(shell) == Approx(2 * kPi * kPi * 5 * 4).epsilon(1e-13));
}

TEST_CASE("Area and volume of a sphere, in spite of its poles") {
  const TopoDS_Shell shell = make_shell(pn::test::sphere_halves());
  CHECK(area(shell) == Approx(4 * kPi).epsilon(1e-13));
  CHECK(volume(shell) == Approx(4 * kPi / 3).epsilon(1e-13));
}

TEST_CASE("Area and volume of ellipsoids, round and flat") {
  for (const auto& [a, b, c] : {std::array{3., 2., 1.}, {30., 20., 1.}, {3., 2.9, 2.8}}) {
    const TopoDS_Shell shell = make_shell(pn::test::ellipsoid_halves(a, b, c));
    CHECK(area(shell) == Approx(ellipsoid_area(a, b, c)).epsilon(1e-12));
    CHECK(volume(shell) == Approx(4 * kPi / 3 * a * b * c).epsilon(1e-13));
  }
}

TEST_CASE("Area within trims and without holes") {
  const auto outer = oval({0.1, 0}, 0.8, 0.9);
  const auto hole = pn::test::reversed(oval({0.2, 0.1}, 0.3, 0.2));
  const double exact = around(outer, paraboloid_strip) + around(hole, paraboloid_strip);
  const TopoDS_Shell shell = make_shell({within(pn::test::paraboloid(), {outer, hole})});
  CHECK(area(shell) == Approx(exact).epsilon(1e-13));
}

TEST_CASE("Area within a trim across knots, where the surface is only C1") {
  // The oval touches knot lines, crosses them and begins on one.
  const auto loop = oval({0.4, 2}, 0.3, 1.7);
  const double exact = around(loop, [](const Motion& m) { return -5 * 2 * angle(m.v) * m.du; });
  CHECK(area(make_shell({within(pn::test::tube(2, 0, 2, 5), {loop})})) ==
        Approx(exact).epsilon(1e-12));
}

TEST_CASE("Area and volume of a spherical cap, cut off at a parameter line") {
  const double h = 1 + pn::test::height(0.7);
  const TopoDS_Shell shell = make_shell(pn::test::up_to(pn::test::sphere_halves(), 0.7));
  CHECK(area(shell) == Approx(2 * kPi * h).epsilon(1e-13));
  // The planar cap ends at the fitted edge.
  CHECK(volume(pn::make_capped_solid(shell)) == Approx(kPi * h * h * (3 - h) / 3).epsilon(1e-10));
}

TEST_CASE("The volume of two shells is that between them") {
  const auto solid = pn::make_thick_solid(make_shell({pn::test::torus(5, 1)}),
                                          make_shell({pn::test::torus(5, 2)}));
  CHECK(volume(solid) == Approx(2 * kPi * kPi * 5 * 3).epsilon(1e-13));
}

TEST_CASE("Area is the same on a periodic surface, wherever it begins") {
  const TopoDS_Shell shell =
      make_shell({within(pn::test::torus(5, 2), {oval({2.2, 2.1}, 1.7, 1.8)})});
  const double before = area(shell);
  const TopoDS_Face face = TopoDS::Face(TopExp_Explorer(shell, TopAbs_FACE).Current());
  const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face));
  surface->SetUPeriodic();
  surface->SetVPeriodic();
  CHECK(area(shell) == Approx(before).epsilon(1e-13));
  // Now the parameters run from 2 to 6, and half of the trim lies below.
  surface->SetUOrigin(3);
  surface->SetVOrigin(3);
  CHECK(area(shell) == Approx(before).epsilon(1e-13));
}

TEST_CASE("Area of an open cone") {
  const TopoDS_Shell shell = make_shell({pn::test::tube(1, 0, 4, 4)});
  CHECK(area(shell) == Approx(kPi * (1 + 4) * 5).epsilon(1e-13));
}

TEST_CASE("Volume is negative where faces point inwards") {
  const TopoDS_Shape inwards = make_shell({pn::test::torus(5, 2)}).Reversed();
  CHECK(volume(inwards) == Approx(-2 * kPi * kPi * 5 * 4).epsilon(1e-13));
}

TEST_CASE("The estimated error covers the true one and is small") {
  const auto covers = [](const pn::Measure& measure, double exact) {
    CAPTURE(measure.value, measure.error, exact);
    CHECK(std::abs(measure.value - exact) <= measure.error);
    CHECK(measure.error <= 1e-8 * exact);
  };
  const TopoDS_Shell torus = make_shell({pn::test::torus(5, 2)});
  covers(pn::measured_area(torus), 4 * kPi * kPi * 5 * 2);
  covers(pn::measured_volume(torus), 2 * kPi * kPi * 5 * 4);
  const TopoDS_Shell ellipsoid = make_shell(pn::test::ellipsoid_halves(30, 20, 1));
  // Legendre's formula at 40 digits; in doubles it loses more than the quadrature.
  covers(pn::measured_area(ellipsoid), 3796.0216270338493239);
  covers(pn::measured_volume(ellipsoid), 4 * kPi / 3 * 30 * 20);
  const auto outer = oval({0.1, 0}, 0.8, 0.9);
  covers(pn::measured_area(make_shell({within(pn::test::paraboloid(), {outer})})),
         around(outer, paraboloid_strip));
  const TopoDS_Shell cap = make_shell(pn::test::up_to(pn::test::sphere_halves(), 0.7));
  const double h = 1 + pn::test::height(0.7);
  covers(pn::measured_volume(pn::make_capped_solid(cap)), kPi * h * h * (3 - h) / 3);
}

TEST_CASE("One rule is enough where surfaces are smooth, and for comparisons elsewhere") {
  CHECK(pn::area_by_one_rule(make_shell({pn::test::torus(5, 2)})) ==
        Approx(4 * kPi * kPi * 5 * 2).epsilon(1e-12));
  // At a pole of the parametrization, and where a torus meets itself, normals vanish.
  CHECK(pn::area_by_one_rule(make_shell(pn::test::ellipsoid_halves(3, 2, 1))) ==
        Approx(ellipsoid_area(3, 2, 1)).epsilon(1e-4));
  const TopoDS_Shell spindle = make_shell({pn::test::torus(1, 2)});
  CHECK(pn::area_by_one_rule(spindle) == Approx(area(spindle)).epsilon(1e-3));
}

TEST_CASE("An open shell has no volume") {
  CHECK_THROWS_AS(volume(make_shell({pn::test::tube(1, 0, 4, 4)})), std::invalid_argument);
}
