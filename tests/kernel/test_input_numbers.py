# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every way into the library takes numbers that are zero or between 1e-100 and 1e+100 in size."""

import numpy as np
import pnkernel as pn
import pytest
from mirrors import bezier
from test_errors import refused

LINE = np.array([[0.0, 0, 0], [0, 0, 5]])
ONE = pn.Law.constant(1)
U, V = [[0], [1]], [[0, 1]]
SPHERES = np.array(
    [[0.0, 0, 0, 1], [5, 0, 1, 1], [10, 0, 0, 1], [0, 5, 1, 1], [5, 5, 0, 1], [0, 10, 0, 1]]
)


def replaced(array, *place, by):
    array = np.array(array, dtype=float)
    array[place] = by
    return array


def mirror(**light):
    return pn.mirror(bezier([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]]), **light)


def triangulated(radius):
    centres = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    derivatives = np.tile([[1.0, 0, 0, 0], [0, 1, 0, 0]], (3, 1, 1))
    return pn.sphere_family_powell_sabin(centres, [1, radius, 1], derivatives, [[0, 1, 2]])


ENTRANCES = {
    "pole": lambda x: pn.Curve.bezier(replaced(LINE, 0, 2, by=x)),
    "weight": lambda x: pn.Curve.bezier(LINE, [1, x]),
    "knot": lambda x: pn.Curve.bspline(1, [0, x], [2, 2], LINE),
    "radius": lambda x: pn.Law.constant(x),
    "coefficient of a law": lambda x: pn.Law.bezier([1, x]),
    "weight of a law": lambda x: pn.Law.bezier([1, 2], [x, 1]),
    "distance": lambda x: pn.canal_surface(pn.Curve.bezier(LINE), ONE).offset(x),
    "distance of a quadric": lambda x: pn.quadric("ellipsoid", 3, 2, 1).offset(x),
    "half-axis": lambda x: pn.quadric("ellipsoid", 3, x, 1),
    "bound of a quadric": lambda x: pn.quadric("elliptic_cylinder", 3, 2, 1, {"z": (-1, x)}),
    "number of a sphere": lambda x: pn.sphere_family(replaced(SPHERES, 4, 1, by=x)),
    "sphere to classify": lambda x: pn.classify_family(replaced(SPHERES, 2, 1, by=x)),
    "sphere of a spline": lambda x: pn.SphereSpline.bezier(replaced(SPHERES[:3], 2, 3, by=x)),
    "sphere of a triangulation": triangulated,
    "direction of light": lambda x: mirror(direction=(x, 0, 1)),
    "source of light": lambda x: mirror(source=(0, x, 1)),
    "coefficient of a function": lambda x: pn.pn_surface([[[0, x]], U, V, U], U),
    "cone": lambda x: pn.quadratic_cone_envelope(np.full((2, 4), x), np.full((2, 3, 3), 1.0)),
    "conic": lambda x: pn.conic_surface(np.full((2, 4, 3), 1.0), np.diag([x, 1, 1])[None]),
    "spine of a Möbius canal surface": lambda x: pn.moebius_canal_surface(np.full((3, 5), x)),
}


BAD = {"not_finite": (np.nan, np.inf, -np.inf), "out_of_range": (1e101, -1e308, 1e-101, -5e-324)}
# An infinite bound is none.
CASES = [
    (entrance, code, number)
    for entrance in ENTRANCES
    for code, numbers in BAD.items()
    for number in numbers
    if not (entrance == "bound of a quadric" and np.isinf(number))
]


@pytest.mark.parametrize(("entrance", "code", "number"), CASES)
def test_what_no_drawing_has_is_refused_at_once(entrance, code, number):
    sentence = refused(code, lambda: ENTRANCES[entrance](number))
    if code == "out_of_range":
        assert f"{number:g}" in sentence
