// SPDX-License-Identifier: LGPL-2.1-or-later
#include "side_by_side.hpp"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>

#include "pn/occt/occt_error.hpp"
#include "run_or_skip.hpp"

namespace pn::bench {
namespace {

using Counters = std::map<std::string, double>;

Counters counters_of(const MadeShape& made, const PointError& error) {
  const ShapeMeasures measures = measure(made.shape, error);
  const StepRoundTrip step = through_step(made.shape);
  const ShapeMeasures read = measure(step.read, error);
  Counters counters = {{"faces", measures.faces},
                       {"poles", measures.poles},
                       {"degree_along", measures.degree[0]},
                       {"degree_around", measures.degree[1]},
                       {"deviation", measures.deviation},
                       {"step_bytes", step.bytes},
                       {"read_faces", read.faces},
                       {"read_deviation", read.deviation}};
  if (made.stated_deviation) counters["stated_deviation"] = *made.stated_deviation;
  return counters;
}

/// What a way makes, measured when it is first asked for: benchmarks are repeated, shapes are not.
class MeasuredWay {
 public:
  MeasuredWay(Way way, PointError error) : way_(std::move(way)), error_(std::move(error)) {}

  void run(benchmark::State& state) {
    state.SetLabel(way_.label);
    run_or_skip(state, [&] {
      for (auto _ : state) benchmark::DoNotOptimize(make());
      if (!counters_) measure_once();
      state.SetLabel(label_);
      for (const auto& [name, value] : *counters_) state.counters[name] = value;
    });
  }

 private:
  MadeShape make() const { return with_occt_errors(way_.make); }

  void measure_once() {
    const MadeShape made = make();
    counters_ = with_occt_errors([&] { return counters_of(made, error_); });
    label_ = made.remark.empty() ? way_.label : way_.label + ": " + made.remark;
  }

  Way way_;
  PointError error_;
  std::optional<Counters> counters_;
  std::string label_;
};

}  // namespace

void register_side_by_side(const std::string& case_name, const PointError& error,
                           const std::vector<Way>& ways) {
  for (const Way& way : ways) {
    const std::string name = case_name + "/" + way.name;
    const auto measured = std::make_shared<MeasuredWay>(way, error);
    benchmark::RegisterBenchmark(name.c_str(), [measured](benchmark::State& state) {
      measured->run(state);
    })->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace pn::bench
