// SPDX-License-Identifier: LGPL-2.1-or-later
// Conic seam: the even lines along a surface of moving ellipses, and those along arcs of conics.
//
// With Z and M of conic_parameter.hpp the factor F = Z^{-1} M makes the weight constant on the
// circle of u and lets the lines turn as little as possible, M being the product of the least turns
// along the surface. Around a closed surface the ellipse comes back turned, which is given back
// span by span.
//
// Where an ellipse is a single point, the lines go on through it in their old direction.
//
// The lines of arcs are those from end to end: F = Z^{-1} E, the columns of E being the ends of the
// half circle of z and a margin beyond, so that the arc is in the band u = (1 - s : s), s in [0,
// 1]. At zero margin its weights on the band are 1, l k, 1 with h = w - l q_c and q_c = 2 k s (1 -
// s).
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "pn/bezier/conic_parameter.hpp"
#include "pn/bezier/target_lines.hpp"

namespace pn {

class ConicSeam : public TargetLines {
 public:
  /// `spans` in doubles, one after the other, each in its own parameter on [0, 1]. With even lines
  /// the surface is to the right of them as seen from outside, t running upwards.
  ConicSeam(std::vector<ConicForms<double>> spans, bool closed);

 private:
  Eigen::Matrix2d factor(std::size_t span, double t) const override;

  std::vector<ConicForms<double>> spans_;
  std::vector<std::vector<ConicFrame<double>>> frames_;  ///< on the grid of each span
  std::vector<std::vector<Eigen::Matrix2d>> turns_;      ///< M there
  double turn_per_span_ = 0;
};

class ArcLines : public TargetLines {
 public:
  /// `spans` as above, with cuts; the margin is a part of the arc.
  ArcLines(std::vector<ConicForms<double>> spans, double margin);

 private:
  Eigen::Matrix2d factor(std::size_t span, double t) const override;

  std::vector<ConicForms<double>> spans_;
  std::vector<double> direction_;  ///< 1 or -1: in which it runs through the arc, with z or against
  double margin_;
};

}  // namespace pn
