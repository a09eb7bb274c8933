// SPDX-License-Identifier: LGPL-2.1-or-later
// Region lines: the faces over a bounded region of one link.
//
// The lines are those of the spinor matrix up to a constant real factor F, which costs no degree.
// Where the region surrounds or touches a pole of the parametrization, where all circles shrink to
// a point, or goes around between two, it becomes two halves that meet along two lines u = const,
// so that no face has both a seam and a pole: OpenCASCADE's checks take the one running into the
// other for a self-intersection. Any other region is one face over an arc of the circles.
#pragma once

#include <Eigen/Dense>
#include <optional>

#include "pn/isotropic/envelope_chain.hpp"

namespace pn {

/// F, the part of the link, and whether it is taken all the way around.
struct RegionLines {
  Eigen::Matrix2d factor;  ///< entries of 24 bits
  double low, high;        ///< in the link's parameter; 0 or 1 exactly at a pole
  bool is_closed;
  std::optional<double> last_whole;  ///< beyond this circle only the first half goes on
};

/// The link carries rulings: a region of it lies in the band between its directrices, whose lines
/// turn (ruling_band.hpp).
bool is_ruled(const EnvelopeChain& chain);

/// All loops of the region are lines t = const, as parallels on a quadric of revolution are: then
/// the faces end there and need no trims.
bool is_bounded_by_parallels(const BoundedRegion& region);

/// For a chain whose extent is a BoundedRegion and whose link carries no rulings.
RegionLines region_lines(const EnvelopeChain& chain);

}  // namespace pn
