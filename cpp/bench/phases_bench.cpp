// SPDX-License-Identifier: LGPL-2.1-or-later
// The steps on the way from numbers to poles, for one span. Some contain others, as said.
#include <benchmark/benchmark.h>

#include "canal_cases.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/bezier/chain_net.hpp"
#include "pn/bezier/offset_limits.hpp"
#include "pn/isotropic/along_curve.hpp"
#include "pn/shapes/canal_surface.hpp"

namespace pn::bench {
namespace {

EnvelopeChain chain_of(const BezierCanal& canal) {
  return canal_surface(Curve::bezier(canal.spine), Law::bezier(canal.radius));
}

/// The chain for the degree that the benchmark is run with.
EnvelopeChain chain_for(const benchmark::State& state) {
  return chain_of(helical_horn(static_cast<int>(state.range(0))));
}

void for_both_degrees(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("degree")->Arg(3)->Arg(6)->Unit(benchmark::kMicrosecond);
}

/// The exact spline spans of spine and radius.
void phase_curves(benchmark::State& state) {
  const BezierCanal canal = helical_horn(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(Curve::bezier(canal.spine));
    benchmark::DoNotOptimize(Law::bezier(canal.radius));
  }
}
BENCHMARK(phase_curves)->Apply(for_both_degrees);

void phase_circles(benchmark::State& state) {
  const EnvelopeChain chain = chain_for(state);
  const SphereCurve& curve = chain.links.front().spheres->curve;
  for (auto _ : state) benchmark::DoNotOptimize(tangent_direction(curve));
}
BENCHMARK(phase_circles)->Apply(for_both_degrees);

void phase_roots(benchmark::State& state) {
  const EnvelopeChain chain = chain_for(state);
  const RationalPolynomial discriminant = chain.links.front().spheres->circles.discriminant();
  for (auto _ : state) benchmark::DoNotOptimize(isolate_roots(discriminant, kLeastPrecision));
}
BENCHMARK(phase_roots)->Apply(for_both_degrees);

/// Roots, the search for the best choice among them, the factorization.
void phase_envelope(benchmark::State& state) {
  const EnvelopeChain chain = chain_for(state);
  const CurveOfSpheres& spheres = *chain.links.front().spheres;
  for (auto _ : state) {
    benchmark::DoNotOptimize(along_curve(spheres.curve, spheres.circles));
  }
}
BENCHMARK(phase_envelope)->Apply(for_both_degrees);

/// Curves, the tests of the input, circles, envelope.
void phase_chain(benchmark::State& state) {
  const BezierCanal canal = helical_horn(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(chain_of(canal));
}
BENCHMARK(phase_chain)->Apply(for_both_degrees);

void phase_lines(benchmark::State& state) {
  const EnvelopeChain chain = chain_for(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(lined_segments(chain, Lines::kEven, kLeastPrecision));
  }
}
BENCHMARK(phase_lines)->Apply(for_both_degrees);

/// Lines and net.
void phase_net(benchmark::State& state) {
  const EnvelopeChain chain = chain_for(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(ChainNet(chain, Lines::kEven, kLeastPrecision));
  }
}
BENCHMARK(phase_net)->Apply(for_both_degrees);

void phase_rounding(benchmark::State& state) {
  const ChainNet net(chain_for(state), Lines::kEven, kLeastPrecision);
  for (auto _ : state) benchmark::DoNotOptimize(net.section(0));
}
BENCHMARK(phase_rounding)->Apply(for_both_degrees);

void phase_regular_range(benchmark::State& state) {
  const EnvelopeChain chain = chain_for(state);
  const double tolerance = default_tolerance(chain);
  for (auto _ : state) benchmark::DoNotOptimize(regular_range(chain, tolerance));
}
BENCHMARK(phase_regular_range)->Apply(for_both_degrees);

}  // namespace
}  // namespace pn::bench
