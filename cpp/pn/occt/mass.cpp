// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/mass.hpp"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <stdexcept>

#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

// Relative error to ask of the quadrature: little above rounding, because near a pole of a surface
// OpenCASCADE stops far too early and the true error is 1e-10 even so. Smaller still costs tenfold.
constexpr double kQuadratureError = 1e-15;

bool has_closed_shell(const TopoDS_Shape& shape) {
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
    if (BRep_Tool::IsClosed(shell.Current())) return true;
  }
  return false;
}

}  // namespace

double volume(const TopoDS_Shape& shape) {
  return with_occt_errors([&] {
    if (!has_closed_shell(shape)) {
      throw std::invalid_argument("An open shape has no volume.");
    }
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties, kQuadratureError, /*OnlyClosed=*/true);
    return properties.Mass();
  });
}

double area(const TopoDS_Shape& shape) {
  return with_occt_errors([&] {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties, kQuadratureError);
    return properties.Mass();
  });
}

}  // namespace pn
