# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cooling tower: the wall of a one-sheet hyperboloid, equally thick from foot to rim.

Run it as a macro in FreeCAD, or import it and call make_cooling_tower().
"""

import FreeCAD
from display import cut_open, paint_wall, show_only

import pnsurfaces

# Radius of the throat and the half-axis along the tower, in mm.
THROAT, HALF_AXIS = 26000, 62000

# Foot and rim above the throat, in mm.
FOOT, RIM = -85000, 25000

# Half the thickness of the wall, in mm.
HALF_THICKNESS = 600

_OUTSIDE = (0.78, 0.76, 0.71)
_INSIDE = (0.62, 0.66, 0.70)


def make_cooling_tower():
    """A new document with the surfaces Outer and Inner, the solid Wall between them, a Cutaway.

    Inner and Wall follow the distance of Outer.
    """
    document = FreeCAD.newDocument("CoolingTower")
    kind = "One-sheet hyperboloid", THROAT, THROAT, HALF_AXIS
    bounds = {"z": (FOOT, RIM)}
    outer = pnsurfaces.make_quadric_offset(*kind, HALF_THICKNESS, bounds=bounds, name="Outer")
    inner = pnsurfaces.make_quadric_offset(*kind, -HALF_THICKNESS, bounds=bounds, name="Inner")
    wall = pnsurfaces.make_quadric_offset(
        *kind, HALF_THICKNESS, bounds=bounds, name="Wall", Sides="Both sides", Output="Solid"
    )
    inner.setExpression("Distance", "-Outer.Distance")
    wall.setExpression("Distance", "Outer.Distance")
    document.recompute()
    paint_wall(wall, ((outer, _OUTSIDE), (inner, _INSIDE)))
    cutaway = cut_open(wall, (0, -90000, -90000), (90000, 90000, 120000))
    show_only(cutaway)
    return document


if __name__ == "__main__":
    make_cooling_tower()
