// SPDX-License-Identifier: LGPL-2.1-or-later
// Band trims: the edges of a face between two sides, each known at every t by the second parameter
// at which it lies.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "pn/bezier/trim_edge.hpp"

namespace pn {

/// One side of a band in the parameters of its segments.
class BandSide {
 public:
  struct Span {
    double begin, end;
    std::function<double(double)> parameter;  ///< across, at t in [0, 1] along the segment
  };

  BandSide(std::vector<Span> spans, bool closed);

  /// Where it crosses the start of a segment, and the end of one: computed once, so that neighbours
  /// share their corners.
  std::array<double, 2> start(std::size_t i) const { return {spans_[i].begin, joints_[i]}; }
  std::array<double, 2> end(std::size_t i) const { return {spans_[i].end, joints_[i + 1]}; }
  /// Along segment i.
  std::array<double, 2> at(std::size_t i, double t) const;

 private:
  std::vector<Span> spans_;
  std::vector<double> joints_;
};

/// Both sides; shared by the paths of edges, which outlive whoever made them.
using BandSides = std::shared_ptr<const std::array<BandSide, 2>>;
BandSides band_sides(std::array<std::vector<BandSide::Span>, 2> spans, bool closed);

/// The face between both sides over the segments [first, last): along the first side, back along
/// the second.
TrimEdgeLoop band_loop(const BandSides& sides, std::size_t first, std::size_t last);

}  // namespace pn
