// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/curve_on_surface.hpp"

#include <Adaptor3d_CurveOnSurface.hxx>
#include <AdvApprox_ApproxAFunction.hxx>
#include <AdvApprox_EvaluatorFunction.hxx>
#include <AdvApprox_PrefCutting.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfInteger.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>

#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

// A hundredth of the smallest tolerance that OpenCASCADE knows, in millimetres.
constexpr double kFitError = 1e-9;

// What OpenCASCADE's own approximations of edges use; both are far from reached at 1e-9.
constexpr int kFitDegree = 14;
constexpr int kFitSpans = 1000;

// The error of a fitted span of degree 14 has some 16 extrema: enough points to come near each.
constexpr int kSamplesPerSpan = 64;

using CurveOnSurface = Adaptor3d_CurveOnSurface;

CurveOnSurface curve_on_surface(const Handle(Geom2d_Curve) & p_curve, double first, double last,
                                const Handle(Geom_Surface) & surface) {
  return CurveOnSurface(new Geom2dAdaptor_Curve(p_curve, first, last),
                        new GeomAdaptor_Surface(surface));
}

// Several curves in space as one function of t, with derivatives.
class Images : public AdvApprox_EvaluatorFunction {
 public:
  explicit Images(const std::vector<CurveOnSurface>& curves) : curves_(curves) {}

  void Evaluate(int* /*dimension*/, double* /*start_end*/, double* parameter, int* derivative,
                double* result, int* error) override {
    for (const CurveOnSurface& curve : curves_) {
      const gp_XYZ value = *derivative == 0 ? curve.Value(*parameter).XYZ()
                                            : curve.DN(*parameter, *derivative).XYZ();
      for (int i = 1; i <= 3; ++i) *result++ = value.Coord(i);
    }
    *error = 0;
  }

 private:
  const std::vector<CurveOnSurface>& curves_;
};

// Where a curve is not analytic: at knots of the p-curve and where it crosses knots of the surface.
TColStd_Array1OfReal breaks(const CurveOnSurface& curve) {
  TColStd_Array1OfReal result(1, curve.NbIntervals(GeomAbs_CN) + 1);
  curve.Intervals(result, GeomAbs_CN);
  return result;
}

std::vector<Handle(Geom_BSplineCurve)> fitted(const std::vector<CurveOnSurface>& curves) {
  const int count = static_cast<int>(curves.size());
  const Handle(TColStd_HArray1OfReal) none;
  const Handle(TColStd_HArray1OfReal) errors = new TColStd_HArray1OfReal(1, count, kFitError);
  const AdvApprox_PrefCutting cuts(breaks(curves.front()));
  Images images(curves);
  const AdvApprox_ApproxAFunction fit(
      0, 0, count, none, none, errors, curves.front().FirstParameter(),
      curves.front().LastParameter(), GeomAbs_C1, kFitDegree, kFitSpans, images, cuts);
  if (!fit.IsDone()) {
    throw OcctError("OpenCASCADE could not fit the edge along a trim to 1e-9 mm.");
  }
  std::vector<Handle(Geom_BSplineCurve)> result;
  for (int i = 1; i <= count; ++i) {
    TColgp_Array1OfPnt poles(1, fit.NbPoles());
    fit.Poles(i, poles);
    result.push_back(new Geom_BSplineCurve(poles, fit.Knots()->Array1(),
                                           fit.Multiplicities()->Array1(), fit.Degree()));
  }
  return result;
}

// Greatest distance between two curves at equal parameters.
double deviation(const GeomAdaptor_Curve& edge, const CurveOnSurface& image) {
  TColStd_Array1OfReal spans(1, edge.NbIntervals(GeomAbs_CN) + 1);
  edge.Intervals(spans, GeomAbs_CN);
  double greatest = 0;
  for (int span = 1; span < spans.Length(); ++span) {
    const double step = (spans(span + 1) - spans(span)) / kSamplesPerSpan;
    for (int i = 0; i <= kSamplesPerSpan; ++i) {
      const double t = std::min(spans(span) + i * step, spans(span + 1));
      greatest = std::max(greatest, edge.Value(t).Distance(image.Value(t)));
    }
  }
  return greatest;
}

double deviation_on_face(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double first, last;
  Standard_Boolean is_stored = false;
  const auto p_curve = BRep_Tool::CurveOnSurface(edge, face, first, last, &is_stored);
  if (!is_stored || BRep_Tool::Degenerated(edge)) return 0;
  const auto curve = BRep_Tool::Curve(edge, first, last);
  return deviation(GeomAdaptor_Curve(curve, first, last),
                   curve_on_surface(p_curve, first, last, BRep_Tool::Surface(face)));
}

}  // namespace

Handle(Geom2d_BSplineCurve) to_geometry(const ParameterCurve& curve) {
  const int pole_count = static_cast<int>(curve.poles.size());
  const int knot_count = static_cast<int>(curve.knots.size());
  TColgp_Array1OfPnt2d poles(1, pole_count);
  for (int i = 0; i < pole_count; ++i) {
    const auto& [u, v] = curve.poles[i];
    poles.SetValue(i + 1, gp_Pnt2d(u, v));
  }
  return with_occt_errors([&] {
    return Handle(Geom2d_BSplineCurve)(new Geom2d_BSplineCurve(
        poles, TColStd_Array1OfReal(curve.knots.front(), 1, knot_count),
        TColStd_Array1OfInteger(curve.multiplicities.front(), 1, knot_count), curve.degree));
  });
}

std::vector<Handle(Geom_BSplineCurve)> curves_on_surfaces(
    const Handle(Geom2d_BSplineCurve) & p_curve,
    const std::vector<Handle(Geom_BSplineSurface)>& surfaces) {
  return with_occt_errors([&] {
    std::vector<CurveOnSurface> curves;
    for (const auto& surface : surfaces) {
      curves.push_back(
          curve_on_surface(p_curve, p_curve->FirstParameter(), p_curve->LastParameter(), surface));
    }
    return fitted(curves);
  });
}

double trim_deviation(const TopoDS_Shape& shape) {
  return with_occt_errors([&] {
    double greatest = 0;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
      for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next()) {
        greatest = std::max(greatest, deviation_on_face(TopoDS::Edge(edge.Current()),
                                                        TopoDS::Face(face.Current())));
      }
    }
    return greatest;
  });
}

}  // namespace pn
