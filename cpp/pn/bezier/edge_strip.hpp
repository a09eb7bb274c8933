// SPDX-License-Identifier: LGPL-2.1-or-later
// Edge strips: the canal surface of the spheres along an edge of a quadratic family, between its
// two skins.
//
// The spheres along an edge are a parabola in R^{3,1}, so the envelope of theirs has a spinor A(t)
// of degree 1 and sections of bidegree (4, 2); or of twice this in t where the edge and its radius
// are so that D has real roots beyond its ends (contact_circles.hpp). Outside the triangle the
// union of all spheres is bounded by the normals with <w, f_inwards> <= 0, the arc of each circle
// from the inner to the outer skin. It touches both along the edge, where it has their normals.
//
// Around the circle u = F p(s) with a constant F and a quadratic p, an arc of a circle itself:
// bidegree (4, 4) as a rule, with positive weights in one patch.
#pragma once

#include "pn/bezier/exact_patch.hpp"
#include "pn/isotropic/sheet.hpp"

namespace pn {

/// An arc of unit normals over [0, 1].
using NormalArc = std::function<Eigen::Vector3d(double)>;

/// The normals at an end of an edge, 0 or 1, from the inner to the outer skin, evenly.
NormalArc end_arc(const QuadraticFamily& family, std::size_t edge, int end);

/// The strip along an edge of the triangle (skin_patch.hpp), its first parameter along it. The
/// seams are divided at the ends of the skins' patches. Throws GeometryError when no patch with
/// positive weights is found.
ExactPatch edge_strip(const QuadraticFamily& family, std::size_t edge,
                      const std::vector<double>& inner_ends, const std::vector<double>& outer_ends);

}  // namespace pn
