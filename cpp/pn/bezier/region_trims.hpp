// SPDX-License-Identifier: LGPL-2.1-or-later
// Region trims: the edges of the faces over a bounded region.
//
// Every arc of the boundary is a path in the parameters of the link. Where the region is covered by
// two halves, the paths are cut where they cross the two lines between the halves, and a half is
// bounded by the parts of the paths in it, by the stretches of those lines inside the region, and
// by the stretches of a pole inside it; put end to end with the region on their left these are its
// loops. Each corner is computed once, so that ends meet bit for bit.
#pragma once

#include <vector>

#include "pn/bezier/trimming.hpp"

namespace pn {

/// The loops of every face of a chain whose extent is a BoundedRegion; none for whole faces.
std::vector<FaceTrims> region_trims(const EnvelopeChain& chain, const SectionNet& net);

}  // namespace pn
