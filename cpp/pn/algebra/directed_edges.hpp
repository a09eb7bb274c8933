// SPDX-License-Identifier: LGPL-2.1-or-later
// Directed edges: which triangles of a triangulation are neighbours.
//
// Every triangle runs its edges counterclockwise, so neighbours run their common edge in opposite
// directions.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace pn {

/// Three numbers of corners, counterclockwise. Edge k runs from corner k to the next one.
using Triangle = std::array<std::size_t, 3>;

struct TriangleEdge {
  std::size_t triangle, edge;
};

class DirectedEdges {
 public:
  explicit DirectedEdges(const std::vector<Triangle>& triangles) : triangles_(triangles) {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) edges_[ends({t, k})] = {t, k};
    }
  }

  /// The same edge of the neighbour, which runs it in the opposite direction; nothing at the
  /// border.
  std::optional<TriangleEdge> opposite(const TriangleEdge& edge) const {
    const auto [from, to] = ends(edge);
    const auto found = edges_.find({to, from});
    return found == edges_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::pair<std::size_t, std::size_t> ends(const TriangleEdge& edge) const {
    const Triangle& corners = triangles_[edge.triangle];
    return {corners[edge.edge], corners[(edge.edge + 1) % 3]};
  }

  std::vector<Triangle> triangles_;
  std::map<std::pair<std::size_t, std::size_t>, TriangleEdge> edges_;
};

}  // namespace pn
