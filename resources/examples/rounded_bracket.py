# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rounded bracket: the union of all balls of six spheres, with a hole at each corner.

Run it as a macro in FreeCAD, or import it and call make_rounded_bracket().
"""

import FreeCAD
from display import draw_finely, paint, show_only
from FreeCAD import Rotation, Vector

import pnsurfaces

# The net of the mid-surface in mm: corners, then the points between them; half the thickness there.
NET = ((0, 0, 0), (150, 0, 0), (60, 120, 30), (75, 8, 34), (100, 56, 40), (36, 60, 42))
HALF_THICKNESS = (13, 13, 12, 5, 5, 5)

# Diameter of the holes, in mm.
HOLE = 11

_ALUMINIUM = (0.74, 0.77, 0.80)


def make_rounded_bracket():
    """A new document with the solid Body and the Bracket, which has a hole through each corner."""
    document = FreeCAD.newDocument("RoundedBracket")
    body = pnsurfaces.make_mid_surface_skins(
        NET, HALF_THICKNESS, document=document, name="Body", Output="Solid"
    )
    holes = document.addObject("Part::Compound", "Holes")
    holes.Links = [_hole(document, Vector(*corner)) for corner in NET[:3]]
    bracket = document.addObject("Part::Cut", "Bracket")
    bracket.Base, bracket.Tool = body, holes
    document.recompute()
    paint(_ALUMINIUM, body, bracket)
    draw_finely(bracket, body)
    show_only(bracket)
    return document


def _hole(document, corner):
    """A cylinder through a corner, along the normal of the plane of the corners."""
    a, b, c = (Vector(*point) for point in NET[:3])
    normal = (b - a).cross(c - a).normalize()
    hole = document.addObject("Part::Cylinder", "Hole")
    hole.Radius, hole.Height = HOLE / 2, 4 * max(HALF_THICKNESS)
    hole.Placement = FreeCAD.Placement(
        corner - normal * (2 * max(HALF_THICKNESS)), Rotation(Vector(0, 0, 1), normal)
    )
    return hole


if __name__ == "__main__":
    make_rounded_bracket()
