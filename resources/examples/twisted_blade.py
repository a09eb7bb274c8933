# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rotor of twisted blades: straight lines from a cubic root to a cubic tip, two exact offsets.

Run it as a macro in FreeCAD, or import it and call make_twisted_blade().
"""

import Draft
import FreeCAD
from display import draw_finely, paint, show_only
from FreeCAD import Vector

import pnsurfaces

# Control points of the camber line at the root and at the tip, in mm. The rotor turns about z.
ROOT = ((30, -26, 30), (30, -12, 4), (30, 10, -18), (30, 28, -30))
TIP = ((176, -62, 20), (206, -34, 8), (214, 22, -4), (196, 66, -26))

# Half the thickness of the blade, in mm.
HALF_THICKNESS = 1.5

# Half-axes of the ellipsoid in the middle, in mm, and number of blades around it.
HUB = 50, 50, 72
BLADES = 5

_STEEL = (0.52, 0.60, 0.70)
_BRASS = (0.84, 0.66, 0.32)


def make_twisted_blade():
    """A new document with the surfaces Suction and Pressure, the solid Blade and its Rotor.

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
    hub = pnsurfaces.make_quadric_offset("Ellipsoid", *HUB, name="Hub", Output="Solid")
    document.recompute()
    rotor = Draft.make_polar_array(blade, BLADES, 360.0, Vector(), use_link=False)
    rotor.Label = "Rotor"
    document.recompute()
    draw_finely(rotor, blade)
    paint(_STEEL, suction, pressure, blade, rotor)
    paint(_BRASS, hub)
    show_only(rotor, hub)
    return document


def _curve(label, points):
    curve = Draft.make_bezcurve([Vector(*point) for point in points], degree=3)
    curve.Label = label
    return curve


if __name__ == "__main__":
    make_twisted_blade()
