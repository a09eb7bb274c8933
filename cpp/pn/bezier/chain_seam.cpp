// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/chain_seam.hpp"

#include "pn/isotropic/seam.hpp"

namespace pn {

using Eigen::Matrix2d;
using Eigen::Vector3d;

ChainSeam::ChainSeam(const EnvelopeChain& chain, std::vector<IsotropicHypersurface<double>> links)
    : links_(std::move(links)), directions_(links_.size()) {
  Vector3d axis = axis_at(links_.front().circles, 0), e = any_perpendicular(axis);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    for (int g = 0; g <= kGrid; ++g) {
      const Vector3d next = axis_at(links_[i].circles, grid_parameter(g));
      e = transported(e, axis, next);
      axis = next;
      directions_[i].push_back(e);
    }
  }
  if (chain.closed) {
    const Vector3d start = transported(directions_[0][0], axis_at(links_[0].circles, 0), axis);
    turn_per_link_ = angle_about(axis, e, start) / static_cast<double>(links_.size());
  }
  choose_signs(links_.size());
}

Matrix2d ChainSeam::factor(std::size_t link, double t) const {
  const CircleForms<double>& circles = links_[link].circles;
  const std::size_t g = nearest(t);
  const Vector3d axis = axis_at(circles, t);
  const Vector3d e = transported(directions_[link][g],
                                 axis_at(circles, grid_parameter(static_cast<int>(g))), axis);
  const double turn = turn_per_link_ * (static_cast<double>(link) + t);
  const Vector3d turned = Eigen::AngleAxisd(turn, axis.normalized()) * e;
  return even_factor(value_at(links_[link].spinor, t), circle_normal(circles, t, turned));
}

}  // namespace pn
