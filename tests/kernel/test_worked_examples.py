# SPDX-License-Identifier: LGPL-2.1-or-later
"""The worked examples of the literature: their parametrizations meet ours in every point.

data/worked_examples.json holds the formulas, misprints corrected, each with its source.
"""

import functools
import json
from pathlib import Path

import numpy as np
import pnkernel as pn
import pytest
import sympy

EXAMPLES = json.loads((Path(__file__).parent / "data" / "worked_examples.json").read_text())
# The cubic examples are taken 9 times as large, so that poles and radii are doubles.
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
    matrix = [
        [float(sympy.binomial(i, j) / sympy.binomial(k, j)) for j in range(k + 1)]
        for i in range(k + 1)
    ]
    return matrix @ taylor


def cubic_spheres(example, centre, radius, start):
    """Centres and radii over [start, start + 1]."""
    t = sympy.Symbol("t")

    def taylor(expression):
        shifted = sympy.Poly(SCALE * expression.subs(t, t + sympy.Rational(start)), t)
        coefficients = [float(c) for c in reversed(shifted.all_coeffs())]
        return coefficients + [0.0] * (4 - len(coefficients))

    poles = bernstein(np.transpose([taylor(sympy.sympify(c)) for c in example.names[centre]]))
    return pn.Curve.bezier(poles), pn.Law.bezier(bernstein(taylor(example.names[radius])))


def samples(count=40):
    random = np.random.default_rng(0)
    return random.uniform(0, 1, count), random.uniform(0, 4, count)


def test_gruber_quadratic_canal_surface():
    example = Example("gruber-canal-example", "u s t")
    surface = pn.canal_surface(
        pn.Curve.bezier([[0, 0, 0], [0.5, 0, 0], [1, 0, 1]]), pn.Law.bezier([0, 0, 0.25])
    )
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
    surface = pn.canal_surface(*cubic_spheres(example, "m", "r", t0))
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


# Cones ----------------------------------------------------------------------------------------------


def test_peternell_skew_family_of_cones():
    example = Example("mos-skew-ruled-surface", "u t")
    low, high = 1.25, 1.5

    def poles(c0, c1, c2):
        """Of c0 + c1 u + c2 u^2 over [low, high]."""
        return [
            c0 + c1 * low + c2 * low**2,
            c0 + c1 * (low + high) / 2 + c2 * low * high,
            c0 + c1 * high + c2 * high**2,
        ]

    def curve(*coordinates):
        return pn.Curve.bezier(np.transpose([poles(*c) for c in coordinates]))

    near = curve((0, 0, 1), (0, 0, 0), (0, 1, 0))
    far = curve((0, 0, 1), (-0.5, 0, -0.5), (0, 1, 0))  # v = -1/2: the sphere has radius u
    surface = pn.cone_envelope(near, pn.Law.constant(0), far, pn.Law.bezier(poles(0, 1, 0)))
    random = np.random.default_rng(0)
    along, across = random.uniform(0, 1, 40), random.uniform(0, 1, 40)
    for offset in (0.0, 0.5):
        points, normals = surface.offset(offset).evaluate(along, across)
        for local, point, normal in zip(along, points, normals, strict=True):
            u = low + local * (high - low)
            # n is n0 reflected in q: so q is the combination of both whose first coordinate is 0
            # and whose last is 1 + u^2.
            n0 = example("n0", u, 0)
            basis = np.transpose([n0, [*normal, 1]])
            q = basis @ np.linalg.solve(basis[[0, 3]], [0, 1 + u**2])
            place = u, q[2] / (2 * (1 - u**2))
            np.testing.assert_allclose(example("n", *place), normal, rtol=0, atol=10 * TOLERANCE)
            expected = example("x", *place) + offset * normal
            np.testing.assert_allclose(point, expected, rtol=0, atol=10 * TOLERANCE)


def test_peternell_cones_along_the_tangents_of_a_curve_of_spheres():
    # They envelop the canal surface along the curve: the family is developable.
    example = Example("diss-envelope-of-cones", "t u")
    families = [cubic_spheres(example, *names, 5) for names in (("ma", "ra"), ("mb", "rb"))]
    with pytest.raises(pn.GeometryError) as caught:
        pn.cone_envelope(*families[0], *families[1])
    assert caught.value.code == "developable"


# Quadrics -------------------------------------------------------------------------------------------


