// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/bspline_geometry.hpp"

#include <BRep_Tool.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

bool is_finite(const std::array<double, 3>& point) {
  return std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

bool is_clamped(int degree, const std::vector<int>& multiplicities) {
  return !multiplicities.empty() && multiplicities.front() == degree + 1 &&
         multiplicities.back() == degree + 1;
}

void validate(const BSplineSurface& surface) {
  require(is_clamped(surface.u_degree, surface.u_multiplicities) &&
              is_clamped(surface.v_degree, surface.v_multiplicities),
          "The end knots of a B-spline surface need the multiplicity degree + 1.");
  require(surface.u_knots.size() == surface.u_multiplicities.size() &&
              surface.v_knots.size() == surface.v_multiplicities.size(),
          "Every knot of a B-spline surface needs one multiplicity.");
  require(surface.poles.size() == surface.u_count() * surface.v_count(),
          "The number of poles does not follow from the degrees and the multiplicities.");
  require(surface.weights.size() == surface.poles.size(), "Every pole needs one weight.");
  require(std::all_of(surface.poles.begin(), surface.poles.end(), is_finite),
          "A pole is not finite.");
}

// OpenCASCADE's arrays count from 1.
TColStd_Array1OfReal reals(const std::vector<double>& values) {
  TColStd_Array1OfReal result(1, static_cast<int>(values.size()));
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

TColStd_Array1OfInteger integers(const std::vector<int>& values) {
  TColStd_Array1OfInteger result(1, static_cast<int>(values.size()));
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

template <class Array>
auto as_vector(const Array& array) {
  return std::vector<typename Array::value_type>(array.begin(), array.end());
}

// A clamped knot of a periodic spline has the multiplicity `degree`, one less than otherwise.
std::vector<int> clamped(std::vector<int> multiplicities, int degree) {
  require(multiplicities.front() >= degree && multiplicities.back() >= degree,
          "The B-spline surface is not clamped.");
  multiplicities.front() = multiplicities.back() = degree + 1;
  return multiplicities;
}

}  // namespace

Handle(Geom_BSplineSurface) to_geometry(const BSplineSurface& surface) {
  validate(surface);
  const int rows = static_cast<int>(surface.u_count());
  const int columns = static_cast<int>(surface.v_count());
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const auto& [x, y, z] = surface.poles[i * columns + j];
      poles.SetValue(i + 1, j + 1, gp_Pnt(x, y, z));
      weights.SetValue(i + 1, j + 1, surface.weights[i * columns + j]);
    }
  }
  return with_occt_errors([&] {
    return Handle(Geom_BSplineSurface)(new Geom_BSplineSurface(
        poles, weights, reals(surface.u_knots), reals(surface.v_knots),
        integers(surface.u_multiplicities), integers(surface.v_multiplicities), surface.u_degree,
        surface.v_degree));
  });
}

BSplineSurface from_geometry(const Geom_BSplineSurface& geometry) {
  BSplineSurface surface;
  surface.u_degree = geometry.UDegree();
  surface.v_degree = geometry.VDegree();
  surface.u_knots = as_vector(geometry.UKnots());
  surface.v_knots = as_vector(geometry.VKnots());
  surface.u_multiplicities = clamped(as_vector(geometry.UMultiplicities()), surface.u_degree);
  surface.v_multiplicities = clamped(as_vector(geometry.VMultiplicities()), surface.v_degree);
  // Only a periodic surface has fewer poles than its clamped form: there the index wraps around.
  for (std::size_t i = 0; i < surface.u_count(); ++i) {
    for (std::size_t j = 0; j < surface.v_count(); ++j) {
      const int row = static_cast<int>(i) % geometry.NbUPoles() + 1;
      const int column = static_cast<int>(j) % geometry.NbVPoles() + 1;
      const gp_Pnt pole = geometry.Pole(row, column);
      surface.poles.push_back({pole.X(), pole.Y(), pole.Z()});
      surface.weights.push_back(geometry.Weight(row, column));
    }
  }
  return surface;
}

std::vector<BSplineSurface> bspline_surfaces(const TopoDS_Shape& shape) {
  std::vector<BSplineSurface> surfaces;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    const auto surface = BRep_Tool::Surface(TopoDS::Face(face.Current()));
    const auto geometry = Handle(Geom_BSplineSurface)::DownCast(surface);
    require(!geometry.IsNull(), "A face does not lie on a B-spline surface.");
    surfaces.push_back(from_geometry(*geometry));
  }
  return surfaces;
}

}  // namespace pn
