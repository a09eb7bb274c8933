// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt_offsets.hpp"

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepOffsetAPI_MakeOffsetShape.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert_ApproxSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <stdexcept>

namespace pn::bench {
namespace {

TopoDS_Face face_on(const Handle(Geom_Surface) & surface) {
  return BRepBuilderAPI_MakeFace(surface, Precision::Confusion());
}

/// The only face of `shape`, stretched along the axes.
TopoDS_Face stretched(const TopoDS_Shape& shape, const std::array<double, 3>& factors) {
  gp_GTrsf stretch;
  for (int axis = 1; axis <= 3; ++axis) {
    stretch.SetValue(axis, axis, factors[static_cast<std::size_t>(axis - 1)]);
  }
  const TopoDS_Shape result = BRepBuilderAPI_GTransform(shape, stretch, /*Copy=*/true).Shape();
  return TopoDS::Face(TopExp_Explorer(result, TopAbs_FACE).Current());
}

TopoDS_Face ellipsoid_face(const QuadricCase& quadric) {
  return stretched(BRepPrimAPI_MakeSphere(1).Face(), quadric.half_axes);
}

/// An arc of r^2 - z^2/c^2 = 1, revolved: (cosh s, 0, c sinh s).
TopoDS_Face one_sheet_face(const QuadricCase& quadric) {
  const auto& [a, b, c] = quadric.half_axes;
  const auto& [low, high] = quadric.bounds.box[2];
  const gp_Ax2 axes(gp::Origin(), gp::DY().Reversed(), gp::DX());  // major axis x, minor axis z
  const Handle(Geom_Curve) arc = new Geom_TrimmedCurve(new Geom_Hyperbola(axes, 1, c),
                                                       std::asinh(low / c), std::asinh(high / c));
  return stretched(face_on(new Geom_SurfaceOfRevolution(arc, gp::OZ())), {a, b, 1});
}

/// A polynomial of degree 2 by its Bezier ordinates.
using Ordinates = std::array<double, 3>;

Ordinates line(double low, double high) { return {low, (low + high) / 2, high}; }
/// Of x(s)^2 where x is that line.
Ordinates square(double low, double high) { return {low * low, low * high, high * high}; }

/// z = c (x^2/a^2 + y^2/b^2), parametrized by (y, x), so that the normal points away from the axis.
TopoDS_Face paraboloid_face(const QuadricCase& quadric) {
  const auto& [a, b, c] = quadric.half_axes;
  const auto& [x_low, x_high] = quadric.bounds.box[0];
  const auto& [y_low, y_high] = quadric.bounds.box[1];
  const Ordinates x = line(x_low, x_high), xx = square(x_low, x_high);
  const Ordinates y = line(y_low, y_high), yy = square(y_low, y_high);
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 1; i <= 3; ++i) {
    for (int j = 1; j <= 3; ++j) {
      const auto u = static_cast<std::size_t>(i - 1), v = static_cast<std::size_t>(j - 1);
      poles(i, j) = gp_Pnt(x[v], y[u], c * (xx[v] / (a * a) + yy[u] / (b * b)));
    }
  }
  return face_on(new Geom_BezierSurface(poles));
}

/// (2 a p, 2 b q, c (1 + p^2 + q^2)) / (1 - p^2 - q^2), parametrized by (q, p).
TopoDS_Face two_sheet_face(const QuadricCase& quadric) {
  const auto& [a, b, c] = quadric.half_axes;
  const Ordinates p = line(-kStereographicReach, kStereographicReach);
  const Ordinates pp = square(-kStereographicReach, kStereographicReach);
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  TColStd_Array2OfReal weights(1, 3, 1, 3);
  for (int i = 1; i <= 3; ++i) {
    for (int j = 1; j <= 3; ++j) {
      const auto u = static_cast<std::size_t>(i - 1), v = static_cast<std::size_t>(j - 1);
      const double squares = pp[u] + pp[v];
      weights(i, j) = 1 - squares;
      poles(i, j) = gp_Pnt(gp_XYZ(2 * a * p[v], 2 * b * p[u], c * (1 + squares)) / (1 - squares));
    }
  }
  return face_on(new Geom_BezierSurface(poles, weights));
}

TopoDS_Face base_face_of(const QuadricCase& quadric) {
  switch (quadric.kind) {
    case QuadricKind::kEllipsoid:
      return ellipsoid_face(quadric);
    case QuadricKind::kOneSheetHyperboloid:
      return one_sheet_face(quadric);
    case QuadricKind::kTwoSheetHyperboloid:
      return two_sheet_face(quadric);
    case QuadricKind::kEllipticParaboloid:
      return paraboloid_face(quadric);
    default:
      throw std::invalid_argument("No quadric of this kind is measured.");
  }
}

TopoDS_Face base_face_of(const BezierRuled& ruled) {
  TColgp_Array2OfPnt poles(1, static_cast<int>(ruled.first.size()), 1, 2);
  for (int i = poles.LowerRow(); i <= poles.UpperRow(); ++i) {
    const auto& first = ruled.first[static_cast<std::size_t>(i - 1)];
    const auto& second = ruled.second[static_cast<std::size_t>(i - 1)];
    poles(i, 1) = gp_Pnt(first[0], first[1], first[2]);
    poles(i, 2) = gp_Pnt(second[0], second[1], second[2]);
  }
  return face_on(new Geom_BezierSurface(poles));
}

Handle(Geom_OffsetSurface) offset_surface(const OffsetCase& offset) {
  return new Geom_OffsetSurface(BRep_Tool::Surface(base_face(offset.base)), offset.distance);
}

std::string name_of(BRepOffset_Error error) {
  switch (error) {
    case BRepOffset_NoError:
      return "BRepOffset_NoError";
    case BRepOffset_BadNormalsOnGeometry:
      return "BRepOffset_BadNormalsOnGeometry";
    case BRepOffset_C0Geometry:
      return "BRepOffset_C0Geometry";
    default:
      return "BRepOffset_Error " + std::to_string(error);
  }
}

}  // namespace

TopoDS_Face base_face(const OffsetBase& base) {
  return std::visit([](const auto& given) { return base_face_of(given); }, base);
}

MadeShape offset_entity(const OffsetCase& offset) { return {face_on(offset_surface(offset))}; }

MadeShape approximated_offset(const OffsetCase& offset, Tolerance tolerance) {
  constexpr int kLargestDegree = 8, kMostSegments = 1000;
  constexpr int kPrecisionCode = 0;  // With 1 the ellipsoid misses 1e-6.
  const GeomConvert_ApproxSurface fit(offset_surface(offset), tolerance.millimetres, GeomAbs_C1,
                                      GeomAbs_C1, kLargestDegree, kLargestDegree, kMostSegments,
                                      kPrecisionCode);
  if (!fit.HasResult()) throw std::runtime_error("GeomConvert_ApproxSurface made no surface");
  return {face_on(fit.Surface()), fit.MaxError(), fit.IsDone() ? "" : "tolerance not reached"};
}

MadeShape joined_offset(const OffsetCase& offset, Tolerance tolerance) {
  BRepOffsetAPI_MakeOffsetShape join;
  join.PerformByJoin(base_face(offset.base), offset.distance, tolerance.millimetres);
  if (!join.IsDone()) throw std::runtime_error(name_of(join.MakeOffset().Error()));
  return {join.Shape()};
}

}  // namespace pn::bench
