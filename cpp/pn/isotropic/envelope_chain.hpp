// SPDX-License-Identifier: LGPL-2.1-or-later
// Chains of envelopes: isotropic hypersurfaces one after the other along a spine.
//
// Two links meet in the same circle when their circle families (M : R) agree there, in direction
// and orientation. When moreover centre, radius and denominator agree up to the second derivative,
// the sections can be given lines u = const that make them C1 as homogeneous functions, so that
// both links lie on one C1 B-spline.
#pragma once

#include <string>
#include <vector>

#include "pn/isotropic/along_curve.hpp"

namespace pn {

enum class Joint {
  kNone,     ///< the chain begins here
  kTangent,  ///< the links share a circle
  kSmooth,   ///< and run on as one C1 surface
};

struct ChainLink {
  AlongCurve envelope;
  /// f' = content / denominator^2 (M, -R); zero where the spine stands still.
  RationalPolynomial content;
  double begin, end;   ///< in the spine's parameter; equal where the spine stands still
  Joint joint_before;  ///< to the link before; of the first link, to the last one of a closed chain

  bool stands_still() const { return content.is_zero(); }
};

struct EnvelopeChain {
  std::vector<ChainLink> links;
  bool closed = false;
  bool exact = true;  ///< no joint was closed up by more than the rounding of the input
  /// Sentences for the user: what was done to the input, and what to know of the envelope.
  std::vector<std::string> notes;
};

}  // namespace pn
