// SPDX-License-Identifier: LGPL-2.1-or-later
// What OpenCASCADE finds wrong with a shape.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

namespace pn {

/// The faults that BRepCheck_Analyzer finds, one sentence each: "Edge 3 in Face 1: InvalidRange.";
/// none for a valid shape.
std::vector<std::string> faults(const TopoDS_Shape& shape);

/// The faults of a valid shape as an argument of a Boolean operation: those that FreeCAD's
/// `Shape.check(True)` reports, found by BOPAlgo_ArgumentAnalyzer.
std::vector<std::string> boolean_faults(const TopoDS_Shape& shape);

}  // namespace pn
