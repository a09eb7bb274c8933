// SPDX-License-Identifier: LGPL-2.1-or-later
// Open ends closed by the spheres that touch the surface along them.
//
// THEOREM. A canal surface touches the sphere of its last parameter along its last circle. So the
// part of that sphere beyond the circle continues the surface with the same tangent planes.
//
// The stereographic projection from the point opposite the middle of the cap is a central
// projection; it maps the circle to a circle, and a circle in a plane parallel to that of the
// projection by a similarity. So in the coordinates
//
//     S(x, y) = c + rho (2 k (x e1 + y e2) + (1 - k^2 (x^2 + y^2)) a) / (1 + k^2 (x^2 + y^2))
//
// of the sphere, with k = tan(alpha / 2) where the cap reaches to the angle alpha from its middle
// c + rho a, the circle is the unit circle and its p-curve is the very edge seen along the axis:
// rational of the same degree, over the same knots. S is biquadratic, without pole and seam.
#pragma once

#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

namespace pn {

/// A closed shell: the faces of `shell` and on every free boundary the cap of the sphere that
/// touches them there. Caps use the very edges of the boundary.
///
/// A closed shell comes back as a copy. Throws std::invalid_argument when a free boundary is not
/// closed, or when no sphere touches the faces along it to within OpenCASCADE's tolerance, 1e-7 mm.
TopoDS_Shell make_domed_shell(const TopoDS_Shell& shell);

/// The solid inside the domed shell, its faces pointing outwards.
TopoDS_Solid make_domed_solid(const TopoDS_Shell& shell);

}  // namespace pn
