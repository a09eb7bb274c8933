// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of pnkernel whose surfaces are those of moving conic sections.
#pragma once

#include <pybind11/pybind11.h>

/// Needs PNSurface to be defined.
void define_moving_conic_section(pybind11::module_& module);
