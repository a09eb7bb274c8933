// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/shape_check.hpp"

#include <BOPAlgo_ArgumentAnalyzer.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepCheck.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <array>
#include <sstream>

#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

// A sub-shape by its kind and its number among those of its kind, as FreeCAD names it: "Face2".
std::string name_in(const TopoDS_Shape& shape, const TopoDS_Shape& sub_shape) {
  constexpr std::array kKinds = {"Compound", "CompSolid", "Solid",  "Shell", "Face",
                                 "Wire",     "Edge",      "Vertex", "Shape"};
  TopTools_IndexedMapOfShape same_kind;
  TopExp::MapShapes(shape, sub_shape.ShapeType(), same_kind);
  return kKinds[sub_shape.ShapeType()] + std::to_string(same_kind.FindIndex(sub_shape));
}

// A status in OpenCASCADE's word for it, without the prefix "BRepCheck_".
std::string word(BRepCheck_Status status) {
  std::ostringstream stream;
  BRepCheck::Print(status, stream);
  std::string prefixed;
  std::istringstream(stream.str()) >> prefixed;
  return prefixed.substr(prefixed.find('_') + 1);
}

std::string sentence(BOPAlgo_CheckStatus status) {
  switch (status) {
    case BOPAlgo_BadType:
      return "not a shape for Boolean operations.";
    case BOPAlgo_SelfIntersect:
      return "intersects itself.";
    case BOPAlgo_TooSmallEdge:
      return "the edge is too short.";
    case BOPAlgo_NonRecoverableFace:
      return "the face cannot be rebuilt from its edges.";
    case BOPAlgo_IncompatibilityOfVertex:
      return "the vertices should be one.";
    case BOPAlgo_IncompatibilityOfEdge:
      return "the edges should be one.";
    case BOPAlgo_IncompatibilityOfFace:
      return "the faces should be one.";
    case BOPAlgo_OperationAborted:
      return "the check was aborted.";
    case BOPAlgo_GeomAbs_C0:
      return "the geometry is only C0.";
    case BOPAlgo_InvalidCurveOnSurface:
      return "the curve leaves its surface.";
    case BOPAlgo_NotValid:
      return "the shape is not valid.";
    case BOPAlgo_CheckUnknown:
      break;
  }
  return "unknown fault.";
}

bool is_clean(const BRepCheck_ListOfStatus& statuses) {
  return std::all_of(statuses.begin(), statuses.end(),
                     [](BRepCheck_Status status) { return status == BRepCheck_NoError; });
}

std::vector<std::string> find_faults(const TopoDS_Shape& shape) {
  std::vector<std::string> faults;
  const auto report = [&](const std::string& name, const BRepCheck_ListOfStatus& statuses) {
    for (const BRepCheck_Status status : statuses)
      faults.push_back(name + ": " + word(status) + ".");
  };
  const BRepCheck_Analyzer analyzer(shape);
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, parts);
  for (int i = 1; i <= parts.Extent(); ++i) {
    const Handle(BRepCheck_Result)& result = analyzer.Result(parts(i));
    if (result.IsNull()) continue;  // A compound has none of its own.
    if (!is_clean(result->Status())) report(name_in(shape, parts(i)), result->Status());
    for (result->InitContextIterator(); result->MoreShapeInContext();
         result->NextShapeInContext()) {
      if (is_clean(result->StatusOnShape())) continue;
      report(name_in(shape, parts(i)) + " in " + name_in(shape, result->ContextualShape()),
             result->StatusOnShape());
    }
  }
  return faults;
}

std::vector<std::string> find_boolean_faults(const TopoDS_Shape& shape) {
  // The analyzer may raise tolerances: it gets a copy.
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape).Shape();
  BOPAlgo_ArgumentAnalyzer analyzer;
  analyzer.SetShape1(copy);
  analyzer.SetRunParallel(true);
  analyzer.ArgumentTypeMode() = true;
  analyzer.SelfInterMode() = true;
  analyzer.SmallEdgeMode() = true;
  analyzer.RebuildFaceMode() = true;
  analyzer.ContinuityMode() = true;
  analyzer.TangentMode() = true;
  analyzer.MergeVertexMode() = true;
  analyzer.MergeEdgeMode() = true;
  analyzer.CurveOnSurfaceMode() = true;
  analyzer.Perform();
  std::vector<std::string> faults;
  for (const BOPAlgo_CheckResult& result : analyzer.GetCheckResult()) {
    std::string names;
    for (const TopoDS_Shape& faulty : result.GetFaultyShapes1()) {
      names += (names.empty() ? "" : ", ") + name_in(copy, faulty);
    }
    faults.push_back(names + ": " + sentence(result.GetCheckStatus()));
  }
  return faults;
}

}  // namespace

std::vector<std::string> faults(const TopoDS_Shape& shape) {
  return with_occt_errors([&] { return find_faults(shape); });
}

std::vector<std::string> boolean_faults(const TopoDS_Shape& shape) {
  return with_occt_errors([&] { return find_boolean_faults(shape); });
}

}  // namespace pn
