// SPDX-License-Identifier: LGPL-2.1-or-later
// Chains of envelopes: isotropic hypersurfaces one after the other, and the part of them that is
// wanted.
//
// Two links meet in the same circle when their circle families (M : R) agree there, in direction
// and orientation. When moreover what carries them (curve of spheres, or rulings) agrees up to the
// second derivative, the sections can be given lines u = const that make them C1 as homogeneous
// functions, so that both links lie on one C1 B-spline.
//
// Around each circle the surface goes all the way, as a pipe does; or it is the band between two
// directrices of the rulings; or a region of a single link, bounded by arcs.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pn/isotropic/envelope.hpp"
#include "pn/isotropic/rational_patch.hpp"
#include "pn/isotropic/sphere_curve.hpp"

namespace pn {

enum class Joint {
  kNone,     ///< the chain begins here
  kTangent,  ///< the links share a circle
  kSmooth,   ///< and run on as one C1 surface
};

/// The curve of spheres that a link envelops, over Q, when there is one.
struct CurveOfSpheres {
  SphereCurve curve;
  CircleFamily circles;
  /// f' = content / denominator^2 (M, -R); zero where the spine stands still.
  RationalPolynomial content;
};

struct ChainLink {
  Envelope envelope;
  std::optional<CurveOfSpheres> spheres;
  double begin, end;   ///< in the designer's parameter; equal where the spine stands still
  Joint joint_before;  ///< to the link before; of the first link, to the last one of a closed chain

  bool stands_still() const { return spheres && spheres->content.is_zero(); }
};

/// All the way around.
struct WholeCircle {};

/// The part 0 <= v <= 1 of rulings f = a + v g, whose links carry RulingForms.
struct RulingBand {};

/// The whole of developable strips, u = (1 - v : v).
struct Strip {};

/// A point of the boundary of a region: the local parameter of the link and the unit normal there.
struct ContactPoint {
  double t;
  Eigen::Vector3d normal;
};

/// A smooth piece of the boundary over [0, 1].
using BoundaryArc = std::function<ContactPoint(double)>;

/// The region of a single link inside its loops; each arc ends where the next one begins. Without
/// loops it is the whole surface.
struct BoundedRegion {
  std::vector<std::vector<BoundaryArc>> loops;
  /// Whether a point is in the region.
  std::function<bool(const ContactPoint&)> contains;
  /// The region reaches the ends t = 0 and t = 1 of the link, where all circles shrink to a point.
  bool has_first_pole, has_last_pole;
};

using Extent = std::variant<WholeCircle, RulingBand, Strip, BoundedRegion>;

struct EnvelopeChain {
  std::vector<ChainLink> links;
  bool closed = false;
  Extent extent = WholeCircle{};
  /// The surface at distance zero, where the limits of its offsets are read off that: of links
  /// without a curve of spheres. None: no distance is claimed to be regular.
  std::vector<RationalPatch> base;
  bool exact = true;  ///< no joint was closed up by more than the rounding of the input
  /// Sentences for the user: what was done to the input, and what to know of the envelope.
  std::vector<std::string> notes;
};

}  // namespace pn
