// SPDX-License-Identifier: LGPL-2.1-or-later
// Canal surfaces from the designer's numbers to certified poles.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "canal_cases.hpp"
#include "memory.hpp"

namespace pn::bench {
namespace {

void numbers_to_poles(benchmark::State& state) {
  const BezierCanal canal = helical_horn(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(surface_of(canal).faces(Lines::kEven));
}
BENCHMARK(numbers_to_poles)->ArgName("degree")->Arg(3)->Arg(6)->Unit(benchmark::kMicrosecond);

void another_distance(benchmark::State& state) {
  const PNSurface surface = surface_of(helical_horn(static_cast<int>(state.range(0))));
  benchmark::DoNotOptimize(surface.faces(Lines::kEven));
  double distance = 0;
  for (auto _ : state) {
    distance += 1.0 / 1024;
    benchmark::DoNotOptimize(surface.offset(distance).faces(Lines::kEven));
  }
}
BENCHMARK(another_distance)->ArgName("degree")->Arg(3)->Arg(6)->Unit(benchmark::kMicrosecond);

/// Many spans on some threads; memory per span that the surface keeps, and that its making needs at
/// the peak.
void many_spans(benchmark::State& state) {
  const int spans = static_cast<int>(state.range(0));
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(1)));
  const SplineCanal canal = spring(spans);
  for (auto _ : state) benchmark::DoNotOptimize(surface_of(canal).faces(Lines::kEven));

  const std::size_t before = allocated_bytes();
  const PeakMemory peak;
  const PNSurface surface = surface_of(canal);
  const std::vector<BSplineSurface> faces = surface.faces(Lines::kEven);
  state.counters["peak_bytes_per_span"] = static_cast<double>(peak.bytes()) / spans;
  state.counters["kept_bytes_per_span"] = static_cast<double>(allocated_bytes() - before) / spans;
  state.counters["poles"] = static_cast<double>(surface.certificate(Lines::kEven).poles);
}
BENCHMARK(many_spans)
    ->ArgNames({"spans", "threads"})
    ->ArgsProduct({{100, 300, 1000, 10000}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// Whether a spring, whose turns are apart, meets itself.
void self_intersection(benchmark::State& state) {
  const PNSurface surface = surface_of(spring(static_cast<int>(state.range(0))));
  benchmark::DoNotOptimize(surface.faces(Lines::kEven));
  for (auto _ : state) benchmark::DoNotOptimize(surface.self_intersection());
}
BENCHMARK(self_intersection)
    ->ArgName("spans")
    ->Arg(1)
    ->Arg(30)
    ->Arg(300)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pn::bench
