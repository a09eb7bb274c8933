// SPDX-License-Identifier: LGPL-2.1-or-later
// Region trims: the edges of the faces over a bounded region.
//
// Every arc of the boundary is a path in the parameters (t, v), which all faces have in common. The
// paths are cut where they cross from one face into another and at the knots around. A face is
// bounded by the paths in it and by the stretches of its sides inside the region; put end to end
// with the region on their left these are its loops. Each corner is computed once, so that ends
// meet bit for bit.
#pragma once

#include <vector>

#include "pn/bezier/trimming.hpp"

namespace pn {

/// The faces of a chain whose extent is a BoundedRegion.
std::vector<TrimmedFace> region_faces(const EnvelopeChain& chain, const ChainNet& net);

}  // namespace pn
