# SPDX-License-Identifier: LGPL-2.1-or-later
"""A dome with an oculus, eight-sided in plan, whose wall grows from the oculus to the foot.

Run it as a macro in FreeCAD, or import it and call make_dome().
"""

import math

import FreeCAD
from display import hide_edges, paint_faces, show_only

import pnsurfaces

# The mid-surface is part of a sphere: its radius in mm, and where its middle is below the plane of
# the foot.
RADIUS, BELOW = 6200, 3600

# Distances of the rings of points from the axis, in mm, and half the thickness of the wall there.
RINGS = (900, 2900, 5000)
HALF_THICKNESS = (60, 110, 260)

# Points of each ring; every other ring is turned by half a step.
SIDES = 8

_OUTSIDE = (0.62, 0.70, 0.72)
_INSIDE = (0.84, 0.62, 0.42)


def make_dome():
    """A new document with the two skins of the wall as the object Dome.

    Change its Centres, Radii or Distance: all skins stay exact and smooth.
    """
    document = FreeCAD.newDocument("Dome")
    places = [_place(ring, step) for ring in range(len(RINGS)) for step in range(SIDES)]
    points = [(x, y, math.sqrt(RADIUS**2 - x * x - y * y) - BELOW) for x, y in places]
    radii = [half for half in HALF_THICKNESS for _ in range(SIDES)]
    dome = pnsurfaces.make_triangulated_skins(
        points,
        radii,
        _triangles(),
        slopes=[_slopes(*place) for place in places],
        document=document,
        name="Dome",
    )
    document.recompute()
    inner, outer = (len(shell.Faces) for shell in dome.Shape.Shells)
    paint_faces(dome, (inner, _INSIDE), (outer, _OUTSIDE))
    hide_edges(dome)
    show_only(dome)
    return document


def _place(ring, step):
    """x and y of a point of a ring."""
    angle = 2 * math.pi * (step + ring / 2) / SIDES
    return RINGS[ring] * math.cos(angle), RINGS[ring] * math.sin(angle)


def _slopes(x, y):
    """How fast height and half the thickness change along x and along y."""
    ring = math.hypot(x, y)
    fall = -1 / math.sqrt(RADIUS**2 - ring**2)
    growth = _growth(ring) / ring
    return (fall * x, growth * x), (fall * y, growth * y)


def _growth(ring):
    """How fast half the thickness grows with the distance from the axis: that of a parabola."""
    (a, b, c), (p, q, r) = RINGS, HALF_THICKNESS
    first, second = (q - p) / (b - a), (r - q) / (c - b)
    bend = (second - first) / (c - a)
    return first + bend * (2 * ring - a - b)


def _triangles():
    """Two for every side of a band between two rings, counterclockwise."""
    found = []
    for ring in range(len(RINGS) - 1):
        for step in range(SIDES):
            after = (step + 1) % SIDES
            inner, inner_after = SIDES * ring + step, SIDES * ring + after
            outer, outer_after = inner + SIDES, inner_after + SIDES
            found += [(inner, outer, inner_after), (inner_after, outer, outer_after)]
    return found


if __name__ == "__main__":
    make_dome()
