// SPDX-License-Identifier: LGPL-2.1-or-later
// What the kernel promises of every input: a surface with a certificate, or a GeometryError.
//
// Everything else ends the process, which a fuzzer reports: another exception, a number that is not
// finite, a weight that is not positive, and work that goes on after it was asked to stop.
#pragma once

#include <functional>

#include "fuzz_input.hpp"
#include "pn/bezier/pn_surface.hpp"

namespace pn::fuzz {

/// Ends the process, with a sentence, unless what is promised is true.
void require(bool promise, const char* sentence);

/// Does the work in one thread, so that it can be repeated. It may throw GeometryError, and
/// Cancelled when it was asked to stop because it takes longer than seconds. Returns 0, as fuzz
/// targets do.
int expect_result_or_error(const std::function<void()>& work);

/// The faces at distance zero and at another one, of lines that `input` chooses, have positive
/// weights, finite poles and points, and a bound on their deviation.
void check_surface(const PNSurface& surface, FuzzInput& input);

}  // namespace pn::fuzz
