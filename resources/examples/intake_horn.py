# SPDX-License-Identifier: LGPL-2.1-or-later
"""An intake horn: the wall of a runner that flares towards the air, between two exact offsets.

Run it as a macro in FreeCAD, or import it and call make_intake_horn().
"""

import Draft
import FreeCAD
from display import paint, show_only
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
_SECTION = (0.98, 0.78, 0.30)


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
    half_space = _half_space(document)
    cutaway = document.addObject("Part::Cut", "Cutaway")
    cutaway.Base = wall
    cutaway.Tool = half_space
    if FreeCAD.GuiUp:
        _paint(outer, inner, wall, half_space, cutaway)
    show_only(cutaway)
    document.recompute()
    return document


def _half_space(document):
    """What is cut away to open the mouth of the horn."""
    box = document.addObject("Part::Box", "HalfSpace")
    box.Length, box.Width, box.Height = 300, 100, 300
    box.Placement.Base = Vector(-100, -100, -100)
    return box


def _paint(outer, inner, wall, half_space, cutaway):
    """Metal outside, a light lining inside, the section of the wall brighter than both."""
    paint(_METAL, outer)
    paint(_LINING, inner)
    # The faces of the solid: inner and outer surface, then the two ends. A cut takes over these
    # colours and that of its tool when it is computed.
    wall.ViewObject.DiffuseColor = [_LINING, _METAL, _SECTION, _SECTION]
    paint(_SECTION, half_space)
    # It is drawn as finely as what it is cut from.
    for name in ("Deviation", "AngularDeflection"):
        setattr(cutaway.ViewObject, name, getattr(wall.ViewObject, name))


if __name__ == "__main__":
    make_intake_horn()
