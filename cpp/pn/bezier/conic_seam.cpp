// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_seam.hpp"

#include <cmath>
#include <utility>

namespace pn {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector3d;

Matrix2d turn(const ConicFrame<double>& from, const ConicFrame<double>& to) {
  const Matrix2d result = lines::midpoint(least_turn(from, to));
  return result.allFinite() ? result : Matrix2d::Identity();
}

Vector3d centre(const ConicForms<double>& x, double t) {
  const Matrix2d inverse = lines::midpoint(conic_frame(x, t).circle).inverse();
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < 2; ++k) {
    for (int c = 0; c < 3; ++c) {
      sum[c] += value(x.point[static_cast<std::size_t>(c)], t, inverse(0, k), inverse(1, k)) / 2;
    }
  }
  return sum;
}

/// How the centres move over a span, to the side from which the ellipses run counterclockwise.
double advance(const ConicForms<double>& span) {
  const ConicFrame<double> start = conic_frame(span, 0.0), end = conic_frame(span, 1.0);
  Vector3d normal = Vector3d::Zero();
  for (const ConicFrame<double>* frame : {&start, &end}) {
    normal += Vector3d(frame->real.data()).cross(Vector3d(frame->imaginary.data()));
  }
  return normal.dot(centre(span, 1) - centre(span, 0));
}

}  // namespace

ConicSeam::ConicSeam(std::vector<ConicForms<double>> spans, bool closed)
    : spans_(std::move(spans)), frames_(spans_.size()), turns_(spans_.size()) {
  Matrix2d turned = Matrix2d::Identity();
  if (advance(spans_.front()) < 0) turned(1, 1) = -1;
  ConicFrame<double> before = conic_frame(spans_.front(), 0.0);
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    for (int g = 0; g <= kGrid; ++g) {
      frames_[i].push_back(conic_frame(spans_[i], grid_parameter(g)));
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
  const ConicFrame<double> frame = conic_frame(spans_[span], t);
  const double angle = turn_per_span_ * (static_cast<double>(span) + t);
  return lines::midpoint(frame.circle).inverse() * turn(frames_[span][g], frame) * turns_[span][g] *
         Eigen::Rotation2Dd(angle).toRotationMatrix();
}

ArcLines::ArcLines(std::vector<ConicForms<double>> spans, double margin)
    : spans_(std::move(spans)), margin_(margin) {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const bool turns_round =
        i > 0 &&
        turn(conic_frame(spans_[i - 1], 1.0), conic_frame(spans_[i], 0.0)).determinant() < 0;
    direction_.push_back(i == 0 ? 1 : turns_round ? -direction_.back() : direction_.back());
  }
  choose_signs(spans_.size());
}

Matrix2d ArcLines::factor(std::size_t span, double t) const {
  // The ends are orthogonal in z, and are turned away from each other.
  const double beyond = M_PI / 4 * margin_;
  Matrix2d turned;
  turned << std::cos(beyond), -std::sin(beyond), -std::sin(beyond), std::cos(beyond);
  const Matrix2d ends = lines::midpoint(ends_of_arc(spans_[span], t)) * turned;
  return direction_[span] > 0 ? ends : Matrix2d(ends.rowwise().reverse());
}

}  // namespace pn
