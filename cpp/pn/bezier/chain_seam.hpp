// SPDX-License-Identifier: LGPL-2.1-or-later
// Chain seam: the even factor along a whole chain of envelopes.
//
// On every link the factor of seam.hpp follows one rotation-minimizing frame that runs through the
// chain, with continuous sign. Around a closed chain the frame comes back turned by its holonomy,
// which is given back link by link, so that the seam closes.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "pn/bezier/target_lines.hpp"
#include "pn/isotropic/envelope_chain.hpp"

namespace pn {

class ChainSeam : public TargetLines {
 public:
  /// `links` are the hypersurfaces of the chain's links in doubles.
  ChainSeam(const EnvelopeChain& chain, std::vector<IsotropicHypersurface<double>> links);

 private:
  /// The even factor.
  Eigen::Matrix2d factor(std::size_t link, double t) const override;

  std::vector<IsotropicHypersurface<double>> links_;
  std::vector<std::vector<Eigen::Vector3d>>
      directions_;  ///< of the frame, on the grid of each link
  double turn_per_link_ = 0;
};

}  // namespace pn
