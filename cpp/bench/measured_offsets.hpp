// SPDX-License-Identifier: LGPL-2.1-or-later
// Time and memory of offsets, from the designer's numbers to certified poles.
#pragma once

#include <benchmark/benchmark.h>

#include <vector>

#include "memory.hpp"
#include "pn/bezier/pn_surface.hpp"

namespace pn::bench {

/// A surface and its faces at some distances.
struct Offsets {
  PNSurface surface;
  std::vector<std::vector<BSplineSurface>> faces;
};

inline Offsets offsets_of(PNSurface surface, const std::vector<double>& distances) {
  Offsets offsets{std::move(surface), {}};
  for (const double distance : distances) {
    offsets.faces.push_back(offsets.surface.offset(distance).faces(Lines::kEven));
  }
  return offsets;
}

/// Times what makes offsets; counts their poles, and the memory that they keep and that their
/// making needs at the peak.
template <class Make>
void measure(benchmark::State& state, const Make& make) {
  for (auto _ : state) benchmark::DoNotOptimize(make());

  const std::size_t before = allocated_bytes();
  const PeakMemory peak;
  const Offsets offsets = make();
  state.counters["peak_bytes"] = static_cast<double>(peak.bytes());
  state.counters["kept_bytes"] = static_cast<double>(allocated_bytes() - before);
  std::size_t poles = 0;
  for (const auto& faces : offsets.faces) {
    for (const BSplineSurface& face : faces) poles += face.poles.size();
  }
  state.counters["poles"] = static_cast<double>(poles);
}

}  // namespace pn::bench
