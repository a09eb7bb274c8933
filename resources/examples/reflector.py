# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reflector: a dish of elliptic outline that focuses two ways, and its shell of even thickness.

Run it as a macro in FreeCAD, or import it and call make_reflector().
"""

import FreeCAD
from display import cut_open, paint_wall, show_only

import pnsurfaces

# Half-axes of the rim and depth of the dish, in mm.
HALF_WIDTH, HALF_HEIGHT, DEPTH = 600, 380, 210

# Thickness of the shell, in mm, behind the reflecting surface.
THICKNESS = 24

_MIRROR = (0.70, 0.76, 0.82)
_BACK = (0.24, 0.34, 0.46)


def make_reflector():
    """A new document with the surfaces Front and Back, the solid Dish between them, and a Cutaway.

    Dish and Back follow the half-axes of Front, the thickness is the distance of Back.
    """
    document = FreeCAD.newDocument("Reflector")
    kind = "Elliptic paraboloid", HALF_WIDTH, HALF_HEIGHT, DEPTH
    bounds = {"z": (0, DEPTH)}
    front = pnsurfaces.make_quadric_offset(*kind, bounds=bounds, name="Front")
    back = pnsurfaces.make_quadric_offset(*kind, THICKNESS, bounds=bounds, name="Back")
    dish = pnsurfaces.make_quadric_offset(
        *kind, THICKNESS, bounds=bounds, name="Dish", Sides="Base and offset", Output="Solid"
    )
    for follower in (back, dish):
        for name in ("HalfAxisA", "HalfAxisB", "HalfAxisC", "MaxZ"):
            follower.setExpression(name, f"Front.{name}")
    dish.setExpression("Distance", "Back.Distance")
    document.recompute()
    paint_wall(dish, ((front, _MIRROR), (back, _BACK)))
    cutaway = cut_open(dish, (0, -1000, -500), (1000, 1000, 1000))
    show_only(cutaway)
    return document


if __name__ == "__main__":
    make_reflector()
