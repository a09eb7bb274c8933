# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact offset surfaces in FreeCAD. Lengths are millimetres.

The functions for scripts are imported when they are first used, so that FreeCAD starts as fast as
without this package. The compiled kernel is loaded when a surface is computed: a document opens, with
its stored shapes, without it.
"""

import importlib

# The functions and the modules that they are in.
_HOMES = {
    "certificate": "certificate_report",
    "export_step": "export",
    "make_canal_surface": "canal_surface",
    "make_mid_surface_skins": "mid_surface_skins",
    "make_mirror_wavefront": "mirror_wavefront",
    "make_moving_conic_section": "moving_conic_section",
    "make_quadric_offset": "quadric_offset",
    "make_ruled_offset": "ruled_offset",
    "make_squared_radius_canal": "squared_radius_canal",
    "make_triangulated_skins": "triangulated_skins",
    "open_example": "examples",
    "write_certificate": "certificate_report",
}

__all__ = list(_HOMES)


def __getattr__(name):
    if name == "__version__":
        return importlib.import_module(f"{__name__}.resources").version()
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
