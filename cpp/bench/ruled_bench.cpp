// SPDX-License-Identifier: LGPL-2.1-or-later
// Cubic ruled surfaces of many spans, from the designer's numbers to certified poles.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "memory.hpp"
#include "offset_cases.hpp"
#include "pn/bezier/pn_surface.hpp"

namespace pn::bench {
namespace {

/// Memory per span that chain and faces keep, and that their making needs at the peak.
void many_ruled_spans(benchmark::State& state) {
  const int spans = static_cast<int>(state.range(0));
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(1)));
  const SplineRuled ruled = strip(spans);
  for (auto _ : state) benchmark::DoNotOptimize(whole_faces(chain_of(ruled), 0.5));

  const std::size_t before = allocated_bytes();
  const PeakMemory peak;
  const PNSurface surface(chain_of(ruled));
  const std::vector<BSplineSurface> faces = surface.offset(0.5).faces(Lines::kEven);
  state.counters["peak_bytes_per_span"] = static_cast<double>(peak.bytes()) / spans;
  state.counters["kept_bytes_per_span"] = static_cast<double>(allocated_bytes() - before) / spans;
  std::size_t poles = 0;
  for (const BSplineSurface& face : faces) poles += face.poles.size();
  state.counters["poles"] = static_cast<double>(poles);
}
BENCHMARK(many_ruled_spans)
    ->ArgNames({"spans", "threads"})
    ->ArgsProduct({{10, 100, 1000}, {1, 2}})
    ->UseRealTime()
    ->Repetitions(3)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pn::bench
