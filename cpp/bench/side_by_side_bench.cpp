// SPDX-License-Identifier: LGPL-2.1-or-later
// The same pipes from this library and from OpenCASCADE: time from numbers to a shape, poles,
// deviation from the true envelope, size of the STEP file.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "canal_cases.hpp"
#include "envelope_deviation.hpp"
#include "occt_pipes.hpp"
#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/shell.hpp"
#include "pn/occt/step.hpp"

namespace pn::bench {
namespace {

/// Bytes of the STEP file, every double with 17 digits for each shape alike.
std::size_t step_bytes(const TopoDS_Shape& shape) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("pn_bench_" + std::to_string(getpid()) + ".step");
  write_step(path, {{shape, "pipe"}});
  const std::size_t bytes = std::filesystem::file_size(path);
  std::filesystem::remove(path);
  return bytes;
}

template <class Make>
void shape_of(benchmark::State& state, const BezierCanal& canal, const char* way,
              const Make& make) {
  state.SetLabel(way);
  for (auto _ : state) benchmark::DoNotOptimize(make(canal));
  const TopoDS_Shape shape = make(canal);
  double deviation = 0;
  std::size_t poles = 0;
  for (const BSplineSurface& surface : bspline_surfaces(shape)) {
    deviation = std::max(deviation, deviation_from_envelope(surface, canal));
    poles += surface.poles.size();
    state.counters["degree_along"] = surface.u_degree;
    state.counters["degree_around"] = surface.v_degree;
  }
  state.counters["poles"] = static_cast<double>(poles);
  state.counters["deviation"] = deviation;
  state.counters["step_bytes"] = static_cast<double>(step_bytes(shape));
}

template <class Make>
void case_c1(benchmark::State& state, const char* way, const Make& make) {
  shape_of(state, pipe(), way, make);
}

template <class Make>
void case_c2(benchmark::State& state, const char* way, const Make& make) {
  shape_of(state, horn(), way, make);
}

TopoDS_Shape exact(const BezierCanal& canal) {
  return make_shell(surface_of(canal).faces(Lines::kEven));
}

/// A way to a pipe that takes a tolerance, with that tolerance.
template <TopoDS_Shape (*Way)(const BezierCanal&, Tolerance)>
auto within(double millimetres) {
  return [=](const BezierCanal& canal) { return Way(canal, {millimetres}); };
}

auto loft(int circles) {
  return
      [=](const BezierCanal& canal) { return loft_through_characteristic_circles(canal, circles); };
}

BENCHMARK_CAPTURE(case_c1, exact, "exact", exact)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(case_c1, sweep, "MakePipeShell, 1e-6", within<swept_circle>(1e-6))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(case_c1, fine_sweep, "MakePipeShell, 1e-9", within<swept_circle>(1e-9))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(case_c1, fill, "GeomFill_Pipe, 1e-6", within<filled_pipe>(1e-6))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(case_c1, fine_fill, "GeomFill_Pipe, 1e-9", within<filled_pipe>(1e-9))
    ->Unit(benchmark::kMicrosecond);

BENCHMARK_CAPTURE(case_c2, exact, "exact", exact)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(case_c2, sweep, "MakePipeShell with law, 1e-6",
                  within<swept_circle_with_law>(1e-6))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(case_c2, fine_sweep, "MakePipeShell with law, 1e-9",
                  within<swept_circle_with_law>(1e-9))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(case_c2, fill, "GeomFill_Pipe, 21 circles, 1e-6",
                  within<filled_pipe_through_circles>(1e-6))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(case_c2, loft_41, "ThruSections, 41 exact circles", loft(41))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(case_c2, loft_81, "ThruSections, 81 exact circles", loft(81))
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pn::bench
