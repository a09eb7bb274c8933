// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/chain_seam.hpp"

#include <algorithm>
#include <cmath>

#include "pn/algebra/parallel.hpp"
#include "pn/isotropic/seam.hpp"

namespace pn {

using Eigen::Matrix2d;
using Eigen::Vector3d;

namespace {

/// Steps of the grid on a link: fine enough that the frame turns little from one to the next.
constexpr int kGrid = 32;

double at(int g) { return static_cast<double>(g) / kGrid; }

std::size_t nearest(double t) {
  return static_cast<std::size_t>(std::clamp(std::lround(t * kGrid), 0L, long{kGrid}));
}

}  // namespace

ChainSeam::ChainSeam(const EnvelopeChain& chain, std::vector<IsotropicHypersurface<double>> links)
    : links_(std::move(links)), directions_(links_.size()), factors_(links_.size()) {
  Vector3d axis = axis_at(links_.front().curve, 0), e = any_perpendicular(axis);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    for (int g = 0; g <= kGrid; ++g) {
      const Vector3d next = axis_at(links_[i].curve, at(g));
      e = transported(e, axis, next);
      axis = next;
      directions_[i].push_back(e);
    }
  }
  if (chain.closed) {
    const Vector3d start = transported(directions_[0][0], axis_at(links_[0].curve, 0), axis);
    turn_per_link_ = angle_about(axis, e, start) / static_cast<double>(links_.size());
  }
  for_each_index(links_.size(), [&](std::size_t i) {
    factors_[i].push_back(factor(i, 0));
    for (int g = 1; g <= kGrid; ++g) {
      factors_[i].push_back(continued(factors_[i].back(), factor(i, at(g))));
    }
  });
}

Matrix2d ChainSeam::even(std::size_t link, double t) const {
  return continued(factors_[link][nearest(t)], factor(link, t));
}

Matrix2d ChainSeam::even_derivative(std::size_t link, double t) const {
  constexpr double kStep = 1.0 / 1024;
  const Matrix2d here = even(link, t);
  const Matrix2d ahead = continued(here, factor(link, t + kStep));
  const Matrix2d behind = continued(here, factor(link, t - kStep));
  return (ahead - behind) / (2 * kStep);
}

Matrix2d ChainSeam::factor(std::size_t link, double t) const {
  const SphereCurveForms<double>& curve = links_[link].curve;
  const std::size_t g = nearest(t);
  const Vector3d axis = axis_at(curve, t);
  const Vector3d e =
      transported(directions_[link][g], axis_at(curve, at(static_cast<int>(g))), axis);
  const double turn = turn_per_link_ * (static_cast<double>(link) + t);
  const Vector3d turned = Eigen::AngleAxisd(turn, axis.normalized()) * e;
  return even_factor(value_at(links_[link].spinor, t), circle_normal(curve, t, turned));
}

}  // namespace pn
