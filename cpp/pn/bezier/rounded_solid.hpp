// SPDX-License-Identifier: LGPL-2.1-or-later
// Rounded solids: the boundary of the union of all spheres of a quadratic family.
//
// THEOREM. Let r + d > 0 and |r + d| <= R on the triangle, for the regular radius R of
// quadratic_family.hpp. The two skins, the three strips along the edges and the three lunes at the
// corners are a closed surface with a continuous unit normal, and each offset is the same surface
// with r + d. Proof: The set of all (sphere, w) with <w, f_tau> <= 0 for every direction tau into
// the triangle has these eight parts: both derivatives vanish, or that along an edge, or none. Two
// parts meet where they have the same sphere and the same w, hence the same point and the same
// normal: a strip and a skin along an edge, a lune and a strip along the end circle. No part has a
// singular point, the skins and strips by the corollary there, the lunes as spheres. QED
//
// So it bounds the union of the balls wherever it does not cross itself, and its volume is a cubic
// in d with leading coefficient 4 pi / 3.
#pragma once

#include "pn/bezier/exact_patch.hpp"
#include "pn/isotropic/quadratic_family.hpp"

namespace pn {

/// Faces: those of the outer skin, those of the inner skin, strips, lunes.
class RoundedSolid : public PatchSource {
 public:
  /// Throws GeometryError as for skins, and when a radius is not positive.
  RoundedSolid(const QuadraticFamily& family, std::vector<std::string> notes);

  /// Within it all parts are regular and all spheres are real.
  OffsetRange regular_range() const override;

 private:
  QuadraticFamily family_;
};

}  // namespace pn
