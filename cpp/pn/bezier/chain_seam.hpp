// SPDX-License-Identifier: LGPL-2.1-or-later
// Chain seam: the even factor along a whole chain of envelopes.
//
// On every link the factor of seam.hpp follows one rotation-minimizing frame that runs through the
// chain, with continuous sign. Around a closed chain the frame comes back turned by its holonomy,
// which is given back link by link, so that the seam closes.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "pn/isotropic/envelope_chain.hpp"

namespace pn {

class ChainSeam {
 public:
  /// `links` are the hypersurfaces of the chain's links in doubles.
  ChainSeam(const EnvelopeChain& chain, std::vector<IsotropicHypersurface<double>> links);

  /// The even factor of a link at t in [0, 1].
  Eigen::Matrix2d even(std::size_t link, double t) const;
  /// Its derivative by t, nearly: the factor only has to be near the even one.
  Eigen::Matrix2d even_derivative(std::size_t link, double t) const;

 private:
  Eigen::Matrix2d factor(std::size_t link, double t) const;

  std::vector<IsotropicHypersurface<double>> links_;
  std::vector<std::vector<Eigen::Vector3d>> directions_;  ///< of the frame, on a grid of each link
  std::vector<std::vector<Eigen::Matrix2d>> factors_;  ///< on the same grid, with continuous sign
  double turn_per_link_ = 0;
};

}  // namespace pn
