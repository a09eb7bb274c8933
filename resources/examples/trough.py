# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reflector along a lamp, which spreads its light at one end and gathers it at the other.

Each section is a conic of its own with its focus at the lamp: at a distance f from the vertex, with
the eccentricity e, the radius of curvature is f (1 + e), and the conic constant -e^2.

Run it as a macro in FreeCAD, or import it and call make_trough().
"""

import FreeCAD
import Part
from display import paint, show_only
from FreeCAD import Vector

import pnsurfaces

# In mm.
LENGTH = 240
HEIGHT_OF_LAMP = 20
RADIUS_OF_LAMP = 4
DEPTH = 40

# At equal distances: hyperbolas, which spread light, a parabola, and ellipses, which gather it.
ECCENTRICITIES = (1.5, 1.25, 1.0, 0.75, 0.5)

_MIRROR = (0.80, 0.80, 0.84)
_GLASS = (0.98, 0.88, 0.45)


def make_trough():
    """A new document with two lines, the surface Trough along one and the Lamp around the other."""
    document = FreeCAD.newDocument("Trough")
    vertices, foci = (_line(document, *place) for place in (("Vertices", 0), ("Foci", HEIGHT_OF_LAMP)))
    rows = [
        (i / (len(ECCENTRICITIES) - 1), HEIGHT_OF_LAMP * (1 + e), -(e**2), DEPTH)
        for i, e in enumerate(ECCENTRICITIES)
    ]
    trough = pnsurfaces.make_moving_conic_section(vertices, vertex=("Table", rows), name="Trough")
    lamp = pnsurfaces.make_canal_surface(foci, RADIUS_OF_LAMP, name="Lamp", Output="Solid")
    document.recompute()
    show_only(trough, lamp)
    paint(_MIRROR, trough)
    paint(_GLASS, lamp)
    return document


def _line(document, name, height):
    line = document.addObject("Part::Feature", name)
    line.Shape = Part.makeLine(Vector(0, 0, height), Vector(LENGTH, 0, height))
    return line


if __name__ == "__main__":
    make_trough()
