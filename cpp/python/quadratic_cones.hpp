// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of pnkernel that knows envelopes of quadratic cones.
#pragma once

#include <pybind11/pybind11.h>

/// Needs PNSurface to be defined.
void define_quadratic_cones(pybind11::module_& module);
