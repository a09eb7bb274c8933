# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of the examples: what the command Examples offers, the demo shows and the tests check.

Another example is a script <name>.py with a function make_<name>() beside this file, an entry here,
and its picture docs/images/<name>.png, which scripts/demo makes.
"""

from typing import NamedTuple

import FreeCAD

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class Example(NamedTuple):
    """An example and what is shown of it.

    `surfaces` are the names of the objects that are exported, the first one selected in the
    pictures; `solids` are those among them that are fit for Boolean operations. The camera stands
    at `azimuth` degrees about the vertical axis and `elevation` above the horizon.
    """

    name: str
    title: str
    sentence: str
    surfaces: tuple
    solids: tuple
    azimuth: float
    elevation: float


EXAMPLES = (
    Example(
        "intake_horn",
        QT_TRANSLATE_NOOP("PNSurfaces", "Intake horn"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "A runner that flares towards the air: the wall between two offsets of a pipe with"
            " a radius at each point of its spine.",
        ),
        ("Outer", "Inner", "Wall"),
        ("Wall",),
        26,
        27,
    ),
    Example(
        "hose",
        QT_TRANSLATE_NOOP("PNSurfaces", "Hose"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "A hollow hose between two fittings: a table of radii by arc length, and a bore of"
            " one radius.",
        ),
        ("Hose", "Bore"),
        ("Hose",),
        30,
        35,
    ),
    Example(
        "reflector",
        QT_TRANSLATE_NOOP("PNSurfaces", "Reflector"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "A dish of elliptic outline: an elliptic paraboloid and its shell of even thickness.",
        ),
        ("Back", "Front", "Dish"),
        ("Dish",),
        36,
        30,
    ),
    Example(
        "saddle_roof",
        QT_TRANSLATE_NOOP("PNSurfaces", "Saddle roof"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces", "A hyperbolic paraboloid of concrete, equally thick everywhere."
        ),
        ("Upper", "Lower", "Shell"),
        ("Shell",),
        40,
        24,
    ),
    Example(
        "cooling_tower",
        QT_TRANSLATE_NOOP("PNSurfaces", "Cooling tower"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces", "The wall of a one-sheet hyperboloid, equally thick from foot to rim."
        ),
        ("Outer", "Inner", "Wall"),
        ("Wall",),
        40,
        24,
    ),
    Example(
        "twisted_blade",
        QT_TRANSLATE_NOOP("PNSurfaces", "Twisted blade"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "A rotor of blades between two offsets of the ruled surface from root to tip.",
        ),
        ("Suction", "Pressure", "Blade"),
        ("Blade", "Hub"),
        30,
        40,
    ),
    Example(
        "tank",
        QT_TRANSLATE_NOOP("PNSurfaces", "Ellipsoidal tank"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "A tank with three different half-axes: the wall between two offsets of an ellipsoid,"
            " and its lining.",
        ),
        ("Shell", "Lining", "Wall"),
        ("Wall",),
        40,
        24,
    ),
    Example(
        "rounded_bracket",
        QT_TRANSLATE_NOOP("PNSurfaces", "Rounded bracket"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "The union of all balls of six spheres, rounded everywhere, with a hole at each corner.",
        ),
        ("Body",),
        ("Body",),
        20,
        40,
    ),
    Example(
        "dome",
        QT_TRANSLATE_NOOP("PNSurfaces", "Dome"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "Both skins of an eight-sided dome whose wall grows from the oculus to the foot: a"
            " sphere and a tangent plane at each point of a triangulation.",
        ),
        ("Dome",),
        (),
        15,
        -28,
    ),
    Example(
        "mirror_dish",
        QT_TRANSLATE_NOOP("PNSurfaces", "Mirror with its wavefronts"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "A dish that light falls on obliquely, and the wavefronts on their way to the focus:"
            " exact offsets of each other.",
        ),
        ("Near", "Middle", "Far"),
        (),
        30,
        20,
    ),
    Example(
        "duct",
        QT_TRANSLATE_NOOP("PNSurfaces", "Duct"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "A duct from a flat opening to a round pipe, around a bend: true ellipses along a spine.",
        ),
        ("Duct",),
        ("Duct",),
        -65,
        30,
    ),
    Example(
        "spray",
        QT_TRANSLATE_NOOP("PNSurfaces", "Spray"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "What evaporating drops sweep on their flight: the squared radius is linear along a"
            " parabola.",
        ),
        ("Drop1", "Drop2", "Drop3", "Drop4", "Drop5"),
        ("Drop1", "Drop2", "Drop3", "Drop4", "Drop5"),
        -50,
        30,
    ),
    Example(
        "trough",
        QT_TRANSLATE_NOOP("PNSurfaces", "Trough"),
        QT_TRANSLATE_NOOP(
            "PNSurfaces",
            "A reflector along a lamp: hyperbolas that spread its light, then a parabola, then"
            " ellipses that gather it.",
        ),
        ("Trough", "Lamp"),
        ("Lamp",),
        50,
        30,
    ),
)
