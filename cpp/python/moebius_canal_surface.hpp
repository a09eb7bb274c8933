// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of pnkernel whose surfaces are canal surfaces from squared radii.
#pragma once

#include <pybind11/pybind11.h>

/// Needs PNSurface to be defined.
void define_moebius_canal_surface(pybind11::module_& module);
