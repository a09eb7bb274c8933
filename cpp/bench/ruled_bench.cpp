// SPDX-License-Identifier: LGPL-2.1-or-later
// Cubic ruled surfaces of many spans, from the designer's numbers to certified poles.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "measured_offsets.hpp"
#include "offset_cases.hpp"
#include "pn/bezier/pn_surface.hpp"

namespace pn::bench {
namespace {

void many_ruled_spans(benchmark::State& state) {
  const int spans = static_cast<int>(state.range(0));
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(1)));
  const SplineRuled ruled = strip(spans);
  measure(state, [&] { return offsets_of(PNSurface(chain_of(ruled)), {0.5}); });
}
BENCHMARK(many_ruled_spans)
    ->ArgNames({"spans", "threads"})
    ->ArgsProduct({{10, 100, 1000}, {1, 2}})
    ->UseRealTime()
    ->Repetitions(3)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pn::bench
