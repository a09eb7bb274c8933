// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/round_trip.hpp"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Message_ProgressScope.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "pn/occt/mass.hpp"
#include "pn/occt/occt_error.hpp"
#include "pn/occt/shape_check.hpp"

namespace pn {
namespace {

using Spline = Handle(Geom_BSplineSurface);

// A placement is written as a point and two unit vectors, which are made orthonormal again when
// they are read: some units in the last place of its numbers.
constexpr double kPlacementRounding = 1e-15;

std::vector<TopoDS_Shape> parts(const std::vector<TopoDS_Shape>& shapes, TopAbs_ShapeEnum kind) {
  std::vector<TopoDS_Shape> result;
  for (const TopoDS_Shape& shape : shapes) {
    for (TopExp_Explorer part(shape, kind); part.More(); part.Next()) {
      result.push_back(part.Current());
    }
  }
  return result;
}

template <class Array>
bool equal(const Array& a, const Array& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

bool same_numbers(const Geom_BSplineSurface& a, const Geom_BSplineSurface& b) {
  if (a.UDegree() != b.UDegree() || a.VDegree() != b.VDegree() || a.NbUPoles() != b.NbUPoles() ||
      a.NbVPoles() != b.NbVPoles() || !equal(a.UKnots(), b.UKnots()) ||
      !equal(a.VKnots(), b.VKnots()) || !equal(a.UMultiplicities(), b.UMultiplicities()) ||
      !equal(a.VMultiplicities(), b.VMultiplicities())) {
    return false;
  }
  for (int i = 1; i <= a.NbUPoles(); ++i) {
    for (int j = 1; j <= a.NbVPoles(); ++j) {
      const gp_XYZ& p = a.Pole(i, j).XYZ();
      const gp_XYZ& q = b.Pole(i, j).XYZ();
      if (p.X() != q.X() || p.Y() != q.Y() || p.Z() != q.Z() || a.Weight(i, j) != b.Weight(i, j)) {
        return false;
      }
    }
  }
  return true;
}

// `surface`, periodic wherever `model` is.
Spline as_periodic_as(const Spline& surface, const Spline& model) {
  const Spline result = Spline::DownCast(surface->Copy());
  if (model->IsUPeriodic() && !result->IsUPeriodic() && result->IsUClosed()) result->SetUPeriodic();
  if (model->IsVPeriodic() && !result->IsVPeriodic() && result->IsVClosed()) result->SetVPeriodic();
  return result;
}

bool came_back(const Spline& written, const Spline& read) {
  return same_numbers(*as_periodic_as(written, read), *read);
}

bool is_near(const TopLoc_Location& a, const TopLoc_Location& b) {
  const gp_Trsf first = a.Transformation();
  const gp_Trsf second = b.Transformation();
  const double reach = first.TranslationPart().Modulus();
  for (int row = 1; row <= 3; ++row) {
    for (int column = 1; column <= 4; ++column) {
      const double scale = column == 4 ? std::max(reach, 1.) : 1.;
      const double difference = std::abs(first.Value(row, column) - second.Value(row, column));
      if (difference > 4 * kPlacementRounding * scale) return false;
    }
  }
  return true;
}

// Compares in the coordinates of the surface itself, or else as it is placed.
bool came_back(const TopoDS_Face& written, const TopoDS_Face& read) {
  TopLoc_Location from, to;
  const Spline own_written = Spline::DownCast(BRep_Tool::Surface(written, from));
  const Spline own_read = Spline::DownCast(BRep_Tool::Surface(read, to));
  if (own_read.IsNull()) return false;
  return (is_near(from, to) && came_back(own_written, own_read)) ||
         came_back(Spline::DownCast(BRep_Tool::Surface(written)),
                   Spline::DownCast(BRep_Tool::Surface(read)));
}

double perimeter(const TopoDS_Shape& face) {
  GProp_GProps edges;
  BRepGProp::LinearProperties(face, edges);
  return edges.Mass();
}

// What the area of a face may change by when both have their edges within the confusion.
double area_slack(const TopoDS_Shape& face) { return 2 * Precision::Confusion() * perimeter(face); }

double diagonal(const std::vector<TopoDS_Shape>& shapes) {
  Bnd_Box box;
  for (const TopoDS_Shape& shape : shapes) BRepBndLib::Add(shape, box);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

bool is_closed(const TopoDS_Shape& shell) { return BRep_Tool::IsClosed(shell); }

std::string sentence(const std::string& subject, const char* what, double before, double after) {
  std::ostringstream text;
  text.precision(15);
  text << subject << what << before << " and comes back with " << after << ".";
  return text.str();
}

class Comparison {
 public:
  Comparison(const std::vector<TopoDS_Shape>& written, const std::vector<TopoDS_Shape>& read)
      : written_(written), read_(read) {}

  RoundTrip run(const Message_ProgressRange& progress) {
    const auto faces = parts(written_, TopAbs_FACE);
    const auto faces_read = parts(read_, TopAbs_FACE);
    result_.faces = faces.size();
    if (faces.size() != faces_read.size()) {
      differs(std::to_string(faces.size()) + " faces were written, " +
              std::to_string(faces_read.size()) + " come back.");
      return result_;
    }
    Message_ProgressScope scope(progress, "Comparing", static_cast<double>(faces.size()) + 1);
    for (std::size_t i = 0; i < faces.size() && scope.More(); ++i, scope.Next()) {
      compare_faces("Face " + std::to_string(i + 1), TopoDS::Face(faces[i]),
                    TopoDS::Face(faces_read[i]));
    }
    if (scope.More()) compare_volumes();
    if (scope.More()) compare_validity();
    return result_;
  }

 private:
  void differs(const std::string& difference) { result_.differences.push_back(difference); }

  void compare_faces(const std::string& name, const TopoDS_Face& written, const TopoDS_Face& read) {
    const auto surface = BRep_Tool::Surface(written);
    if (surface->IsKind(STANDARD_TYPE(Geom_OffsetSurface))) {
      differs(name + " is an offset surface, which other programs lose.");
    }
    if (const Spline spline = Spline::DownCast(surface); !spline.IsNull()) {
      ++result_.bspline_faces;
      result_.poles += static_cast<std::size_t>(spline->NbUPoles() * spline->NbVPoles());
      if (!came_back(written, read)) {
        differs(name + " comes back with other poles, weights or knots.");
      }
    }
    const double before = area_by_one_rule(written);
    const double after = area_by_one_rule(read);
    slack_ += area_slack(written);
    if (!(std::abs(before - after) <= area_slack(written))) {
      differs(sentence(name, " has the area ", before, after));
    }
  }

  void compare_volumes() {
    const double before = volume_inside(written_);
    const double after = volume_inside(read_);
    result_.volume = before;
    if (!(std::abs(before - after) <= slack_ * diagonal(written_))) {
      differs(sentence("What was written", " has the volume ", before, after));
    }
  }

  // The volume inside all closed shells.
  double volume_inside(const std::vector<TopoDS_Shape>& shapes) const {
    double sum = 0;
    for (const TopoDS_Shape& shell : parts(shapes, TopAbs_SHELL)) {
      if (is_closed(shell)) sum += volume(shell);
    }
    return sum;
  }

  // What was not valid before need not be so afterwards.
  void compare_validity() {
    for (const TopoDS_Shape& shape : written_) {
      if (!faults(shape).empty()) return;
    }
    for (const TopoDS_Shape& shape : read_) {
      for (const std::string& fault : faults(shape)) differs("No longer valid: " + fault);
    }
  }

  const std::vector<TopoDS_Shape>& written_;
  const std::vector<TopoDS_Shape>& read_;
  RoundTrip result_;
  double slack_ = 0;  // Of the area of all faces.
};

}  // namespace

RoundTrip compare_round_trip(const std::vector<TopoDS_Shape>& written,
                             const std::vector<TopoDS_Shape>& read,
                             const Message_ProgressRange& progress) {
  return with_occt_errors([&] { return Comparison(written, read).run(progress); });
}

}  // namespace pn
