// SPDX-License-Identifier: LGPL-2.1-or-later
// Trimming: the edges of the faces of a chain.
//
// The boundary of what is wanted is no parameter line of the surface, since its normals are not
// rational in t. It is known pointwise instead: a normal on the circle of t has the parameter u
// with n(A u) = n.
#pragma once

#include <vector>

#include "pn/bezier/chain_net.hpp"
#include "pn/bezier/trim_edge.hpp"

namespace pn {

/// The faces of a chain on the net of it. A face of the net without any part of the region is left
/// out, one with several parts comes once for each.
std::vector<TrimmedFace> trimmed_faces(const EnvelopeChain& chain, const ChainNet& net);

}  // namespace pn
