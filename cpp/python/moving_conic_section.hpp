// SPDX-License-Identifier: LGPL-2.1-or-later
// The bindings of surfaces of moving conic sections.
#pragma once

#include <pybind11/pybind11.h>

void define_moving_conic_section(pybind11::module_& module);
