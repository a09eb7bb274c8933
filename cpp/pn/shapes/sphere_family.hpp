// SPDX-License-Identifier: LGPL-2.1-or-later
// Sphere families: the two skins of a mid-surface with a thickness, from six spheres.
//
// The centres are the control points of a quadratic triangular Bezier surface, the radii those of
// its half thickness. Both skins are rational with rational offsets, without any root
// (quadratic_family.hpp, along_surface.hpp).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "pn/isotropic/quadratic_family.hpp"

namespace pn {

struct SphereFamily {
  QuadraticFamily family;
  std::vector<std::string> notes;  ///< sentences for the user
};

/// The six spheres (x, y, z, r) [mm] in the order b200, b110, b020, b101, b011, b002 as they are.
/// Throws GeometryError: not finite.
QuadraticFamily quadratic_family(const std::array<std::array<double, 4>, 6>& control_spheres);

/// Their family as a mid-surface with a thickness. Throws GeometryError: not finite, centres in one
/// point or on one line, no real envelope somewhere, or skins that have no normals of two
/// parameters.
SphereFamily sphere_family(const std::array<std::array<double, 4>, 6>& control_spheres);

}  // namespace pn
