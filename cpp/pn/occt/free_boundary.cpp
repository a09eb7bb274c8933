// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/free_boundary.hpp"

#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeAnalysis_FreeBounds.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <stdexcept>
#include <vector>

namespace pn {
namespace {

std::vector<TopoDS_Wire> free_boundaries(const TopoDS_Shell& shell) {
  const ShapeAnalysis_FreeBounds bounds(shell);
  if (TopExp_Explorer(bounds.GetOpenWires(), TopAbs_WIRE).More()) {
    throw std::invalid_argument("A free boundary of the shell is not closed.");
  }
  std::vector<TopoDS_Wire> wires;
  for (TopExp_Explorer wire(bounds.GetClosedWires(), TopAbs_WIRE); wire.More(); wire.Next()) {
    wires.push_back(TopoDS::Wire(wire.Current().Reversed()));
  }
  return wires;
}

}  // namespace

TopoDS_Shell closed_by(const MakeCap& make_cap, const TopoDS_Shell& shell) {
  const BRep_Builder builder;
  TopoDS_Shell result;
  builder.MakeShell(result);
  for (TopExp_Explorer face(shell, TopAbs_FACE); face.More(); face.Next()) {
    builder.Add(result, face.Current());
  }
  for (const TopoDS_Wire& wire : free_boundaries(shell)) builder.Add(result, make_cap(wire));
  result.Closed(BRep_Tool::IsClosed(result));
  return result;
}

TopoDS_Solid solid_inside(const TopoDS_Shell& shell) {
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

}  // namespace pn
