// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/trim_edge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/evaluation.hpp"

namespace pn {
namespace {

using Point = std::array<double, 2>;

/// Places in every span of an edge at which its distance from the true boundary is measured. Where
/// spans are equal it is largest in their middle.
constexpr std::array<double, 5> kPlaces = {0.1, 0.3, 0.5, 0.7, 0.9};

double deviation(const SurfaceEvaluation& section, const TrimEdge& edge) {
  double largest = 0;
  const std::vector<double>& knots = edge.curve.knots;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    for (const double part : kPlaces) {
      const double at = knots[i - 1] + part * (knots[i] - knots[i - 1]);
      const Point exact = edge.path(at), near = evaluate(edge.curve, at);
      const auto a = section(exact[0], exact[1]), b = section(near[0], near[1]);
      largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  return largest;
}

}  // namespace

TrimEdge edge_along(const ParameterPath& path, double tolerance) {
  return {interpolated(path, tolerance), path};
}

TrimEdge straight_edge(const std::array<double, 2>& start, const std::array<double, 2>& end) {
  return {straight_line(start, end), {}};
}

std::vector<TrimLoop> curves_of(const TrimmedFace& face) {
  std::vector<TrimLoop> loops;
  for (const TrimEdgeLoop& edges : face.loops) {
    loops.emplace_back();
    for (const TrimEdge& edge : edges) loops.back().push_back(edge.curve);
  }
  return loops;
}

double trim_deviation(const BSplineSurface& section, const TrimmedFace& face) {
  std::vector<const TrimEdge*> edges;
  for (const TrimEdgeLoop& loop : face.loops) {
    for (const TrimEdge& edge : loop) {
      if (edge.path) edges.push_back(&edge);
    }
  }
  if (edges.empty()) return 0;
  const SurfaceEvaluation evaluation(section);
  std::vector<double> deviations(edges.size());
  for_each_index(edges.size(),
                 [&](std::size_t i) { deviations[i] = deviation(evaluation, *edges[i]); });
  return *std::max_element(deviations.begin(), deviations.end());
}

}  // namespace pn
