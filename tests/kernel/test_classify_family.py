# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of families of spheres, on the worked examples of the literature."""

import json
from pathlib import Path

import numpy as np
import pnkernel as pn
import pytest
import sympy
from test_errors import refused

DATA = Path(__file__).parents[1] / "cpp" / "data" / "minkowski_space.json"
FAMILIES = [f for f in json.loads(DATA.read_text())["families"] if "net" in f]
CORNERS = np.array([[1, 0], [0, 1], [0, 0]])


def control_spheres(family, corners):
    """Of (m, r) as formulas in u and v, over the triangle with these corners, by their blossom."""
    formula = sympy.lambdify(sympy.symbols("u v"), [sympy.sympify(f) for f in family])
    at = [np.array(formula(*corner), dtype=float) for corner in corners]

    def middle(i, j):
        halfway = np.array(formula(*(corners[i] + corners[j]) / 2), dtype=float)
        return 2 * halfway - (at[i] + at[j]) / 2

    return np.array([at[0], middle(0, 1), at[1], middle(0, 2), middle(1, 2), at[2]])


@pytest.mark.parametrize("family", FAMILIES, ids=lambda f: f["id"])
@pytest.mark.parametrize("corners", [CORNERS, 2 * CORNERS + [[3, -5], [1, 0.5], [-2, 7]]])
def test_worked_examples(family, corners):
    assert pn.classify_family(control_spheres(family["family"], corners)) == {
        "family": family["family_class"],
        "centres": family["centres_class"],
        "radius": family["radius_class"],
        "net": family["net"],
    }


def test_six_general_spheres_have_no_net():
    kind = pn.classify_family(np.random.default_rng(1).uniform(-1, 1, (6, 4)))
    assert kind["net"] is None
    assert kind["family"] == "4-3-1b"
    assert kind["centres"] in ("3-3-1c", "3-3-2b")
    assert kind["radius"] in ("1-1-1", "1-1-2")


def test_constant_radii_are_of_dimension_zero():
    spheres = np.ones((6, 4))
    spheres[:, :3] = np.random.default_rng(2).uniform(-1, 1, (6, 3))
    kind = pn.classify_family(spheres)
    assert kind["radius"] == "0-0"
    assert kind["family"] == kind["centres"]


def test_numbers_that_are_not_finite_are_refused():
    spheres = np.ones((6, 4))
    spheres[2, 1] = np.nan
    refused("not_finite", lambda: pn.classify_family(spheres))
