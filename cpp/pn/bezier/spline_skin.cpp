// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/spline_skin.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Parameters = std::array<double, 2>;
using PatchesOfPieces = std::vector<std::vector<PlacedPatch>>;

std::vector<PlacedPatch> patches_of(const FamilyPiece& piece, Sheet sheet) {
  try {
    return skin_patches(piece.family, sheet);
  } catch (const GeometryError& error) {
    throw GeometryError(error.code(), "Over triangle " + std::to_string(piece.designers_triangle) +
                                          ": " + error.what());
  }
}

/// Where the patches of its neighbours end on the edges of a piece.
std::vector<Parameters> ends_of_neighbours(const DirectedEdges& edges,
                                           const PatchesOfPieces& patches, std::size_t piece) {
  std::vector<Parameters> ends;
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const auto neighbour = edges.opposite({piece, edge});
    if (!neighbour) continue;
    for (const double at : ends_along(patches[neighbour->triangle], neighbour->edge)) {
      ends.push_back(on_edge(edge, 1 - at));
    }
  }
  return ends;
}

std::vector<ExactPatch> patches_of(const FamilySpline& spline, Sheet sheet) {
  PatchesOfPieces patches(spline.pieces.size());
  for_each_index(patches.size(),
                 [&](std::size_t i) { patches[i] = patches_of(spline.pieces[i], sheet); });
  const DirectedEdges edges = spline.edges();
  std::vector<ExactPatch> all;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    std::vector<ExactPatch> own = exact_patches(patches[i], ends_of_neighbours(edges, patches, i));
    std::move(own.begin(), own.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace

SplineSkin::SplineSkin(const FamilySpline& spline, Sheet sheet, std::vector<std::string> notes)
    : PatchSource(patches_of(spline, sheet), std::move(notes)), pieces_(spline.pieces) {}

OffsetRange SplineSkin::regular_range() const {
  std::vector<OffsetRange> ranges(pieces_.size());
  for_each_index(ranges.size(),
                 [&](std::size_t i) { ranges[i] = pn::regular_range(pieces_[i].family); });
  OffsetRange all{-INFINITY, INFINITY};
  for (const OffsetRange& range : ranges) {
    all.lower = std::max(all.lower, range.lower);
    all.upper = std::min(all.upper, range.upper);
  }
  return all;
}

}  // namespace pn
