// SPDX-License-Identifier: LGPL-2.1-or-later
// What cannot be made is a result too: a benchmark that throws becomes a row that says why.
#pragma once

#include <benchmark/benchmark.h>

#include <exception>

#include "pn/geometry_error.hpp"

namespace pn::bench {

template <class Run>
void run_or_skip(benchmark::State& state, const Run& run) {
  try {
    run();
  } catch (const GeometryError& error) {
    state.SkipWithError(to_string(error.code()).c_str());
  } catch (const std::exception& error) {
    state.SkipWithError(error.what());
  }
}

}  // namespace pn::bench
