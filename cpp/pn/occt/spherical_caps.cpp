// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/spherical_caps.hpp"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Ax2.hxx>
#include <stdexcept>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"
#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/free_boundary.hpp"
#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

// The sides of the patch stay clear of the unit circle by a quarter.
constexpr double kHalfWidth = 1.25;

// A sphere is found from the points and normals at so many places of each edge; two would do.
constexpr int kContactsPerEdge = 16;

// Where a cap meets the shell.
struct Contact {
  gp_XYZ point;
  gp_XYZ normal;  // Of the shell, of unit length.
  gp_XYZ along;   // Of unit length, the cap to its left.
};

using FacesOfEdge = TopTools_IndexedDataMapOfShapeListOfShape;

FacesOfEdge faces_of_edges(const TopoDS_Shell& shell) {
  FacesOfEdge faces;
  TopExp::MapShapesAndAncestors(shell, TopAbs_EDGE, TopAbs_FACE, faces);
  return faces;
}

std::vector<TopoDS_Edge> edges_of(const TopoDS_Wire& wire) {
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer edge(wire, TopAbs_EDGE); edge.More(); edge.Next()) {
    edges.push_back(TopoDS::Edge(edge.Current()));
  }
  return edges;
}

double orientation_sign(const TopoDS_Shape& shape) {
  return shape.Orientation() == TopAbs_REVERSED ? -1 : 1;
}

void add_contacts(const TopoDS_Edge& edge, const TopoDS_Face& face,
                  std::vector<Contact>& contacts) {
  double first, last;
  const auto p_curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  const auto surface = BRep_Tool::Surface(face);
  for (int i = 0; i < kContactsPerEdge; ++i) {
    const double t = first + (last - first) * (i + 0.5) / kContactsPerEdge;
    gp_Pnt2d uv;
    gp_Vec2d step;
    p_curve->D1(t, uv, step);
    gp_Pnt point;
    gp_Vec s_u, s_v;
    surface->D1(uv.X(), uv.Y(), point, s_u, s_v);
    const gp_XYZ normal = s_u.Crossed(s_v).Normalized().XYZ() * orientation_sign(face);
    const gp_XYZ along = (step.X() * s_u + step.Y() * s_v).Normalized().XYZ();
    contacts.push_back({point.XYZ(), normal, along * orientation_sign(edge)});
  }
}

std::vector<Contact> contacts_along(const TopoDS_Wire& wire, const FacesOfEdge& faces) {
  std::vector<Contact> contacts;
  for (const TopoDS_Edge& edge : edges_of(wire)) {
    add_contacts(edge, TopoDS::Face(faces.FindFromKey(edge).First()), contacts);
  }
  return contacts;
}

template <class Value>
auto mean(const std::vector<Contact>& contacts, const Value& value) {
  auto sum = value(contacts.front());
  for (auto contact = contacts.begin() + 1; contact != contacts.end(); ++contact) {
    sum += value(*contact);
  }
  return sum / static_cast<double>(contacts.size());
}

// The centre of the sphere through the contacts, with their normals: point = centre + rho normal,
// solved by least squares.
gp_XYZ centre_of_sphere(const std::vector<Contact>& contacts) {
  const gp_XYZ point = mean(contacts, [](const Contact& c) { return c.point; });
  const gp_XYZ normal = mean(contacts, [](const Contact& c) { return c.normal; });
  const double numerator =
      mean(contacts, [&](const Contact& c) { return (c.point - point).Dot(c.normal - normal); });
  const double denominator =
      mean(contacts, [&](const Contact& c) { return (c.normal - normal).SquareModulus(); });
  const double rho = numerator / denominator;
  const gp_XYZ centre = point - rho * normal;
  const bool touches = std::all_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
    return (c.point - centre - rho * c.normal).Modulus() <= Precision::Confusion();
  });
  if (!touches) {
    throw std::invalid_argument("No sphere touches the surface along its open end.");
  }
  return centre;
}

// The circle of a cap, and the sphere above it.
struct Cap {
  gp_XYZ centre;  // Of the sphere.
  gp_Ax2 axes;    // The boundary runs counterclockwise around z.
  gp_XYZ middle;  // The unit vector from the centre to the middle of the cap: z or -z.
  double radius;  // Of the circle.
  double height;  // Of the circle above the centre, towards the middle of the cap.
};

