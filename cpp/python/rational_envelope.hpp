// SPDX-License-Identifier: LGPL-2.1-or-later
// Of the module pnkernel: envelopes of rational two-parameter families of spheres.
#pragma once

#include <pybind11/pybind11.h>

/// Adds RationalEnvelope, sphere_family_from_surface and sphere_family_from_net.
void define_rational_envelope(pybind11::module_& module);
