// SPDX-License-Identifier: LGPL-2.1-or-later
// Offsets of quadrics and ruled surfaces, from the designer's numbers to certified poles, and what
// comes after.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "offset_cases.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/bezier/offset_limits.hpp"
#include "pn/bezier/trimming.hpp"
#include "run_or_skip.hpp"

namespace pn::bench {
namespace {

/// The check of the input, the choice of roots, the factorization.
void chain(benchmark::State& state, const OffsetCase& offset) {
  for (auto _ : state) benchmark::DoNotOptimize(chain_of(offset.base));
}

/// Chain, net and rounding.
void numbers_to_whole_faces(benchmark::State& state, const OffsetCase& offset) {
  std::vector<RoundedFace> faces;
  for (auto _ : state) faces = whole_faces(chain_of(offset.base), offset.distance);
  std::size_t poles = 0;
  double deviation = 0;
  for (const RoundedFace& face : faces) {
    poles += face.surface.poles.size();
    deviation = std::max(deviation, face.deviation);
    state.counters["degree_along"] = face.surface.u_degree;
    state.counters["degree_around"] = face.surface.v_degree;
  }
  state.counters["poles"] = static_cast<double>(poles);
  state.counters["stated_deviation"] = deviation;
}

ChainNet net_of(const EnvelopeChain& chain, double distance) {
  return at_sufficient_precision([&](long bits) {
    ChainNet net(chain, Lines::kEven, bits);
    net.section(distance);
    return net;
  });
}

void another_distance(benchmark::State& state, const OffsetCase& offset) {
  const EnvelopeChain chain = chain_of(offset.base);
  const ChainNet net = net_of(chain, offset.distance);
  double distance = offset.distance;
  // Where a coordinate nearly vanishes the net's bits do not suffice.
  const auto section = [&](long bits) {
    return bits == net.precision() ? net.section(distance)
                                   : ChainNet(chain, Lines::kEven, bits).section(distance);
  };
  for (auto _ : state) {
    distance += 1.0 / 1024;
    benchmark::DoNotOptimize(at_sufficient_precision(section, net.precision()));
  }
}

/// The trims of all faces, and how far they are off.
void edges(benchmark::State& state, const OffsetCase& offset) {
  const EnvelopeChain chain = chain_of(offset.base);
  const ChainNet net = net_of(chain, offset.distance);
  const std::vector<RoundedFace> faces = net.section(offset.distance);
  for (auto _ : state) {
    double deviation = 0;
    for (const TrimmedFace& face : trimmed_faces(chain, net)) {
      deviation = std::max(deviation, trim_deviation(faces[face.net_face].surface, face));
    }
    state.counters["trim_deviation"] = deviation;
  }
}

void limits(benchmark::State& state, const OffsetCase& offset) {
  const EnvelopeChain chain = chain_of(offset.base);
  const double tolerance = default_tolerance(chain);
  for (auto _ : state) benchmark::DoNotOptimize(regular_range(chain, tolerance));
}

bool register_all() {
  const std::pair<const char*, void (*)(benchmark::State&, const OffsetCase&)> steps[] = {
      {"chain", chain},
      {"numbers_to_whole_faces", numbers_to_whole_faces},
      {"another_distance", another_distance},
      {"edges", edges},
      {"limits", limits}};
  for (const OffsetCase& offset : offset_cases()) {
    for (const auto& [name, step] : steps) {
      const std::string full = "offset_step/" + offset.name + "/" + name;
      benchmark::RegisterBenchmark(full.c_str(), [=, run = step](benchmark::State& state) {
        state.SetLabel(offset.shape);
        run_or_skip(state, [&] { run(state, offset); });
      })->Unit(benchmark::kMicrosecond);
    }
  }
  return true;
}

const bool kRegistered = register_all();

}  // namespace
}  // namespace pn::bench
