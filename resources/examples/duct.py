# SPDX-License-Identifier: LGPL-2.1-or-later
"""A duct from a flat opening to a round pipe, around a bend: ellipses along a spine.

Run it as a macro in FreeCAD, or import it and call make_duct().
"""

import FreeCAD
import Part
from display import paint
from FreeCAD import Vector

import pnsurfaces

# Points that the spine, in the plane z = 0, is drawn to, in mm.
SPINE = ((0, 0, 0), (120, 0, 0), (200, 20, 0), (220, 180, 0))

# Half-axes in mm, to the side and upwards: where the air enters, at half the length, and at the pipe.
SECTIONS = ((0, 70, 18), (0.5, 44, 30), (1, 35, 35))

_SHEET = (0.70, 0.76, 0.82)


def make_duct():
    """A new document with the Spine and the solid Duct, which follows it."""
    document = FreeCAD.newDocument("Duct")
    spine = document.addObject("Part::Feature", "Spine")
    curve = Part.BezierCurve()
    curve.setPoles([Vector(*point) for point in SPINE])
    spine.Shape = curve.toShape()
    duct = pnsurfaces.make_moving_conic_section(
        spine, ("Table", SECTIONS), name="Duct", Output="Solid"
    )
    document.recompute()
    paint(_SHEET, duct)
    return document


if __name__ == "__main__":
    make_duct()
