// SPDX-License-Identifier: LGPL-2.1-or-later
// What kind a quadratic family of spheres is.
//
// The lines at infinity of the tangent planes have Pluecker coordinates of degree two in (u, v).
// When they satisfy two linear equations they lie in a net, and the polar lines, those of the
// normal planes, in the polar net. (D. Gruber, Diplomarbeit, TU Wien 2008, chapter 3.) Otherwise
// they are the chords of a cubic, or of a degenerate one.
#pragma once

#include <optional>
#include <string>

#include "pn/isotropic/quadratic_family.hpp"
#include "pn/minkowski/net_type.hpp"

namespace pn {

/// Of the lines at infinity of the normal planes, when these satisfy two linear equations and not
/// more.
std::optional<LineNet> normal_net(const QuadraticFamily& family);

/// Classes as `affine_class` names them.
struct FamilyType {
  std::string family, centres, radius;
  std::optional<NetType> net;
};
FamilyType family_type(const QuadraticFamily& family);

/// Of the tangent plane at (u, v). The envelope is real where it is space-like.
CausalType tangent_plane_type(const QuadraticFamily& family, const Rational& u, const Rational& v);

}  // namespace pn
