// SPDX-License-Identifier: LGPL-2.1-or-later
// Canal surfaces from the designer's numbers to certified poles.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "canal_cases.hpp"
#include "measured_offsets.hpp"

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

/// One span by the degree of its spine and radius.
void by_degree(benchmark::State& state) {
  const BezierCanal canal = helical_horn(static_cast<int>(state.range(0)));
  measure(state, [&] { return offsets_of(surface_of(canal), {0}); });
}
BENCHMARK(by_degree)->ArgName("spine")->DenseRange(2, 8)->Unit(benchmark::kMillisecond);

/// One cubic span at so many distances.
void by_distances(benchmark::State& state) {
  const BezierCanal canal = helical_horn(3);
  std::vector<double> distances;
  for (int i = 0; i < state.range(0); ++i) distances.push_back(i / 1024.0);
  measure(state, [&] { return offsets_of(surface_of(canal), distances); });
}
BENCHMARK(by_distances)
    ->ArgName("distances")
    ->Arg(1)
    ->Arg(3)
    ->Arg(10)
    ->Arg(30)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);

/// Many spans on some threads.
void many_spans(benchmark::State& state) {
  const int spans = static_cast<int>(state.range(0));
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(1)));
  const SplineCanal canal = spring(spans);
  measure(state, [&] { return offsets_of(surface_of(canal), {0}); });
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
