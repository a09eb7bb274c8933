# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tank: the wall between an ellipsoid and its offset outwards, with a lining inside.

Run it as a macro in FreeCAD, or import it and call make_tank().
"""

import FreeCAD
from display import cut_open, paint_wall, show_only

import pnsurfaces

# Half-axes of the vessel, in mm.
HALF_LENGTH, HALF_WIDTH, HALF_HEIGHT = 1500, 900, 700

# Thickness of the steel, outwards, and of the lining, inwards, in mm.
THICKNESS, LINING = 22, 14

_STEEL = (0.50, 0.57, 0.64)
_RUBBER = (0.80, 0.42, 0.30)


def make_tank():
    """A new document with the surfaces Shell and Lining, the solid Wall between them, a Cutaway.

    Lining and Wall follow the half-axes of Shell; Wall has both distances.
    """
    document = FreeCAD.newDocument("Tank")
    ellipsoid = "Ellipsoid", HALF_LENGTH, HALF_WIDTH, HALF_HEIGHT
    shell = pnsurfaces.make_quadric_offset(*ellipsoid, THICKNESS, name="Shell")
    lining = pnsurfaces.make_quadric_offset(*ellipsoid, -LINING, name="Lining")
    wall = pnsurfaces.make_quadric_offset(
        *ellipsoid, THICKNESS, SecondDistance=-LINING, name="Wall", Sides="Two offsets", Output="Solid"
    )
    for follower in (lining, wall):
        for name in ("HalfAxisA", "HalfAxisB", "HalfAxisC"):
            follower.setExpression(name, f"Shell.{name}")
    wall.setExpression("Distance", "Shell.Distance")
    wall.setExpression("SecondDistance", "Lining.Distance")
    document.recompute()
    paint_wall(wall, ((shell, _STEEL), (lining, _RUBBER)))
    cutaway = cut_open(wall, (0, -2000, 0), (2000, 4000, 2000))
    show_only(cutaway)
    return document


if __name__ == "__main__":
    make_tank()
