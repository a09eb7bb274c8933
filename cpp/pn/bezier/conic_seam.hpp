// SPDX-License-Identifier: LGPL-2.1-or-later
// Conic seam: the even lines along a surface of moving ellipses.
//
// With Z and M of ellipse_parameter.hpp the factor F = Z^{-1} M makes the weight constant on the
// circle of u and lets the lines turn as little as possible, M being the product of the least turns
// along the surface. Around a closed surface the ellipse comes back turned, which is given back
// span by span.
//
// Where an ellipse is a single point, the lines go on through it in their old direction.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "pn/bezier/ellipse_parameter.hpp"
#include "pn/bezier/target_lines.hpp"

namespace pn {

class ConicSeam : public TargetLines {
 public:
  /// `spans` in doubles, one after the other, each in its own parameter on [0, 1]. With even lines
  /// the surface is to the right of them as seen from outside, t running upwards.
  ConicSeam(std::vector<HomogeneousConic<double>> spans, bool closed);

 private:
  Eigen::Matrix2d factor(std::size_t span, double t) const override;

  std::vector<HomogeneousConic<double>> spans_;
  std::vector<std::vector<EllipseFrame<double>>> frames_;  ///< on the grid of each span
  std::vector<std::vector<Eigen::Matrix2d>> turns_;        ///< M there
  double turn_per_span_ = 0;
};

}  // namespace pn
