// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_seam.hpp"

#include <cmath>
#include <utility>

namespace pn {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector3d;

Matrix2d turn(const EllipseFrame<double>& from, const EllipseFrame<double>& to) {
  const Matrix2d result = lines::midpoint(least_turn(from, to));
  return result.allFinite() ? result : Matrix2d::Identity();
}

Vector3d centre(const HomogeneousConic<double>& x, double t) {
  const Matrix2d inverse = lines::midpoint(ellipse_frame(x, t).circle).inverse();
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < 2; ++k) {
    for (int c = 0; c < 3; ++c) {
      sum[c] += value(x[static_cast<std::size_t>(c)], t, inverse(0, k), inverse(1, k)) / 2;
    }
  }
  return sum;
}

/// How the centres move over a span, to the side from which the ellipses run counterclockwise.
double advance(const HomogeneousConic<double>& span) {
  const EllipseFrame<double> start = ellipse_frame(span, 0.0), end = ellipse_frame(span, 1.0);
  Vector3d normal = Vector3d::Zero();
  for (const EllipseFrame<double>* frame : {&start, &end}) {
    normal += Vector3d(frame->real.data()).cross(Vector3d(frame->imaginary.data()));
  }
  return normal.dot(centre(span, 1) - centre(span, 0));
}

}  // namespace

ConicSeam::ConicSeam(std::vector<HomogeneousConic<double>> spans, bool closed)
    : spans_(std::move(spans)), frames_(spans_.size()), turns_(spans_.size()) {
  Matrix2d turned = Matrix2d::Identity();
  if (advance(spans_.front()) < 0) turned(1, 1) = -1;
  EllipseFrame<double> before = ellipse_frame(spans_.front(), 0.0);
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    for (int g = 0; g <= kGrid; ++g) {
      frames_[i].push_back(ellipse_frame(spans_[i], grid_parameter(g)));
      turned = turn(before, frames_[i].back()) * turned;
      turns_[i].push_back(turned);
      before = frames_[i].back();
    }
  }
  if (closed) {
    // M and -M give the same lines, so the rest is at most a quarter turn.
    const Matrix2d rest = turns_[0][0].transpose() * turn(before, frames_[0][0]) * turned;
    const double angle = std::atan(rest(1, 0) / rest(0, 0));
    turn_per_span_ = -angle / static_cast<double>(spans_.size());
  }
  choose_signs(spans_.size());
}

Matrix2d ConicSeam::factor(std::size_t span, double t) const {
  const std::size_t g = nearest(t);
  const EllipseFrame<double> frame = ellipse_frame(spans_[span], t);
  const double angle = turn_per_span_ * (static_cast<double>(span) + t);
  return lines::midpoint(frame.circle).inverse() * turn(frames_[span][g], frame) * turns_[span][g] *
         Eigen::Rotation2Dd(angle).toRotationMatrix();
}

}  // namespace pn
