# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hose between two fittings: radii in a table by arc length, and a bore of one radius.

Run it as a macro in FreeCAD, or import it and call make_hose().
"""

import Draft
import FreeCAD
from display import cut_open, paint_wall, show_only
from FreeCAD import Vector

import pnsurfaces

# Points of the spine, in mm.
SPINE = (
    (0, 0, 0),
    (0, 0, 60),
    (30, 25, 130),
    (110, 50, 150),
    (180, 20, 110),
    (240, 0, 100),
    (300, 0, 100),
)

# Positions along the spine and radii outside there, in mm: thick at the fittings, thin between.
RADII = ((0, 17), (40, 17), (75, 13), (180, 12), (290, 13), (340, 17), (400, 17))

# Radius of the bore, in mm.
BORE = 8

_RUBBER = (0.24, 0.27, 0.32)
_LINING = (0.78, 0.80, 0.82)


def make_hose():
    """A new document with the spine, the solid Hose around its Bore, and a Cutaway.

    The hose follows the radius of Bore, and both follow the points of Spine.
    """
    document = FreeCAD.newDocument("Hose")
    spine = Draft.make_bspline([Vector(*point) for point in SPINE])
    spine.Label = "Spine"
    bore = pnsurfaces.make_canal_surface(spine, BORE, name="Bore")
    outside = pnsurfaces.make_canal_surface(
        spine, ("Table", RADII), name="Outside", PositionBy="Arc length"
    )
    hose = pnsurfaces.make_canal_surface(
        spine,
        ("Table", RADII),
        name="Hose",
        PositionBy="Arc length",
        Hollow="Inner radius",
        InnerRadius=BORE,
        Output="Solid",
    )
    hose.setExpression("InnerRadius", "Bore.Radius")
    hose.setExpression("Radii", "Outside.Radii")
    document.recompute()
    paint_wall(hose, ((outside, _RUBBER), (bore, _LINING)))
    cutaway = cut_open(hose, (190, -60, 0), (200, 70, 200))
    show_only(cutaway)
    return document


if __name__ == "__main__":
    make_hose()
