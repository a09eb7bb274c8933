// SPDX-License-Identifier: LGPL-2.1-or-later
// Mirrors: the wavefronts of light that a rational surface reflects, exactly.
//
// Light leaves a plane or a point at path length 0, meets the mirror x with normal N, and is
// reflected. The surfaces of equal path length d are perpendicular to the reflected rays (E. L.
// Malus, 1808; C. Dupin, 1822), so they are offsets of each other, the anticaustics of the mirror.
//
// THEOREM 1 (parallel light). Let light of direction e leave the plane through p perpendicular to
// e. With s = (x - p).e / e.e its wavefronts are
//
//     x_d = x - s r + (d / |e|) r,     r = e - 2 (e.N) N / N.N,     |r| = |e|:
//
// PN surfaces for every rational mirror, and up to |e| over Q. Every PN surface is a wavefront of
// this kind. (M. Peternell, dissertation TU Wien 1997, section 3.6 and theorem 4.1.) Proof: r is e
// reflected at the tangent plane; x_d is d - s |e| from x on its ray; and x_d.r is constant to
// first order, since r.dx = e.dx = |e|^2 ds by N.dx = 0, and r.dr = 0. QED.
//
// THEOREM 2 (point source). The wavefronts of light from a point s are
//
//     x_d = x_0 + (d / |x - s|) (x - x_0),     x_0 = s + 2 ((x - s).N) N / N.N:
//
// x_0 is s reflected at the tangent planes and rational for every rational mirror, but its offsets
// have rational normals only where |x - s| is rational. (M. Peternell, Rational two-parameter
// families of spheres and rational offset surfaces, section 6.5.) That is decided over Q: for x = X
// / W it holds up to one square root exactly when |X - W s|^2 is a number times a square.
//
// Degrees: for a polynomial mirror of bidegree (p, q) those of x_d for parallel light are at most
// (5 p - 2, 5 q - 2); for a rational one (7 p - 4, 7 q - 4); less by common factors.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "pn/isotropic/rational_sections.hpp"
#include "pn/shapes/spline_surface.hpp"

namespace pn {

/// Light of one direction; paths are counted from the perpendicular plane through a point [mm].
struct ParallelLight {
  std::array<double, 3> direction, from;
};

/// Light from a point [mm].
struct PointLight {
  std::array<double, 3> position;
};

using Light = std::variant<ParallelLight, PointLight>;

/// The wavefronts of all path lengths.
struct Wavefronts {
  std::vector<RationalSections> patches;  ///< one for every patch of the mirror
  double leaving;  ///< at this path length [mm] all light has left the mirror
  std::vector<std::string> notes;
};

/// Throws GeometryError: kNotFinite, those of rational_patches, kZeroLength where the mirror or the
/// direction of light is none or the wavefront a point, kGrazingLight where light runs along the
/// mirror everywhere, kLightOnMirror where a point source is on the mirror or cannot be told from
/// it.
Wavefronts mirror_wavefronts(const SplineSurfaceData& mirror, const Light& light);

}  // namespace pn
