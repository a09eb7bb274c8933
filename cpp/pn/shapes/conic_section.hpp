// SPDX-License-Identifier: LGPL-2.1-or-later
// Moving conic sections: conics in planes along a spine, with half-axes or a profile from the
// vertex given by laws.
//
// The section's plane goes through the point m of the spine, perpendicular to d, which is the
// tangent, or that without its part along up, or a fixed normal. Its directions are e1 = d x up to
// the side and e2 = e1 x d upwards, polynomials without common factor. Their lengths are not
// rational in general, but their squares are polynomials: with m = M / q and the point
//
//     x = m + (y1 e1 + y2 e2) / (q y3),    which is y1 (e1, 0) + y2 (e2, 0) + y3 (M, q),
//
// the ellipse with the true half-axes a along e1 and b along e2 is
//
//     y1^2 |e1|^2 / a^2 + y2^2 |e2|^2 / b^2 = q^2 y3^2,
//
// a family of conics with polynomial coefficients for rational a and b. Coprime polynomials have no
// common zero, so the directions go on smoothly where d and up are parallel for a moment.
//
// FROM THE VERTEX. With the radius of curvature R at the vertex and the conic constant K a conic is
// x^2 = 2 R z - (1 + K) z^2 (K < -1 hyperbola, K = -1 parabola, K > -1 ellipse, K = 0 circle; D.
// Malacara, Optical Shop Testing, 3rd ed. 2007, appendix 1). With z along e2 it is linear in |e2|,
// so |e2| must be rational: sections in parallel or upright planes, along a plane spine with the
// normal of its plane as the up direction, or along a circle or a line. In upright planes, d being
// up x (m' x up), the direction upwards is up itself.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "pn/conics/moving_conic.hpp"
#include "pn/shapes/curve.hpp"

namespace pn {

/// Perpendicular to the spine.
struct PerpendicularPlanes {};

/// Through the direction upwards, and perpendicular to the spine as it is seen along that.
struct UprightPlanes {};

/// Perpendicular to a fixed normal.
struct ParallelPlanes {
  std::array<double, 3> normal;
};

/// Where the sections lie, and which way is up in them.
struct SectionPlanes {
  std::array<double, 3> up;
  std::variant<PerpendicularPlanes, UprightPlanes, ParallelPlanes> kind;
};

/// Ellipses around the spine; lengths in mm.
struct HalfAxes {
  Law sideways, upwards;
};

/// Conics that open upwards from the spine, where their vertex is, as far as depth; lengths in mm.
struct VertexForm {
  Law radius, conic_constant, depth;
};

using ConicSection = std::variant<HalfAxes, VertexForm>;

/// One span for each between breaks of spine and laws. Throws GeometryError: kZeroLength, kBadAxis,
/// kCornerTooSharp, kNotFinite, kDomainMismatch; kNotRational for a vertex form whose |e2| is not.
std::vector<ConicSpan> moving_conic_section(const Curve& spine, const SectionPlanes& planes,
                                            const ConicSection& section);

}  // namespace pn
