# SPDX-License-Identifier: LGPL-2.1-or-later
"""The worked canal surfaces of the literature: their parametrizations meet ours in every point.

data/canal_examples.json holds the formulas, misprints corrected, each with its source.
"""

import functools
import json
from pathlib import Path

import numpy as np
import pnkernel as pn
import pytest
import sympy

EXAMPLES = json.loads((Path(__file__).parent / "data" / "canal_examples.json").read_text())
# The cubic examples are taken 9 times as large, so that spine and radius are doubles.
SCALE = 9
TOLERANCE = 1e-12  # relative: the inverse formulas lose some of the 16 digits


class Example:
    """The formulas of a source as functions of its two parameters."""

    def __init__(self, name, symbols):
        self.symbols = sympy.symbols(symbols)
        self.names = {str(symbol): symbol for symbol in self.symbols}
        for key, text in EXAMPLES[name]["definitions"].items():
            self.names[key] = sympy.sympify(text, locals=self.names)

    @functools.cache
    def function(self, name):
        return sympy.lambdify(self.symbols, self.names[name])

    def __call__(self, name, *values):
        return np.array(self.function(name)(*values), dtype=float)


def bernstein(taylor):
    """The poles over [0, 1] of sum taylor[i] t^i, of degree 3 or 2."""
    taylor = np.asarray(taylor, dtype=float)
    k = len(taylor) - 1
    matrix = [[float(sympy.binomial(i, j) / sympy.binomial(k, j)) for j in range(k + 1)]
              for i in range(k + 1)]
    return matrix @ taylor


def samples(count=40):
    random = np.random.default_rng(0)
    return random.uniform(0, 1, count), random.uniform(0, 4, count)


def test_gruber_quadratic_canal_surface():
    example = Example("gruber-canal-example", "u s t")
    surface = pn.canal_surface(pn.Curve.bezier([[0, 0, 0], [0.5, 0, 0], [1, 0, 1]]),
                               pn.Law.bezier([0, 0, 0.25]))
    assert list(surface.degree) == [4, 2]
    t, u = samples()
    for offset in (0.0, 1.0):
        points, normals = surface.offset(offset).evaluate(t, u)
        for parameter, point, normal in zip(t, points, normals, strict=True):
            a, b, c = -normal  # the source's normal points to the spine
            s_st, t_st = a / (1 + c), b / (1 + c)
            assert example("u_st", 0, s_st, t_st) == pytest.approx(parameter, abs=TOLERANCE)
            expected = example("Gamma", 0, s_st, t_st) + offset * normal
            np.testing.assert_allclose(point, expected, rtol=0, atol=TOLERANCE)


@pytest.mark.parametrize("name", ["conics-canal-surface", "diss-degree-reduction-example"])
def test_peternell_cubic_canal_surface(name):
    example = Example(name, "t u")
    t0 = 1.5
    t, u = sympy.symbols("t u")

    def taylor(expression):
        shifted = sympy.Poly(SCALE * expression.subs(t, t + sympy.Rational(t0)), t)
        coefficients = [float(c) for c in reversed(shifted.all_coeffs())]
        return coefficients + [0.0] * (4 - len(coefficients))

    spine = bernstein(np.transpose([taylor(sympy.sympify(c)) for c in example.names["m"]]))
    radius = bernstein(taylor(example.names["r"]))
    surface = pn.canal_surface(pn.Curve.bezier(spine), pn.Law.bezier(radius))
    assert list(surface.degree) == [5, 2]
    along, around = samples()
    for offset in (0.0, 1.0):
        points, normals = surface.offset(offset).evaluate(along, around)
        for local, point, normal in zip(along, points, normals, strict=True):
            parameter = t0 + local
            a, b, c = example("frame", parameter, 0) @ normal
            difference = np.array([a, b]) / (1 - c) - example("base", parameter, 0)
            place = parameter, difference[0] / difference[1]
            np.testing.assert_allclose(normal, example("n", *place), rtol=0, atol=TOLERANCE)
            expected = SCALE * example("x", *place) + offset * normal
            np.testing.assert_allclose(point, expected, rtol=0, atol=SCALE * 10 * TOLERANCE)
