// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measured_shape.hpp"

#include <unistd.h>

#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/step.hpp"

namespace pn::bench {
namespace {

using Evaluation = std::function<Point(double, double)>;

Evaluation evaluation(const Geom_BSplineSurface& surface) {
  return [points = SurfacePoints(from_geometry(surface))](double u, double v) {
    return points.at(u, v);
  };
}

Evaluation evaluation(const Handle(Geom_Surface) & surface) {
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface)) {
    return evaluation(*spline);
  }
  return [surface](double u, double v) {
    const gp_Pnt p = surface->Value(u, v);
    return Point(p.X(), p.Y(), p.Z());
  };
}

/// Throws std::runtime_error when an error is not a number, which a maximum would hide, and when no
/// point of the grid lies in the face.
double deviation(const TopoDS_Face& face, const PointError& error) {
  constexpr int kAlong = 97, kAround = 61;  // odd, so that the grid misses the knots
  double u_first, u_last, v_first, v_last;
  BRepTools::UVBounds(face, u_first, u_last, v_first, v_last);
  BRepTopAdaptor_FClass2d region(face, Precision::PConfusion());
  const Evaluation point = evaluation(BRep_Tool::Surface(face));
  long double largest = -1;
  for (int i = 0; i <= kAlong; ++i) {
    for (int j = 0; j <= kAround; ++j) {
      const gp_Pnt2d at(u_first + (u_last - u_first) * i / kAlong,
                        v_first + (v_last - v_first) * j / kAround);
      if (region.Perform(at) == TopAbs_OUT) continue;
      const long double size = std::abs(error(point(at.X(), at.Y())));
      if (!std::isfinite(size)) throw std::runtime_error("The error of a point is not a number.");
      largest = std::max(largest, size);
    }
  }
  if (largest < 0) throw std::runtime_error("No point of the grid lies in the face.");
  return static_cast<double>(largest);
}

TopoDS_Compound compound(const std::vector<TopoDS_Shape>& shapes) {
  const BRep_Builder builder;
  TopoDS_Compound result;
  builder.MakeCompound(result);
  for (const TopoDS_Shape& shape : shapes) {
    if (!shape.IsNull()) builder.Add(result, shape);
  }
  return result;
}

/// A file of this process alone, removed at the end of its life.
class TemporaryFile {
 public:
  TemporaryFile()
      : path(std::filesystem::temp_directory_path() /
             ("pn_bench_" + std::to_string(getpid()) + ".step")) {}
  ~TemporaryFile() {
    std::error_code never_written;
    std::filesystem::remove(path, never_written);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path path;
};

}  // namespace

ShapeMeasures measure(const TopoDS_Shape& shape, const PointError& error) {
  ShapeMeasures measures{};
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face& face = TopoDS::Face(faces.Current());
    ++measures.faces;
    measures.deviation = std::max(measures.deviation, deviation(face, error));
    const auto spline = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face));
    if (spline.IsNull()) continue;
    const BSplineSurface surface = from_geometry(*spline);
    measures.poles += surface.poles.size();
    measures.degree = {std::max(measures.degree[0], surface.u_degree),
                       std::max(measures.degree[1], surface.v_degree)};
  }
  return measures;
}

StepRoundTrip through_step(const TopoDS_Shape& shape) {
  const TemporaryFile file;
  write_step(file.path, {{shape, "surface"}});
  return {std::filesystem::file_size(file.path), compound(read_step(file.path))};
}

}  // namespace pn::bench
