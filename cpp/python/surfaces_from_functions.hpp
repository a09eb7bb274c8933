// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of pnkernel whose surfaces come from functions of two parameters: mirrors, planes, MOS
// surfaces.
#pragma once

#include <pybind11/pybind11.h>

/// Needs PNSurface to be defined.
void define_surfaces_from_functions(pybind11::module_& module);
