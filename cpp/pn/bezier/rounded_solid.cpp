// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/rounded_solid.hpp"

#include <algorithm>
#include <cmath>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/corner_lune.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

/// Rounded down, of the control points: no radius of the family is smaller.
double least_radius(const QuadraticFamily& family) {
  double least = INFINITY;
  for (const auto& sphere : family.control()) least = std::min(least, -sphere[3].to_double());
  return std::nextafter(least, -INFINITY);
}

std::vector<ExactPatch> boundary_patches(const QuadraticFamily& family) {
  if (!(least_radius(family) > 0)) {
    throw GeometryError(ErrorCode::kNegativeRadius,
                        "A solid needs spheres of positive radius at all six control points.");
  }
  std::array<std::vector<PlacedPatch>, 2> skins;
  for_each_index(2, [&](std::size_t i) {
    skins[i] = skin_patches(family, i == 0 ? Sheet::kOuter : Sheet::kInner);
  });
  const auto& [outer, inner] = skins;
  std::vector<ExactPatch> patches = exact_patches(outer);
  for (ExactPatch& patch : exact_patches(inner)) patches.push_back(std::move(patch));
  for (std::size_t edge = 0; edge < 3; ++edge) {
    patches.push_back(edge_strip(family, edge, ends_along(inner, edge), ends_along(outer, edge)));
  }
  for (std::size_t edge = 0; edge < 3; ++edge) patches.push_back(corner_lune(family, edge));
  return patches;
}

}  // namespace

RoundedSolid::RoundedSolid(const QuadraticFamily& family, std::vector<std::string> notes)
    : PatchSource(boundary_patches(family), std::move(notes)), family_(family) {}

OffsetRange RoundedSolid::regular_range() const {
  const OffsetRange range = pn::regular_range(family_);
  return {std::max(range.lower, -least_radius(family_)), range.upper};
}

}  // namespace pn
