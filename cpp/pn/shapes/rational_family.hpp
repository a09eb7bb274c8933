// SPDX-License-Identifier: LGPL-2.1-or-later
// Rational families: two-parameter families of spheres from polynomials, and parts of their skins.
//
// A family is given by its spheres themselves, or by the polar lines of its tangent planes with
// support functions (supported_fibration.hpp). Both skins are over the parameters of the family or
// over stereographic normals, whichever is rational (rational_envelope.hpp).
#pragma once

#include <array>
#include <vector>

#include "pn/isotropic/rational_envelope.hpp"
#include "pn/isotropic/rational_sections.hpp"

namespace pn {

/// Row i holds the coefficients of u^i, by powers of v. Taken as the rationals that they are.
using Coefficients = std::vector<std::vector<double>>;

struct RationalFamily {
  SphereSurface spheres;      ///< over u and v
  RationalEnvelope envelope;  ///< over u and v, or over s and t

  bool is_over_normals() const { return envelope.spheres != spheres; }
};

/// The spheres with centre (x, y, z) / weight and radius r / weight [mm], as f = (m, -r): where r >
/// 0 the normals of the skins point away from the centres. Throws GeometryError: kNotFinite,
/// kNonPositiveWeight, kZeroLength, kNotRational.
RationalFamily family_from_surface(const std::array<Coefficients, 4>& spheres,
                                   const Coefficients& weight);

/// The spheres f = (m, -r) with <c, f> = a, <d, f> = b and the derivatives of these. Throws
/// GeometryError: kNotFinite, kZeroLength, kNotRational.
RationalFamily family_from_net(const std::array<Coefficients, 4>& c,
                               const std::array<Coefficients, 4>& d, const Coefficients& a,
                               const Coefficients& b);

/// The parameters low <= high of a part, over [0, 1].
struct ParameterBounds {
  std::array<double, 2> low, high;
};

/// The part of a sheet over a rectangle of its parameters. Throws GeometryError: kNotFinite,
/// kBadBounds.
RationalSections part_of(const OrientedSurface& sheet, const ParameterBounds& bounds);

}  // namespace pn
