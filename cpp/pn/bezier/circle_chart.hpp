// SPDX-License-Identifier: LGPL-2.1-or-later
// Circle charts: a sheet of a translational family, circle by circle of one of its curves.
//
// The normals of a line u = const are an arc of the circle <w, c'(u)> = 0 of the family c(u) +
// d(v). With the spinor A(t) of these circles, t = u or the parameter that stands for it where that
// is no rational one, the chart has the spinors A(t) F(t) (1 - s, s), s in [0, 1], and reaches a
// little beyond the arcs of all u. Its sections are those of along_translation.hpp, of no higher
// degree: (8, 6) for a parabola c. For F is constant, but where the columns of A have the degrees 1
// and 0: there a multiple rho(t) of the second one, rho linear, is added to the first, so that the
// arcs do not drift across the chart. A projective change of parameters makes weights even.
//
// On such a patch the edges u = const are parameter lines, and circles in the Gauss image. So are
// the edges v = const, as <w, d'(v)> = 0, and both are rational curves in space; but t is of the
// degree 2 in their parameters, and s is not rational in t: its square root is that of Delta(t, v).
#pragma once

#include <optional>

#include "pn/bezier/skin_patch.hpp"
#include "pn/isotropic/translational_family.hpp"

namespace pn {

/// The patch of a sheet of c(u) + d(v) over the unit square, along the circles of c; nothing when d
/// is a line, or without positive weights. Delta > 0 on the square.
std::optional<SkinPatch> circle_patch(const TranslationalFamily& family, Sheet sheet);

}  // namespace pn
