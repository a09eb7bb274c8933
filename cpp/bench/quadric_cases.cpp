// SPDX-License-Identifier: LGPL-2.1-or-later
#include "quadric_cases.hpp"

namespace pn::bench {

QuadricCase ellipsoid() { return {QuadricKind::kEllipsoid, {3, 2, 1}, {}}; }

QuadricCase paraboloid() {
  QuadricCase quadric{QuadricKind::kEllipticParaboloid, {2, 1, 0.5}, {}};
  quadric.bounds.box[0] = {-2, 2};
  quadric.bounds.box[1] = {-1, 1};
  return quadric;
}

QuadricCase two_sheet_hyperboloid() {
  QuadricCase quadric{QuadricKind::kTwoSheetHyperboloid, {3, 1, 2}, {}};
  const double p = kStereographicReach, reach = 2 * p / (1 - p * p);
  for (const std::size_t axis : {0u, 1u}) {
    quadric.bounds.box[axis] = {-reach * quadric.half_axes[axis], reach * quadric.half_axes[axis]};
  }
  return quadric;
}

QuadricCase one_sheet_hyperboloid() {
  QuadricCase quadric{QuadricKind::kOneSheetHyperboloid, {2, 1, 2}, {}};
  quadric.bounds.box[2] = {-2, 2};
  return quadric;
}

EnvelopeChain chain_of(const QuadricCase& quadric) {
  return pn::quadric(quadric.kind, quadric.half_axes, quadric.bounds);
}

}  // namespace pn::bench
