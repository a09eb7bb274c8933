// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrics in standard position, whole or a region of them, and their exact offsets.
//
// THEOREM. The offsets of every regular quadric are rational. (M. Peternell, dissertation TU Wien
// 1997, Theorem 4.6.) The ruled ones are ruled surfaces, of bidegree (4, 4) for the one-sheet
// hyperboloid and (5, 4) for the hyperbolic paraboloid; the others have the isotropic hypersurface
// of another ruled quadric (quadric_pencil.hpp). Cylinders and cones are developable; of those with
// a circle or an ellipse as directrix only the ones of revolution have rational offsets.
//
//     ellipsoid              x^2/a^2 + y^2/b^2 + z^2/c^2 = 1    d > 0 outwards
//     one-sheet hyperboloid  x^2/a^2 + y^2/b^2 - z^2/c^2 = 1    d > 0 away from the axis
//     two-sheet hyperboloid  z^2/c^2 - x^2/a^2 - y^2/b^2 = 1    the sheet z > 0; d > 0 away from
//     the axis elliptic paraboloid    z = c (x^2/a^2 + y^2/b^2)          d > 0 away from the axis
//     hyperbolic paraboloid  z = c (x^2/a^2 - y^2/b^2)          d > 0 upwards
//     elliptic cylinder      x^2/a^2 + y^2/b^2 = 1              d > 0 away from the axis
//     elliptic cone          x^2/a^2 + y^2/b^2 = z^2/c^2        d > 0 away from the axis
//     parabolic cylinder     z = c x^2/a^2                      d > 0 downwards
#pragma once

#include "pn/isotropic/envelope_chain.hpp"
#include "pn/shapes/quadric_region.hpp"

namespace pn {

enum class QuadricKind {
  kEllipsoid,
  kOneSheetHyperboloid,
  kTwoSheetHyperboloid,
  kEllipticParaboloid,
  kHyperbolicParaboloid,
  kEllipticCylinder,
  kEllipticCone,
  kParabolicCylinder,
};

/// The part of the quadric inside the bounds; half-axes in millimetres. Throws GeometryError when a
/// half-axis is not positive, when the bounds are empty, miss the surface or leave it infinite,
/// when they cut it in a way that few faces cannot cover, and for developable quadrics whose offset
/// is not rational.
EnvelopeChain quadric(QuadricKind kind, const std::array<double, 3>& half_axes,
                      const QuadricBounds& bounds);

}  // namespace pn
