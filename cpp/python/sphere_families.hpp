// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of pnkernel that knows two-parameter families of spheres: six spheres, translational and
// Powell-Sabin families, where they are real, and of which kind.
#pragma once

#include <pybind11/pybind11.h>

/// Needs PNSurface to be defined.
void define_sphere_families(pybind11::module_& module);