Cap cap_along(const std::vector<Contact>& contacts) {
  const gp_XYZ centre = centre_of_sphere(contacts);
  const gp_XYZ point = mean(contacts, [](const Contact& c) { return c.point; });
  // All of these vectors are perpendicular to the plane of the circle.
  const gp_Dir z(mean(contacts, [&](const Contact& c) { return (c.point - point) ^ c.along; }));
  const double inward =
      mean(contacts, [&](const Contact& c) { return (c.normal ^ c.along).Dot(z.XYZ()); });
  const gp_XYZ middle = z.XYZ() * (inward < 0 ? -1 : 1);
  const double height =
      mean(contacts, [&](const Contact& c) { return (c.point - centre).Dot(middle); });
  const gp_XYZ foot = centre + height * middle;
  const double radius =
      mean(contacts, [&](const Contact& c) { return (c.point - foot).Modulus(); });
  return {centre, gp_Ax2(gp_Pnt(foot), z), middle, radius, height};
}

// S(x, y) of the theorem for |x|, |y| <= kHalfWidth. A knot in the middle keeps weights from 1 on.
BSplineSurface patch_of(const Cap& cap) {
  // Control values of x and x^2 over the knots -kHalfWidth, 0, kHalfWidth, by blossoming.
  constexpr std::array<double, 4> x = {-kHalfWidth, -kHalfWidth / 2, kHalfWidth / 2, kHalfWidth};
  constexpr std::array<double, 4> x_squared = {kHalfWidth * kHalfWidth, 0, 0,
                                               kHalfWidth * kHalfWidth};
  const double rho = std::hypot(cap.radius, cap.height);
  const double k = std::tan(std::atan2(cap.radius, cap.height) / 2);
  const gp_XYZ e1 = cap.axes.XDirection().XYZ();
  const gp_XYZ e2 = cap.axes.YDirection().XYZ();
  const std::vector<double> knots = {-kHalfWidth, 0, kHalfWidth};
  BSplineSurface patch{2, 2, knots, knots, {3, 1, 3}, {3, 1, 3}, {}, {}, {}};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double square = k * k * (x_squared[i] + x_squared[j]);
      const gp_XYZ pole =
          cap.centre +
          rho / (1 + square) * (2 * k * (x[i] * e1 + x[j] * e2) + (1 - square) * cap.middle);
      patch.poles.push_back({pole.X(), pole.Y(), pole.Z()});
      patch.weights.push_back(1 + square);
    }
  }
  return patch;
}

// An edge on the circle of a cap, seen along the axis, in units of the radius.
Handle(Geom2d_BSplineCurve) p_curve_of(const Geom_BSplineCurve& edge, const Cap& cap) {
  TColgp_Array1OfPnt2d poles(1, edge.NbPoles());
  TColStd_Array1OfReal weights(1, edge.NbPoles());
  for (int i = 1; i <= edge.NbPoles(); ++i) {
    const gp_Vec arm(cap.axes.Location(), edge.Pole(i));
    poles(i) = gp_Pnt2d(arm.Dot(cap.axes.XDirection()) / cap.radius,
                        arm.Dot(cap.axes.YDirection()) / cap.radius);
    weights(i) = edge.Weight(i);
  }
  return new Geom2d_BSplineCurve(poles, weights, edge.Knots(), edge.Multiplicities(),
                                 edge.Degree());
}

// The face to the left of `wire`, marked as smooth with its neighbours.
TopoDS_Face spherical_cap(const TopoDS_Wire& wire, const FacesOfEdge& faces) {
  const Cap cap = cap_along(contacts_along(wire, faces));
  const BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, to_geometry(patch_of(cap)), Precision::Confusion());
  for (const TopoDS_Edge& edge : edges_of(wire)) {
    double first, last;
    const auto curve = Handle(Geom_BSplineCurve)::DownCast(BRep_Tool::Curve(edge, first, last));
    builder.UpdateEdge(edge, p_curve_of(*curve, cap), face, Precision::Confusion());
    builder.Range(edge, face, first, last);
    builder.Continuity(edge, TopoDS::Face(faces.FindFromKey(edge).First()), face, GeomAbs_G1);
  }
  builder.Add(face, wire);
  return face;
}

}  // namespace

TopoDS_Shell make_domed_shell(const TopoDS_Shell& shell) {
  return with_occt_errors([&] {
    // Edges learn their p-curves on the caps: those of the shell itself stay as they are.
    BRepBuilderAPI_Copy copy(shell, false);
    const TopoDS_Shell own = TopoDS::Shell(copy.Shape());
    const FacesOfEdge faces = faces_of_edges(own);
    return closed_by([&](const TopoDS_Wire& wire) { return spherical_cap(wire, faces); }, own);
  });
}

TopoDS_Solid make_domed_solid(const TopoDS_Shell& shell) {
  return with_occt_errors([&] { return solid_inside(make_domed_shell(shell)); });
}

}  // namespace pn
