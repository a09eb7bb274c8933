// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/caps.hpp"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <gp_Pln.hxx>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "pn/occt/free_boundary.hpp"
#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

// A leg of a control polygon.
struct Leg {
  gp_Pnt start;
  gp_Pnt end;
};

// The stretch of a B-spline curve that an edge covers.
Handle(Geom_BSplineCurve) curve_of(const TopoDS_Edge& edge) {
  double first, last;
  const auto curve =
      Handle(Geom_BSplineCurve)::DownCast(BRep_Tool::Curve(edge, first, last)->Copy());
  if (first > curve->FirstParameter() || last < curve->LastParameter()) curve->Segment(first, last);
  return curve;
}

// The control polygon of a closed wire of B-spline edges: legs in the direction of the wire, in any
// order. Each pole starts one leg.
std::vector<Leg> control_polygon(const TopoDS_Wire& wire) {
  std::vector<Leg> legs;
  for (TopExp_Explorer explorer(wire, TopAbs_EDGE); explorer.More(); explorer.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(explorer.Current());
    const auto curve = curve_of(edge);
    const bool forward = edge.Orientation() == TopAbs_FORWARD;
    for (int i = 1; i < curve->NbPoles(); ++i) {
      const gp_Pnt pole = curve->Pole(i);
      const gp_Pnt next = curve->Pole(i + 1);
      legs.push_back(forward ? Leg{pole, next} : Leg{next, pole});
    }
  }
  return legs;
}

gp_Pnt centroid(const std::vector<Leg>& polygon) {
  gp_XYZ sum(0, 0, 0);
  for (const Leg& leg : polygon) sum += leg.start.XYZ();
  return gp_Pnt(sum / static_cast<double>(polygon.size()));
}

// The plane around which a closed polygon runs counterclockwise: its normal is the vector area.
gp_Pln plane_of(const std::vector<Leg>& polygon) {
  const gp_Pnt centre = centroid(polygon);
  gp_Vec area(0, 0, 0);
  for (const Leg& leg : polygon) area += gp_Vec(centre, leg.start).Crossed({centre, leg.end});
  return gp_Pln(centre, gp_Dir(area));
}

// A curve with positive weights stays in the convex hull of its poles: it is no further from the
// plane than they are.
double distance_from(const gp_Pln& plane, const std::vector<Leg>& polygon) {
  double distance = 0;
  for (const Leg& leg : polygon) distance = std::max(distance, plane.Distance(leg.start));
  return distance;
}

std::string not_flat(double distance) {
  std::ostringstream sentence;
  sentence << "An open end of the surface is not flat: it leaves its plane by up to "
           << std::setprecision(3) << distance
           << " mm, so no face closes it. A wall between two offsets needs none.";
  return sentence.str();
}

// The planar face to the left of `boundary`.
TopoDS_Face cap(const TopoDS_Wire& boundary) {
  const std::vector<Leg> polygon = control_polygon(boundary);
  const gp_Pln plane = plane_of(polygon);
  const double distance = distance_from(plane, polygon);
  if (distance > Precision::Confusion()) throw std::invalid_argument(not_flat(distance));
  const BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(plane), Precision::Confusion());
  builder.Add(face, boundary);
  return face;
}

}  // namespace

TopoDS_Solid make_capped_solid(const TopoDS_Shell& shell) {
  return with_occt_errors([&] { return solid_inside(closed_by(cap, shell)); });
}

}  // namespace pn
