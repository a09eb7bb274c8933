// SPDX-License-Identifier: LGPL-2.1-or-later
// Powell-Sabin families: the skins of a mid-surface with a thickness, from a sphere and a tangent
// plane at each corner of a triangulation.
//
// Every triangle has an inner point Z and is divided into six, by the lines from Z to its corners
// and to a point R on each of its edges.
//
// THEOREM. Let R lie on the line between the inner points Z, Z' of both neighbours. Then there is
// exactly one C1 function that is quadratic on each of the six triangles and has given values and
// gradients at all corners. Its control points are, with the tangent plane T_A of a corner A,
//
//     b(A) = T_A(A),     b(A R) = T_A((A + R) / 2),     b(A Z) = T_A((A + Z) / 2),
//     b(R) and b(R Z) between those of A and of B as R between A and B,
//     b(Z) among the b(A Z) as Z among the corners.
//
// (M. J. D. Powell, M. A. Sabin, Piecewise quadratic approximations on triangles, ACM TOMS 3,
// 1977.) Proof: C1 at A gives the first line, C1 across R Z the second one, C1 around Z the third
// one; and with all three it is C1 inside the triangle. Across the edge A B the derivative in
// direction Z - R is linear on both halves and, by the second line, on the whole edge: so it is
// known from A and B. Z' - R is a negative multiple of Z - R, so the neighbour has the same
// derivative there, and the same values. QED
//
// Z is near the centre of the inscribed circle. Its lines to the ends of an edge halve the angles
// there, so that the line from Z to Z' leaves both triangles between them. At the border R is the
// middle of the edge. All of this is over Q.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "pn/isotropic/family_spline.hpp"
#include "pn/shapes/planar_triangulation.hpp"

namespace pn {

/// (m, -r) at a parameter (s, t), and its derivatives by s and by t.
struct VertexJet {
  MinkowskiVector<Rational> value, by_s, by_t;
};

/// The spline with these spheres and derivatives at the points of a triangulation; the pieces of a
/// triangle are six in a row. Throws GeometryError when a triangle is so thin that the line between
/// two inner points misses the common edge.
FamilySpline powell_sabin(const PlanarTriangulation& triangulation,
                          const std::vector<VertexJet>& jets);

/// What a designer gives at a point: lengths in mm, (x, y, z, r).
struct PlacedSphere {
  std::array<double, 2> parameter;
  std::array<double, 4> sphere;
  std::array<std::array<double, 4>, 2> derivatives;  ///< by both parameters
};

struct PowellSabinFamily {
  FamilySpline spline;
  std::vector<std::string> notes;  ///< sentences for the user
};

/// Throws GeometryError: a number that is not finite, what is no triangulation of the parameters
/// (planar_triangulation.hpp), and no real envelope somewhere over a triangle.
PowellSabinFamily powell_sabin_family(const std::vector<PlacedSphere>& spheres,
                                      const std::vector<Triangle>& triangles);

}  // namespace pn
