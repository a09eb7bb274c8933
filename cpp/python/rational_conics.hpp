// SPDX-License-Identifier: LGPL-2.1-or-later
// Families of conics and all their points, without a plane or a surface.
#pragma once

#include <pybind11/pybind11.h>

void define_rational_conics(pybind11::module_& module);