def rational_sets(name):
    entry = EXAMPLES[name]
    return [dict(zip(entry["parameters"], values, strict=True)) for values in entry["rational"]]


def with_values(name, symbols, values):
    example = Example(name, symbols)
    known = {example.names.get(key, sympy.Symbol(key)): value for key, value in values.items()}
    known |= {sympy.Symbol(key): value for key, value in values.items()}
    for key, expression in example.names.items():
        if isinstance(expression, list):
            example.names[key] = [sympy.sympify(e).subs(known) for e in expression]
        else:
            example.names[key] = sympy.sympify(expression).subs(known)
    return example


def half_circle_parameter(direction):
    """u with ((u^2 - 1), 2 u) along a direction of the plane."""
    angle = np.angle(direction)
    return 1 / np.tan(angle / 2)


@pytest.mark.parametrize("values", rational_sets("diss-ellipsoid-of-revolution"))
@pytest.mark.parametrize("offset", [0.0, 1.0])
def test_peternell_ellipsoid_of_revolution(values, offset):
    example = with_values("diss-ellipsoid-of-revolution", "t u dist", values)
    a, c, mu = values["a"], values["c"], values["mu"]
    surface = pn.quadric("ellipsoid", a, a, c)
    assert list(surface.degree) == [8, 2]
    random = np.random.default_rng(0)
    moved = surface.offset(offset)
    for point, normal in zip(
        *moved.evaluate(random.uniform(0.05, 0.95, 30), random.uniform(2, 4, 30)), strict=True
    ):
        # n3 = a (t^4 - 1) / (a t^4 + 2 c t^2 + a)
        squares = np.roots([a * (1 - normal[2]), -2 * c * normal[2], -a * (1 + normal[2])])
        t = np.sqrt(max(squares))
        u = half_circle_parameter(
            (normal[0] + 1j * normal[1]) / (-mu * (t**2 + 1) + 1j * t * (a - c))
        )
        np.testing.assert_allclose(example("n", t, u, offset), normal, rtol=0, atol=TOLERANCE)
        np.testing.assert_allclose(example("x", t, u, offset), point, rtol=0, atol=a * 10 * TOLERANCE)


@pytest.mark.parametrize("values", rational_sets("diss-triaxial-ellipsoid"))
def test_peternell_triaxial_ellipsoid(values):
    example = with_values("diss-triaxial-ellipsoid", "t u", values)
    a, b, c, al, ga = (values[name] for name in ("a", "b", "c", "al", "ga"))
    turn = np.array(
        [[a * al, 0, -c * ga], [0, b * np.sqrt(a * a - c * c), 0], [c * ga, 0, a * al]]
    ) / (b * np.sqrt(a * a - c * c))
    surface = pn.quadric("ellipsoid", a, b, c)
    random = np.random.default_rng(0)
    for point, normal in zip(
        *surface.evaluate(random.uniform(0.05, 0.95, 30), random.uniform(2, 4, 30)), strict=True
    ):
        turned = turn @ normal
        height = normal @ point
        # The plane contains m1(t), quadratic in t^2; it is the same with both orientations.
        found = []
        for sign in (1, -1):
            n, h = sign * turned, sign * height
            squares = np.roots(
                [
                    al * ga * n[0] + a * c * n[2] - b * h,
                    2 * b * b * n[2],
                    al * ga * n[0] + a * c * n[2] + b * h,
                ]
            )
            for t in np.sqrt(
                [square.real for square in squares if abs(square.imag) < 1e-9 and square.real > 0]
            ):
                for place in (t, -t):
                    f = example("f", place, 0)
                    y = n[:2] / (1 - n[2]) - f
                    u = y[0] / y[1]
                    found.append(np.abs(example("plane", place, u) / [1, 1, 1, a] - [*n, h / a]).max())
        assert min(found) < 1e-10


def test_peternell_lemniscate_of_a_hyperboloid():
    example = Example("mos-hyperboloid-lemniscate", "x y z")
    surface = pn.quadric("one_sheet_hyperboloid", 1, 1, 1, {"z": (-0.5, 0.5)})
    random = np.random.default_rng(0)
    for point, normal in zip(
        *surface.evaluate(random.uniform(0, 4, 40), random.uniform(0, 1, 40)), strict=True
    ):
        reflected = 2 * (normal @ point) * normal
        assert abs(example("F", *reflected)) < 10 * TOLERANCE
