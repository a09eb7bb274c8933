// SPDX-License-Identifier: LGPL-2.1-or-later
// The boundary of a face on a B-spline surface, and when two pieces of boundaries are one edge.
//
// Faces that meet carry the same poles along their common side, so that neighbours are found by
// comparing numbers, without a sewing tolerance. Weights may differ by a common factor and knots by
// an affine map: both leave the curve as it is. Trims inside a surface are compared by their images
// in space (shared_edges.hpp).
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"

namespace pn {

/// A clamped rational B-spline curve in space; the conventions are those of BSplineSurface.
struct BoundaryCurve {
  int degree = 0;
  std::vector<double> knots;
  std::vector<int> multiplicities;
  std::vector<std::array<double, 3>> poles;
  std::vector<double> weights;
};

/// The same points in the other direction, over the same interval.
BoundaryCurve reversed(BoundaryCurve curve);

/// True when all poles are the same point.
bool is_degenerate(const BoundaryCurve& curve);

/// True when both curves pass through the same points in the same direction, their parameters
/// differing by an affine map: equal degree, multiplicities and poles (bit for bit), knots and
/// weights equal as far as doubles can tell up to an affine map and a factor.
bool coincide(const BoundaryCurve& a, const BoundaryCurve& b);

/// A piece of one of the four sides of a surface, or the whole of it.
struct SidePiece {
  BoundaryCurve curve;          ///< The whole side, in the direction of rising parameter.
  double first = 0;             ///< Parameters of the curve between which the piece lies:
  double last = 0;              ///< first < last.
  std::array<double, 2> start;  ///< (u, v) at `first`.
  std::array<double, 2> end;    ///< (u, v) at `last`.
  bool rising = true;           ///< The boundary of the face runs from `start` to `end`.
};

/// The same piece on the reversed curve.
SidePiece reversed(const SidePiece& piece);

/// True when the curves coincide and the pieces lie between the same points of them, as far as
/// doubles can tell.
bool coincide(const SidePiece& a, const SidePiece& b);

/// What a face is bounded by: pieces of sides, and trims inside the surface, each a smooth curve
/// (C1, no knot has the multiplicity of the degree).
using BoundaryPiece = std::variant<SidePiece, ParameterCurve>;
using BoundaryLoop = std::vector<BoundaryPiece>;

/// The loops around a face, each with the face to its left. Without trims this is one loop: the
/// sides v = first, u = last, v = last, u = first. A trim with corners is cut there.
///
/// Throws std::invalid_argument when a trim is no clamped B-spline curve or is a single point, and
/// when a loop is empty or not closed.
std::vector<BoundaryLoop> boundary_loops(const BSplineSurface& surface);

}  // namespace pn
