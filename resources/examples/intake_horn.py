# SPDX-License-Identifier: LGPL-2.1-or-later
"""An intake horn: the wall of a runner that flares towards the air, between two exact offsets.

Run it as a macro in FreeCAD, or import it and call make_intake_horn().
"""

import Draft
import FreeCAD
from display import cut_open, paint_wall, show_only
from FreeCAD import Vector

import pnsurfaces

# The runner from its mouth to the cylinder head: a point of the spine and the radius there, in mm.
STATIONS = (
    (0, 0, 160, 44),
    (0, 0, 120, 32),
    (6, 4, 80, 24),
    (26, 20, 40, 20),
    (70, 38, 14, 19),
    (120, 44, 6, 19),
    (170, 36, 4, 22),
)

# Distance of the outer and of the inner surface from the runner, in mm.
HALF_THICKNESS = 2

_METAL = (0.84, 0.50, 0.31)
_LINING = (0.93, 0.92, 0.88)


def make_intake_horn():
    """A new document with the horn: Outer, Inner, the solid Wall, and a Cutaway that shows it.

    Inner and Wall follow the radii and the distance of Outer, and all follow the points of Spine.
    """
    document = FreeCAD.newDocument("IntakeHorn")
    spine = Draft.make_bspline([Vector(x, y, z) for x, y, z, _ in STATIONS])
    spine.Label = "Spine"
    radius = ("Values at vertices", [radius for _, _, _, radius in STATIONS])
    outer = pnsurfaces.make_canal_surface(spine, radius, HALF_THICKNESS, name="Outer")
    inner = pnsurfaces.make_canal_surface(spine, radius, -HALF_THICKNESS, name="Inner")
    wall = pnsurfaces.make_canal_surface(
        spine, radius, HALF_THICKNESS, name="Wall", Sides="Both sides", Output="Solid"
    )
    for follower, distance in ((inner, "-Outer.Distance"), (wall, "Outer.Distance")):
        follower.setExpression("Distance", distance)
        follower.setExpression("Radii", "Outer.Radii")
    document.recompute()
    paint_wall(wall, ((inner, _LINING), (outer, _METAL)))
    cutaway = cut_open(wall, (-100, -100, -100), (300, 100, 300))
    show_only(cutaway)
    return document


if __name__ == "__main__":
    make_intake_horn()
