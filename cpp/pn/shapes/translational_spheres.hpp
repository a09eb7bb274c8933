// SPDX-License-Identifier: LGPL-2.1-or-later
// Translational spheres: the two skins of a mid-surface with a thickness, from two curves of
// spheres.
//
// One curve of spheres is translated along the other: centres and radii add, f(u, v) = c(u) + d(v).
// With quadratic splines c and d both skins are rational with rational offsets
// (along_translation.hpp), and G1 where the splines are C1.
#pragma once

#include <string>
#include <vector>

#include "pn/isotropic/translational_family.hpp"
#include "pn/shapes/curve.hpp"

namespace pn {

struct TranslationalSpheres {
  TranslationalSpline spline;
  std::vector<std::string> notes;  ///< sentences for the user
};

/// The family c(u) + d(v) of two splines of degree 1 or 2. Throws GeometryError: a degree above 2,
/// a curve that stands still or has a corner, or no real envelope somewhere.
TranslationalSpheres translational_spheres(const SphereSpline& c, const SphereSpline& d);

}  // namespace pn
