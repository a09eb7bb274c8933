// SPDX-License-Identifier: LGPL-2.1-or-later
// One shape made in several ways: time from numbers to a shape, and everything that is measured of
// the shape.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "made_shape.hpp"
#include "measured_shape.hpp"

namespace pn::bench {

struct Way {
  std::string name;   ///< "fine_sweep"
  std::string label;  ///< "MakePipeShell, 1e-9"
  std::function<MadeShape()> make;
};

/// Registers a benchmark "case/name" for each way. A way that throws becomes a row that says why.
void register_side_by_side(const std::string& case_name, const PointError& error,
                           const std::vector<Way>& ways);

}  // namespace pn::bench
