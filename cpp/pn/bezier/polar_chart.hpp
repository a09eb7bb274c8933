// SPDX-License-Identifier: LGPL-2.1-or-later
// Polar charts: a sheet across a line where its normals turn back.
//
// Where the Gauss curvature of a sheet changes its sign along a line, its normals fold: the whole
// line has one normal, a base point p0 (base_points.hpp), and the image of a triangle across it is
// a bow tie through p0. The cure is to blow p0 up,
//
//     z = p0 + sigma (d + tau i d),
//
// with d along the bow tie. All of a, b, e vanish at p0, hence have the factor sigma, which is
// divided out: bidegree (3, 4) in (sigma, tau), that of the sections (8, 10). The line is sigma = 0
// now, a parameter line like others.
//
// p0 is a root of a sextic, so the polynomials are balls. They serve a sheet too that such a line
// only comes near to.
#pragma once

#include <vector>

#include "pn/bezier/skin_patch.hpp"

namespace pn {

/// The patches of a sheet around each of its base points, as far as the edges of the triangle can
/// be found in them. Their weights need not be positive.
std::vector<SkinPatch> polar_patches(const QuadraticFamily& family, Sheet sheet);

}  // namespace pn
