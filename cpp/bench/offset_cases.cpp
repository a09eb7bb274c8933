// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset_cases.hpp"

#include "pn/algebra/precision.hpp"

namespace pn::bench {

std::vector<OffsetCase> offset_cases() {
  return {{"Q1p", "ellipsoid, 0.5 mm outwards", ellipsoid(), 0.5},
          {"Q1m", "ellipsoid, 0.2 mm inwards", ellipsoid(), -0.2},
          {"Q2", "elliptic paraboloid over a rectangle, 0.5 mm upwards", paraboloid(), -0.5},
          {"Q3",
           "two-sheet hyperboloid over a rectangle (OpenCASCADE: a stereographic patch), 0.5 mm to "
           "the convex side",
           two_sheet_hyperboloid(), 0.5},
          {"Q4", "one-sheet hyperboloid, full turn, 0.3 mm outwards", one_sheet_hyperboloid(), 0.3},
          {"R1", "bilinear patch, 1 mm upwards", bilinear_patch(), 1},
          {"R2", "cubic ruled patch, 1 mm upwards", cubic_patch(), 1}};
}

EnvelopeChain chain_of(const OffsetBase& base) {
  return std::visit([](const auto& given) { return chain_of(given); }, base);
}

std::vector<RoundedFace> whole_faces(const EnvelopeChain& chain, double distance) {
  return at_sufficient_precision(
      [&](long bits) { return ChainNet(chain, Lines::kEven, bits).section(distance); });
}

}  // namespace pn::bench
