// SPDX-License-Identifier: LGPL-2.1-or-later
// What a way to a shape gives back, and what OpenCASCADE's ways are asked for.
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <string>

namespace pn::bench {

struct MadeShape {
  TopoDS_Shape shape;
  /// The deviation [mm] that its maker states: a proven bound of this library, an estimate of
  /// OpenCASCADE.
  std::optional<double> stated_deviation = std::nullopt;
  std::string remark = {};
};

/// Distance [mm] that OpenCASCADE is allowed to miss by its own count.
struct Tolerance {
  double millimetres;
};

}  // namespace pn::bench
