// SPDX-License-Identifier: LGPL-2.1-or-later
// Volume and area by adaptive quadrature over every face within its p-curves.
#pragma once

#include <TopoDS_Shape.hxx>

namespace pn {

/// Volume inside the closed shells of `shape`, in mm^3; negative where faces point inwards.
///
/// OpenCASCADE's default, and so FreeCAD's, takes one Gauss panel for a whole face and is some 1e-4
/// off; its adaptive rule is 1e-7 off for a trimmed face and 1e-4 for a face with two poles. This
/// one is split where surface or p-curve are not analytic, and halved until it settles. It agrees
/// with closed forms to 1e-13 (relative), trimmed or not, poles or not, as far as the edges of
/// trims fit their faces. Throws std::invalid_argument when no shell is closed, or a face has no
/// boundary.
double volume(const TopoDS_Shape& shape);

/// Area of the faces of `shape`, in mm^2, as accurate.
double area(const TopoDS_Shape& shape);

/// Area of the faces of `shape`, in mm^2, by one rule on each stretch where surface and p-curve are
/// analytic, never halved: always fast, also where normals vanish inside a face, and good to some
/// digits. Equal faces give equal numbers, which serves to compare them.
double area_by_one_rule(const TopoDS_Shape& shape);

/// A measured quantity with an estimate of its error, which is not a bound.
struct Measure {
  double value;
  double error;
};

/// Volume and area as above. The error is that of the quadrature, the rounding of the integrand,
/// and what the edges of trims leave open: `trim_deviation` times their length (times the size of
/// the shape, for the volume).
Measure measured_volume(const TopoDS_Shape& shape);
Measure measured_area(const TopoDS_Shape& shape);

}  // namespace pn
