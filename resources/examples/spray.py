# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drops that evaporate on their flight: what each sweeps is a canal surface of linear r^2.

The square of the radius of an evaporating drop falls steadily with time, the d^2 law. Its path is a
parabola, run through in time, so that r^2 is linear along it and r is not rational.

Run it as a macro in FreeCAD, or import it and call make_spray().
"""

import math

import FreeCAD
import Part
from display import paint, show_only
from FreeCAD import Vector

import pnsurfaces

# Radii of the drops at the nozzle, in mm, drawn large; the fan in which they leave, in degrees; and
# how far from its centre.
RADII = (4, 5, 6, 5, 4)
AZIMUTHS = (-30, -15, 0, 15, 30)
ELEVATION = 25
NOZZLE = 60

# Speed at the nozzle in mm/s, gravity in mm/s^2.
SPEED = 1200
GRAVITY = Vector(0, 0, -9810)

# What r^2 loses, in mm^2/s, and what is left of it at the end, in mm^2.
EVAPORATION = 140
REST = 1

_WATER = (0.35, 0.58, 0.78)


def make_spray():
    """A new document with the solids Drop1, Drop2 ... that drops sweep along Path1, Path2 ..."""
    document = FreeCAD.newDocument("Spray")
    drops = []
    for number, (radius, azimuth) in enumerate(zip(RADII, AZIMUTHS), start=1):
        path = document.addObject("Part::Feature", f"Path{number}")
        path.Shape = _path(azimuth, (radius**2 - REST) / EVAPORATION)
        drops.append(
            pnsurfaces.make_squared_radius_canal(
                path, (radius**2, REST), name=f"Drop{number}", Output="Solid"
            )
        )
    document.recompute()
    paint(_WATER, *drops)
    show_only(*drops)
    return document


def _path(azimuth, duration):
    """The parabola of a drop over its flight of so many seconds; the parameter is the time."""
    horizontal, elevation = math.radians(azimuth), math.radians(ELEVATION)
    direction = Vector(
        math.cos(horizontal) * math.cos(elevation),
        math.sin(horizontal) * math.cos(elevation),
        math.sin(elevation),
    )
    start, way = direction * NOZZLE, direction * SPEED * duration
    curve = Part.BezierCurve()
    curve.setPoles([start, start + way / 2, start + way + GRAVITY * duration**2 / 2])
    return curve.toShape()


if __name__ == "__main__":
    make_spray()
