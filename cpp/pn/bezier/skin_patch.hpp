// SPDX-License-Identifier: LGPL-2.1-or-later
// Skin patches: a sheet of a quadratic family over its triangle in one chart of normals.
//
// The normals of the sheet are moved near the north pole by an exact rotation, a spinor of short
// doubles, and projected from the south pole: z = s + i t. The chart is the parallelogram z = o + p
// c1 + q c2 around their image, p and q in [0, 1], so that with w = w(p, q) the sheet is a Bezier
// patch (along_surface.hpp). Its directions are fitted to those of u and v: the image of the
// triangle is nearly a triangle again, also where z hardly changes.
//
// The edges of the triangle are no rational curves in (p, q), but of genus 1: one of them is the
// intersection of the sphere of normals with a quadric cone. They are known pointwise, as the
// solutions of a / e = u and b / e = v.
//
// THEOREM. If the Bernstein coefficients of the weight e^2 w4 are positive on the chart, then e
// does not vanish there, (p, q) -> (u, v) is a local diffeomorphism over Delta > 0, and, since it
// is one along the edges of the triangle, a diffeomorphism onto the triangle inside them.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "pn/bezier/parameter_curve.hpp"
#include "pn/isotropic/along_surface.hpp"
#include "pn/isotropic/sheet.hpp"

namespace pn {

struct SkinPatch {
  std::array<int, 2> degree;
  /// Its sections over [0, 1]^2, enclosed at this precision [bits].
  std::function<SurfaceSections<RealBall>(long)> sections;
  /// Its boundary on [0, 1]^2, one edge of the triangle after the other, the inside on the left.
  std::array<ParameterPath, 3> edges;
  /// The smallest weight in parts of the largest, by Bernstein coefficients.
  double weight_ratio;
};

/// The patch in the chart around the normals of the sheet; nothing when they have no such chart.
std::optional<SkinPatch> box_patch(const QuadraticFamily& family, Sheet sheet);

}  // namespace pn
