// SPDX-License-Identifier: LGPL-2.1-or-later
// Box charts: the parallelogram around the normals of a sheet.
//
// The normals are turned near z = 0 and projected (stereographic.hpp). The chart is the
// parallelogram z = o + p c1 + q c2 around their image, p and q in [0, 1], of short numbers, so
// that with w = w(p, q) the sheet is a Bezier patch over Q (along_surface.hpp). Its directions are
// fitted to those of u and v: the image of the triangle is nearly a triangle again, also where z
// hardly changes.
#pragma once

#include <optional>

#include "pn/bezier/skin_patch.hpp"

namespace pn {

/// The patch of a sheet; nothing when its normals lie on a curve (e = 0 for all w, or what was seen
/// of them has no width). Its weights need not be positive.
std::optional<SkinPatch> box_patch(const QuadraticFamily& family, Sheet sheet);

}  // namespace pn
