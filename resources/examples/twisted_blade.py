# SPDX-License-Identifier: LGPL-2.1-or-later
"""A twisted blade: straight lines from a cubic root to a cubic tip, between two exact offsets.

Run it as a macro in FreeCAD, or import it and call make_twisted_blade().
"""

import Draft
import FreeCAD
from display import paint, show_only
from FreeCAD import Vector

import pnsurfaces

# Control points of the camber line at the root and at the tip, in mm.
ROOT = ((0, 0, 0), (0, 38, 26), (0, 86, 30), (0, 128, 4))
TIP = ((230, 22, -34), (234, 42, 2), (234, 70, 36), (230, 104, 58))

# Half the thickness of the blade, in mm.
HALF_THICKNESS = 1.5

_STEEL = (0.62, 0.66, 0.72)


def make_twisted_blade():
    """A new document with the surfaces Pressure and Suction and the solid Blade between them.

    All follow the points of Root and Tip and the distance of Suction.
    """
    document = FreeCAD.newDocument("TwistedBlade")
    curves = [_curve("Root", ROOT), _curve("Tip", TIP)]
    suction = pnsurfaces.make_ruled_offset(*curves, HALF_THICKNESS, name="Suction")
    pressure = pnsurfaces.make_ruled_offset(*curves, -HALF_THICKNESS, name="Pressure")
    blade = pnsurfaces.make_ruled_offset(
        *curves, HALF_THICKNESS, name="Blade", Sides="Both sides", Output="Solid"
    )
    pressure.setExpression("Distance", "-Suction.Distance")
    blade.setExpression("Distance", "Suction.Distance")
    document.recompute()
    paint(_STEEL, suction, pressure, blade)
    show_only(blade, *curves)
    return document


def _curve(label, points):
    curve = Draft.make_bezcurve([Vector(*point) for point in points], degree=3)
    curve.Label = label
    return curve


if __name__ == "__main__":
    make_twisted_blade()
