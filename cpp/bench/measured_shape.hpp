// SPDX-License-Identifier: LGPL-2.1-or-later
// What a shape is measured by: its faces and poles, how far it is from the truth, and what is left
// of it after a STEP file. The same for every shape, whoever made it.
#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
#include <functional>

#include "surface_point.hpp"

namespace pn::bench {

/// How far [mm] a point is from where it should be, with a sign.
using PointError = std::function<long double(const Point&)>;

struct ShapeMeasures {
  std::size_t faces;
  /// Of the B-spline surfaces under the faces; zero where all faces lie on others.
  std::size_t poles;
  std::array<int, 2> degree;
  double deviation;  ///< [mm], the largest at points of a grid within each face
};

/// B-spline surfaces are evaluated in long double, others by OpenCASCADE.
ShapeMeasures measure(const TopoDS_Shape& shape, const PointError& error);

/// A STEP file, every double written with 17 digits, and what OpenCASCADE reads from it.
struct StepRoundTrip {
  std::size_t bytes;
  TopoDS_Shape read;
};

StepRoundTrip through_step(const TopoDS_Shape& shape);

}  // namespace pn::bench
