// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt_pipes.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <GeomFill_Pipe.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Law_BSpFunc.hxx>
#include <Law_BSpline.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColGeom_SequenceOfCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <cmath>

namespace pn::bench {
namespace {

constexpr int kLargestDegree = 11;  // OpenCASCADE's own defaults, and the degree that does best
constexpr int kMostSegments = 100;
constexpr double kAngularTolerance = 1e-4;  // [rad]

Handle(Geom_BezierCurve) spine_of(const BezierCanal& canal) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(canal.spine.size()));
  for (int i = poles.Lower(); i <= poles.Upper(); ++i) {
    const auto& p = canal.spine[static_cast<std::size_t>(i - 1)];
    poles(i) = gp_Pnt(p[0], p[1], p[2]);
  }
  return new Geom_BezierCurve(poles);
}

Handle(Law_BSpline) law_of(const BezierCanal& canal) {
  const int count = static_cast<int>(canal.radius.size());
  TColStd_Array1OfReal poles(1, count), knots(1, 2);
  for (int i = 1; i <= count; ++i) poles(i) = canal.radius[static_cast<std::size_t>(i - 1)];
  knots(1) = 0;
  knots(2) = 1;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(count);
  return new Law_BSpline(poles, knots, multiplicities, count - 1);
}

/// Some direction perpendicular to `axis`, the same for all circles of a nearly parallel family.
gp_Dir perpendicular(const gp_Dir& axis) { return axis.Crossed(gp_Dir(0.3, -0.4, 0.87)); }

Handle(Geom_Circle) circle(const gp_Pnt& centre, const gp_Dir& axis, double radius) {
  return new Geom_Circle(gp_Ax2(centre, axis, perpendicular(axis)), radius);
}

Handle(Geom_Circle) normal_circle(const Handle(Geom_BezierCurve) & spine, double t, double radius) {
  gp_Pnt centre;
  gp_Vec velocity;
  spine->D1(t, centre, velocity);
  return circle(centre, gp_Dir(velocity), radius);
}

/// The circle in which the sphere of parameter t touches the envelope: n.m' + r' = 0.
Handle(Geom_Circle) characteristic_circle(const Handle(Geom_BezierCurve) & spine,
                                          const Handle(Law_BSpline) & law, double t) {
  gp_Pnt centre;
  gp_Vec velocity;
  spine->D1(t, centre, velocity);
  double radius, growth;
  law->D1(t, radius, growth);
  const double sine = -growth / velocity.Magnitude();
  const gp_Dir axis(velocity);
  return circle(centre.Translated(gp_Vec(axis) * (radius * sine)), axis,
                radius * std::sqrt(1 - sine * sine));
}

TopoDS_Wire wire_of(const Handle(Geom_Curve) & curve) {
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve));
}

MadeShape swept(BRepOffsetAPI_MakePipeShell& sweep, Tolerance tolerance) {
  sweep.SetMode(/*IsFrenet=*/false);
  sweep.SetTolerance(tolerance.millimetres, tolerance.millimetres, kAngularTolerance);
  sweep.SetMaxDegree(kLargestDegree);
  sweep.SetMaxSegments(kMostSegments);
  sweep.Build();
  return {sweep.Shape(), sweep.ErrorOnSurface()};
}

MadeShape filled(GeomFill_Pipe& pipe, Tolerance tolerance) {
  pipe.Perform(tolerance.millimetres, /*Polynomial=*/false, GeomAbs_C1, kLargestDegree,
               kMostSegments);
  if (!pipe.IsDone()) throw Standard_Failure("GeomFill_Pipe made no surface");
  return {BRepBuilderAPI_MakeFace(pipe.Surface(), Precision::Confusion()), pipe.ErrorOnSurf()};
}

}  // namespace

MadeShape swept_circle(const BezierCanal& canal, Tolerance tolerance) {
  const Handle(Geom_BezierCurve) spine = spine_of(canal);
  BRepOffsetAPI_MakePipeShell sweep(wire_of(spine));
  sweep.Add(wire_of(normal_circle(spine, 0, canal.radius.front())));
  return swept(sweep, tolerance);
}

MadeShape swept_circle_with_law(const BezierCanal& canal, Tolerance tolerance) {
  const Handle(Geom_BezierCurve) spine = spine_of(canal);
  BRepOffsetAPI_MakePipeShell sweep(wire_of(spine));
  const Handle(Law_Function) law = new Law_BSpFunc(law_of(canal), 0, 1);
  sweep.SetLaw(wire_of(normal_circle(spine, 0, 1)), law);
  return swept(sweep, tolerance);
}

MadeShape filled_pipe(const BezierCanal& canal, Tolerance tolerance) {
  GeomFill_Pipe pipe(spine_of(canal), canal.radius.front());
  return filled(pipe, tolerance);
}

MadeShape filled_pipe_through_circles(const BezierCanal& canal, Tolerance tolerance) {
  constexpr int kCircles = 21;
  const Handle(Geom_BezierCurve) spine = spine_of(canal);
  const Handle(Law_BSpline) law = law_of(canal);
  TColGeom_SequenceOfCurve sections;
  for (int i = 0; i < kCircles; ++i) {
    const double t = static_cast<double>(i) / (kCircles - 1);
    sections.Append(normal_circle(spine, t, law->Value(t)));
  }
  GeomFill_Pipe pipe(spine, sections);
  return filled(pipe, tolerance);
}

MadeShape loft_through_characteristic_circles(const BezierCanal& canal, int circles) {
  const Handle(Geom_BezierCurve) spine = spine_of(canal);
  const Handle(Law_BSpline) law = law_of(canal);
  BRepOffsetAPI_ThruSections loft(/*isSolid=*/false, /*ruled=*/false);
  loft.CheckCompatibility(false);
  for (int i = 0; i < circles; ++i) {
    loft.AddWire(
        wire_of(characteristic_circle(spine, law, static_cast<double>(i) / (circles - 1))));
  }
  loft.Build();
  return {loft.Shape()};
}

}  // namespace pn::bench
