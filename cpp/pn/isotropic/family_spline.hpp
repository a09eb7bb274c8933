// SPDX-License-Identifier: LGPL-2.1-or-later
// Family splines: families of spheres that are quadratic on every triangle of a parameter plane.
//
// THEOREM. Let f be C1 with Delta > 0. Then the points x_d = m + (r + d) n and the normals n of
// each sheet are continuous: the skins are G1 across all edges. Proof: n solves n.m_s + r_s = n.m_t
// + r_t = 0, and which of the two solutions it is, the sign of n.(m_s x m_t) tells; it depends on
// f_s and f_t continuously, and these do not jump. QED
#pragma once

#include <array>
#include <vector>

#include "pn/algebra/directed_edges.hpp"
#include "pn/isotropic/quadratic_family.hpp"

namespace pn {

using PlanePoint = std::array<Rational, 2>;

/// (b - a) x (c - a): positive where a, b, c run counterclockwise.
inline Rational orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

struct FamilyPiece {
  QuadraticFamily family;
  Triangle corners;                ///< numbers of its corners w = 1, u = 1, v = 1, counterclockwise
  std::size_t designers_triangle;  ///< number of the triangle that it is a part of
};

struct FamilySpline {
  std::vector<PlanePoint> corners;  ///< in the parameter plane
  std::vector<FamilyPiece> pieces;

  DirectedEdges edges() const {
    std::vector<Triangle> triangles;
    for (const FamilyPiece& piece : pieces) triangles.push_back(piece.corners);
    return DirectedEdges(triangles);
  }
};

}  // namespace pn
