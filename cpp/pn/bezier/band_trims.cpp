// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/band_trims.hpp"

#include <utility>

#include "pn/algebra/parallel.hpp"

namespace pn {
namespace {

/// In parameters that run over about a unit: a little above what doubles resolve.
constexpr double kParameterTolerance = 1e-13;

}  // namespace

BandSide::BandSide(std::vector<Span> spans, bool closed) : spans_(std::move(spans)) {
  for (const Span& span : spans_) joints_.push_back(span.parameter(0));
  joints_.push_back(closed ? joints_.front() : spans_.back().parameter(1));
}

std::array<double, 2> BandSide::at(std::size_t i, double t) const {
  if (t == 0) return start(i);
  if (t == 1) return end(i);
  const Span& span = spans_[i];
  return {span.begin + t * (span.end - span.begin), span.parameter(t)};
}

BandSides band_sides(std::array<std::vector<BandSide::Span>, 2> spans, bool closed) {
  return std::make_shared<const std::array<BandSide, 2>>(std::array<BandSide, 2>{
      BandSide(std::move(spans[0]), closed), BandSide(std::move(spans[1]), closed)});
}

TrimEdgeLoop band_loop(const BandSides& sides, std::size_t first, std::size_t last) {
  const auto& [low, high] = *sides;
  const std::size_t count = last - first;
  TrimEdgeLoop loop(2 * count + 2);
  for_each_index(count, [&](std::size_t k) {
    const std::size_t i = first + k;
    loop[k] =
        edge_along([sides, i](double t) { return (*sides)[0].at(i, t); }, kParameterTolerance);
    loop[2 * count - k] =
        edge_along([sides, i](double t) { return (*sides)[1].at(i, 1 - t); }, kParameterTolerance);
  });
  loop[count] = straight_edge(low.end(last - 1), high.end(last - 1));
  loop[2 * count + 1] = straight_edge(high.start(first), low.start(first));
  return loop;
}

}  // namespace pn
