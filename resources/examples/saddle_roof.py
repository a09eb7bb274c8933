# SPDX-License-Identifier: LGPL-2.1-or-later
"""A saddle roof: a hyperbolic paraboloid of concrete, equally thick everywhere.

Run it as a macro in FreeCAD, or import it and call make_saddle_roof().
"""

import FreeCAD
from display import cut_open, paint_wall, show_only

import pnsurfaces

# Half the length and half the width of the plan, and the rise of the ends, in mm.
HALF_LENGTH, HALF_WIDTH, RISE = 9000, 6000, 2800

# Half the thickness of the shell, in mm.
HALF_THICKNESS = 150

_TILES = (0.66, 0.72, 0.74)
_CEILING = (0.80, 0.58, 0.38)


def make_saddle_roof():
    """A new document with the surfaces Upper and Lower, the solid Shell between them, a Cutaway.

    Lower and Shell follow the distance of Upper.
    """
    document = FreeCAD.newDocument("SaddleRoof")
    kind = "Hyperbolic paraboloid", HALF_LENGTH, HALF_WIDTH, RISE
    bounds = {"x": (-HALF_LENGTH, HALF_LENGTH), "y": (-HALF_WIDTH, HALF_WIDTH)}
    upper = pnsurfaces.make_quadric_offset(*kind, HALF_THICKNESS, bounds=bounds, name="Upper")
    lower = pnsurfaces.make_quadric_offset(*kind, -HALF_THICKNESS, bounds=bounds, name="Lower")
    shell = pnsurfaces.make_quadric_offset(
        *kind, HALF_THICKNESS, bounds=bounds, name="Shell", Sides="Both sides", Output="Solid"
    )
    lower.setExpression("Distance", "-Upper.Distance")
    shell.setExpression("Distance", "Upper.Distance")
    document.recompute()
    paint_wall(shell, ((upper, _TILES), (lower, _CEILING)))
    cutaway = cut_open(shell, (0, -10000, -10000), (20000, 10000, 20000))
    show_only(cutaway)
    return document


if __name__ == "__main__":
    make_saddle_roof()
