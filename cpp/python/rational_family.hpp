// SPDX-License-Identifier: LGPL-2.1-or-later
// Of the module pnkernel: rational two-parameter families of spheres.
#pragma once

#include <pybind11/pybind11.h>

/// Adds RationalFamily, sphere_family_from_surface and sphere_family_from_net.
void define_rational_family(pybind11::module_& module);
