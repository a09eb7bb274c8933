// SPDX-License-Identifier: LGPL-2.1-or-later
// Skin patches: a sheet of a quadratic family over its triangle, in some chart of its normals.
//
// The edges of the triangle are no rational curves in a chart of normals, but of genus 1: one of
// them is the intersection of the sphere of normals with a quadric cone. They are known pointwise,
// as the solutions of a / e = u and b / e = v (contact_solver.hpp).
//
// THEOREM. Let Delta > 0 on the triangle and let the Bernstein coefficients of the weight be
// positive on a chart that contains the image of the triangle's edges. Then the chart has no fold
// there, and maps what is inside the edges onto the triangle, one to one. Proof: the weight is e^2
// w4 up to a positive factor, so e does not vanish, and the map from normals to (u, v) is a local
// diffeomorphism (along_surface.hpp); it is one to one on the edges, so the inside covers the
// triangle once. QED
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "pn/bezier/parameter_curve.hpp"
#include "pn/isotropic/along_surface.hpp"
#include "pn/isotropic/sheet.hpp"

namespace pn {

struct SkinPatch {
  std::array<int, 2> degree;
  /// Its sections over [0, 1]^2, enclosed at this precision [bits].
  std::function<SurfaceSections<RealBall>(long)> sections;
  /// Where a point (u, v) of the triangle lies on [0, 1]^2.
  std::function<std::array<double, 2>(const std::array<double, 2>&)> place_of;
  Sheet sheet;
  /// The smallest weight in parts of the largest, by Bernstein coefficients.
  double weight_ratio;
};

/// The point of an edge of the triangle, over [0, 1]; the edges run counterclockwise in (u, v),
/// from the corner w = 1.
std::array<double, 2> on_edge(std::size_t edge, double at);

/// Points (u, v) along all edges, counterclockwise.
std::vector<std::array<double, 2>> edge_points();

/// The boundary of a patch, one edge of the triangle after the other, the inside on the left. On
/// the inner sheet, which is seen from the other side, it runs clockwise around the triangle.
std::array<ParameterPath, 3> boundary(const SkinPatch& patch);

/// Patches whose weights vary by more are avoided.
inline constexpr double kEvenWeights = 0.05;

/// The smallest of the Bernstein coefficients in parts of the largest.
double least_ratio(const TensorPolynomial<RealBall>& weight);

/// What was seen of an image, with a margin for what it does between the points that were looked
/// at.
struct ImageBox {
  std::array<double, 2> low, high;
};
ImageBox box_around(const std::vector<std::array<double, 2>>& points);

}  // namespace pn
