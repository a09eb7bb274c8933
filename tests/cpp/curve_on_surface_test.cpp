// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/curve_on_surface.hpp"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <catch2/catch.hpp>

#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/caps.hpp"
#include "pn/occt/occt_error.hpp"
#include "pn/occt/shell.hpp"
#include "trimmed_surfaces.hpp"

using pn::curves_on_surfaces;
using pn::make_shell;
using pn::to_geometry;
using pn::trim_deviation;
using pn::test::within;

namespace {

constexpr double kFitError = 1e-9;

}  // namespace

TEST_CASE("A p-curve keeps its numbers") {
  const pn::ParameterCurve trim = pn::test::wave();
  const auto geometry = to_geometry(trim);
  CHECK(geometry->Degree() == trim.degree);
  REQUIRE(geometry->NbPoles() == static_cast<int>(trim.poles.size()));
  for (int i = 0; i < geometry->NbPoles(); ++i) {
    CHECK(geometry->Pole(i + 1).X() == trim.poles[i][0]);
    CHECK(geometry->Pole(i + 1).Y() == trim.poles[i][1]);
  }
  REQUIRE(geometry->NbKnots() == static_cast<int>(trim.knots.size()));
  for (int i = 0; i < geometry->NbKnots(); ++i) {
    CHECK(geometry->Knot(i + 1) == trim.knots[i]);
    CHECK(geometry->Multiplicity(i + 1) == trim.multiplicities[i]);
  }
}

TEST_CASE("The image of a p-curve lies on the surface, at the parameter of the p-curve") {
  // It crosses all knot lines of the torus, where that is only C1.
  const auto p_curve =
      to_geometry(pn::ParameterCurve{3, {2, 5}, {4, 4}, {{0.2, 3.8}, {1, 0}, {4, 3}, {3.5, 0.3}}});
  const auto torus = to_geometry(pn::test::torus(5, 2));
  const auto curve = curves_on_surfaces(p_curve, {torus}).at(0);
  CHECK(curve->FirstParameter() == 2);
  CHECK(curve->LastParameter() == 5);
  CHECK(curve->IsCN(1));
  for (int i = 0; i <= 1000; ++i) {
    const double t = std::min(2 + i * 0.003, 5.);
    const gp_Pnt p = curve->Value(t);
    CHECK(std::abs(std::hypot(std::hypot(p.X(), p.Y()) - 5, p.Z()) - 2) < kFitError);
    const gp_Pnt2d uv = p_curve->Value(t);
    CHECK(p.Distance(torus->Value(uv.X(), uv.Y())) < kFitError);
  }
}

TEST_CASE("Images on two surfaces have the same knots") {
  const auto p_curve = to_geometry(pn::test::wave());
  const std::vector surfaces = {to_geometry(pn::test::tube(2, 0, 2, 5)),
                                to_geometry(pn::test::tube(30, 1, 20, 7))};
  const auto curves = curves_on_surfaces(p_curve, surfaces);
  REQUIRE(curves.size() == 2);
  CHECK(curves[0]->Degree() == curves[1]->Degree());
  REQUIRE(curves[0]->NbKnots() == curves[1]->NbKnots());
  for (int i = 1; i <= curves[0]->NbKnots(); ++i) {
    CHECK(curves[0]->Knot(i) == curves[1]->Knot(i));
    CHECK(curves[0]->Multiplicity(i) == curves[1]->Multiplicity(i));
  }
  for (int k = 0; k < 2; ++k) {
    for (double t = 0; t <= 4; t += 0.01) {
      const gp_Pnt2d uv = p_curve->Value(t);
      CHECK(curves[k]->Value(t).Distance(surfaces[k]->Value(uv.X(), uv.Y())) < kFitError);
    }
  }
}

TEST_CASE("The deviation of exact edges is rounding, that of trims the error of their fit") {
  CHECK(trim_deviation(make_shell({pn::test::torus(5, 2)})) < 1e-14);
  CHECK(trim_deviation(make_shell(pn::test::sphere_halves())) < 1e-14);
  const double wavy = trim_deviation(make_shell({pn::test::wavy_tube()}));
  CHECK(wavy > 1e-13);
  CHECK(wavy < kFitError);
}

TEST_CASE("The deviation of an edge that leaves its surface is seen") {
  const TopoDS_Shell shell =
      make_shell({within(pn::test::paraboloid(), {pn::test::oval({0, 0}, 0.5, 0.5)})});
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(shell, TopAbs_EDGE).Current());
  double first, last;
  const auto curve =
      Handle(Geom_BSplineCurve)::DownCast(BRep_Tool::Curve(edge, first, last)->Copy());
  SECTION("everywhere") {
    curve->Translate(gp_Vec(0, 0, 1e-5));
    BRep_Builder().UpdateEdge(edge, curve, 1e-7);
    CHECK(trim_deviation(shell) == Approx(1e-5).epsilon(1e-4));
  }
  SECTION("between the ends") {
    const int middle = curve->NbPoles() / 2;
    curve->SetPole(middle, curve->Pole(middle).Translated(gp_Vec(0, 0, 1e-5)));
    BRep_Builder().UpdateEdge(edge, curve, 1e-7);
    CHECK(trim_deviation(shell) > 1e-6);
    CHECK(trim_deviation(shell) < 1e-5);
  }
}

TEST_CASE("Caps have no p-curves and do not count") {
  const auto shell = make_shell({pn::test::tube(2, 0, 2, 5)});
  CHECK(trim_deviation(pn::make_capped_solid(shell)) == trim_deviation(shell));
}

TEST_CASE("What OpenCASCADE refuses as a p-curve is reported in its words") {
  const pn::ParameterCurve falling{1, {1, 0}, {2, 2}, {{0, 0}, {1, 1}}};
  CHECK_THROWS_AS(to_geometry(falling), pn::OcctError);
}
