# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact offset surfaces in FreeCAD. Lengths are millimetres.

The compiled kernel is loaded when a surface is computed, not when this package is imported: a
document opens, with its stored shapes, without it.
"""

from pnsurfaces.canal_surface import make_canal_surface
from pnsurfaces.certificate_report import certificate, write_certificate
from pnsurfaces.examples import open_example
from pnsurfaces.export import export_step
from pnsurfaces.quadric_offset import make_quadric_offset
from pnsurfaces.ruled_offset import make_ruled_offset

__all__ = [
    "certificate",
    "export_step",
    "make_canal_surface",
    "make_quadric_offset",
    "make_ruled_offset",
    "open_example",
    "write_certificate",
]
