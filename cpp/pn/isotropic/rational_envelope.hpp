// SPDX-License-Identifier: LGPL-2.1-or-later
// Rational envelopes: both sheets of the envelope of a rational surface of spheres.
//
// A surface f(u, v) in R^{3,1} has an envelope with rational normals in u and v exactly when it is
// a MOS surface (from_planes.hpp, theorem 4): PN surfaces plus any rational radius, surfaces in
// isotropic hyperplanes and in light cones are. Otherwise it may become one by a change of its
// parameters.
//
// THEOREM. If u(s, t), v(s, t) is a reparametrization of f by the stereographic w(s, t)
// (reparametrization.hpp), one sheet has the normal n = (w1, w2, w3) / w4. The other one has its
// reflection in the tangent plane of the centres: with N = m_u x m_v at u(s, t), v(s, t)
//
//     n' = n - 2 (n.N / N.N) N,      q' = m - f4 n'.
//
// (M. Peternell, Rational two-parameter families of spheres and rational offset surfaces, sections
// 5.1 and 6; (16) there, with the sign that makes it isotropic.) Where the reparametrization takes
// every (u, v) twice, once for each sheet, both are one surface.
//
// Decided here: squares and solutions over Q, not over an extension of it.
#pragma once

#include <array>
#include <optional>

#include "pn/isotropic/from_planes.hpp"
#include "pn/isotropic/reparametrization.hpp"

namespace pn {

/// Spheres and the sheets q of their envelope, all over the same parameters.
struct RationalEnvelope {
  SphereSurface spheres;
  std::array<OrientedSurface, 2> sheets;
  /// What was put into f, if the parameters are not its own but those of the normals.
  std::optional<Reparametrization> contact;
};

/// The second sheet of f from the first, or the first from the second.
OrientedSurface other_sheet(const OrientedSurface& sheet, const SphereSurface& f);

/// Over the parameters of f if it is a MOS surface, else over its stereographic normals. Throws
/// GeometryError: kZeroLength when the spheres or their centres are a curve, kDevelopable when the
/// sheets are, kNotRational when neither way is rational.
RationalEnvelope rational_envelope(const SphereSurface& f);

}  // namespace pn
