// SPDX-License-Identifier: LGPL-2.1-or-later
// Offsets of quadrics and ruled surfaces that are measured.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "pn/bezier/chain_net.hpp"
#include "quadric_cases.hpp"
#include "ruled_cases.hpp"

namespace pn::bench {

using OffsetBase = std::variant<QuadricCase, BezierRuled>;

struct OffsetCase {
  std::string name;   ///< "Q1p"
  std::string shape;  ///< and its offset in words
  OffsetBase base;
  double distance;  ///< [mm], in the orientation of the kernel
};

std::vector<OffsetCase> offset_cases();

EnvelopeChain chain_of(const OffsetBase& base);

/// Faces with their proven deviation, not trimmed.
std::vector<RoundedFace> whole_faces(const EnvelopeChain& chain, double distance);

}  // namespace pn::bench
