# SPDX-License-Identifier: LGPL-2.1-or-later
"""A dish that light falls on obliquely, and the wavefronts that it makes of it.

Run it as a macro in FreeCAD, or import it and call make_mirror_dish().
"""

import FreeCAD
import Part
from display import paint
from FreeCAD import Vector

import pnsurfaces

# The rim of the dish is so wide, its focal length so long, in mm.
WIDTH, FOCAL_LENGTH = 400, 300

# Light comes from so far above, slightly from the side.
HEIGHT = 300
DIRECTION = (0.12, 0.05, -1)

# Path lengths of the wavefronts, in mm: shortly behind the mirror, then nearer to the focus.
PATHS = (400, 460, 520)

_MIRROR = (0.70, 0.76, 0.82)
_WAVEFRONTS = ((0.93, 0.83, 0.45), (0.95, 0.66, 0.30), (0.93, 0.42, 0.22))


def make_mirror_dish():
    """A new document with the Mirror and its wavefronts Near, Middle and Far, which follow it.

    All three have the direction and the origin of the light of Near.
    """
    document = FreeCAD.newDocument("MirrorDish")
    mirror = document.addObject("Part::Feature", "Mirror")
    mirror.Shape = paraboloid().toShape()
    wavefronts = [
        pnsurfaces.make_mirror_wavefront(
            (mirror, ["Face1"]), path, direction=DIRECTION, origin=(0, 0, HEIGHT), name=name
        )
        for name, path in zip(("Near", "Middle", "Far"), PATHS)
    ]
    for follower in wavefronts[1:]:
        for name in ("Direction", "Origin"):
            for axis in "xyz":
                follower.setExpression(f"{name}.{axis}", f"Near.{name}.{axis}")
    document.recompute()
    paint(_MIRROR, mirror)
    for wavefront, colour in zip(wavefronts, _WAVEFRONTS):
        paint(colour, wavefront)
    return document


def paraboloid():
    """z = (x^2 + y^2) / (4 focal length) over a square, as a Bezier surface."""
    half = WIDTH / 2
    rise = half**2 / (4 * FOCAL_LENGTH)
    heights = (rise, -rise, rise)
    surface = Part.BezierSurface()
    surface.increase(2, 2)
    for i in range(3):
        for j in range(3):
            pole = Vector(half * (i - 1), half * (j - 1), heights[i] + heights[j])
            surface.setPole(i + 1, j + 1, pole)
    return surface


if __name__ == "__main__":
    make_mirror_dish()
