// SPDX-License-Identifier: LGPL-2.1-or-later
// Trim regions: which parameters of a face belong to it.
//
// The loops of a face are followed by polygons. A point counts as inside when a line from it to
// infinity crosses them an odd number of times (the Jordan curve theorem), and it is farther from
// them than the curves were seen to be from their chords: near an edge nothing is claimed.
#pragma once

#include <array>
#include <vector>

#include "pn/algebra/tensor_bernstein.hpp"
#include "pn/bezier/bspline_surface.hpp"

namespace pn {

class TrimRegion {
 public:
  /// Without loops the region is the whole plane.
  explicit TrimRegion(const std::vector<TrimLoop>& loops);

  bool contains(const std::array<double, 2>& point) const;

  /// How much of a rectangle is inside the polygons.
  enum class Part { kNone, kSome, kAll };
  Part part_of(const Rectangle& rectangle) const;

 private:
  struct Chord {
    std::array<double, 2> from, to;
    double sag;  ///< the distance of the curve from the chord, and as much again
  };

  bool is_enclosed(const std::array<double, 2>& point) const;

  std::vector<Chord> chords_;
};

}  // namespace pn
