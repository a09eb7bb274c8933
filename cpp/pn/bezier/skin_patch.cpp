// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/skin_patch.hpp"

#include <algorithm>
#include <cmath>

#include "pn/algebra/ball_vector.hpp"

namespace pn {
namespace {

using Parameters = std::array<double, 2>;

/// Places on each edge at which its image is looked at.
constexpr int kSamples = 24;
/// A chart is wider than what was seen of the edges by this part: they bend between the samples.
constexpr double kMargin = 1.0 / 50;

const std::array<Parameters, 3> kCorners = {{{0, 0}, {1, 0}, {0, 1}}};

}  // namespace

Parameters on_edge(std::size_t edge, double at) {
  const Parameters &from = kCorners[edge], &to = kCorners[(edge + 1) % 3];
  return {from[0] * (1 - at) + to[0] * at, from[1] * (1 - at) + to[1] * at};
}

std::vector<Parameters> edge_points() {
  std::vector<Parameters> points;
  for (std::size_t edge = 0; edge < 3; ++edge) {
    for (int i = 0; i < kSamples; ++i) {
      points.push_back(on_edge(edge, static_cast<double>(i) / kSamples));
    }
  }
  return points;
}

std::array<ParameterPath, 3> boundary(const SkinPatch& patch) {
  std::array<ParameterPath, 3> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    if (patch.sheet == Sheet::kOuter) {
      edges[k] = [place_of = patch.place_of, k](double at) { return place_of(on_edge(k, at)); };
    } else {
      edges[k] = [place_of = patch.place_of, edge = 2 - k](double at) {
        return place_of(on_edge(edge, 1 - at));
      };
    }
  }
  return edges;
}

/// The smallest of some Bernstein coefficients in parts of the largest.
double least_ratio(const TensorPolynomial<RealBall>& weight) {
  double least = INFINITY, largest = 0;
  for (const RealBall& c : normalized(to_bernstein(weight))) {
    least = std::min(least, c.lower());
    largest = std::max(largest, c.upper());
  }
  return least / largest;
}

ImageBox box_around(const std::vector<Parameters>& points) {
  ImageBox box{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (const Parameters& point : points) {
    for (std::size_t c = 0; c < 2; ++c) {
      box.low[c] = std::min(box.low[c], point[c]);
      box.high[c] = std::max(box.high[c], point[c]);
    }
  }
  for (std::size_t c = 0; c < 2; ++c) {
    const double margin = kMargin * (box.high[c] - box.low[c]);
    box.low[c] -= margin;
    box.high[c] += margin;
  }
  return box;
}

}  // namespace pn
