# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wavefronts of mirrors by the law of reflection, surfaces from planes, MOS surfaces.

data/planes_and_mirrors.json holds formulas of the literature, misprints corrected, each with its
source.
"""

import json
from math import comb
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pnkernel as pn
import pytest
import sympy
from mirrors import bezier, random_mirror
from test_errors import refused

EXAMPLES = json.loads((Path(__file__).parent / "data" / "planes_and_mirrors.json").read_text())
SYMBOLS = U, V = sympy.symbols("u v")
NAN, INFINITY = float("nan"), float("inf")
TOLERANCE = 1e-11


def formulas(name, **values):
    """The definitions of a source as expressions in u and v, with these values of its constants."""
    names = {**{str(s): s for s in SYMBOLS}, **values}
    for key, text in EXAMPLES[name]["definitions"].items():
        names[key] = sympy.sympify(text, locals=names)
    return SimpleNamespace(**names)


def derivatives(vector):
    matrix = sympy.Matrix(vector)
    return matrix.diff(U), matrix.diff(V)


def values(expressions, u, v):
    """(n, k) at parameters (n,) of k expressions."""
    function = sympy.lambdify(SYMBOLS, list(expressions))
    return np.column_stack([np.broadcast_to(x, np.shape(u)) for x in function(u, v)]).astype(float)


def coefficients(expression):
    """Those of u^i v^j."""
    p = sympy.Poly(expression, *SYMBOLS)
    result = np.zeros([max(p.degree(symbol), 0) + 1 for symbol in SYMBOLS])
    for (i, j), c in p.terms():
        result[i, j] = float(c)
    return result


def quotient(expression):
    return tuple(coefficients(part) for part in sympy.fraction(sympy.together(expression)))


def patch(point, weight=sympy.Integer(1)):
    """The Bezier patch over [0, 1]^2 of a point of polynomials over a weight."""
    arrays = [coefficients(x) for x in (*point, weight)]
    m, n = (max(a.shape[k] for a in arrays) for k in (0, 1))

    def matrix(size):
        return np.array(
            [
                [comb(i, j) / comb(size - 1, j) if j <= i else 0 for j in range(size)]
                for i in range(size)
            ]
        )

    poles = []
    for a in arrays:
        padded = np.zeros((m, n))
        padded[: a.shape[0], : a.shape[1]] = a
        poles.append(matrix(m) @ padded @ matrix(n).T)
    return bezier(np.stack(poles[:3], axis=-1) / poles[3][..., None], poles[3])


def bernstein_basis(degree, t):
    columns = [comb(degree, i) * t**i * (1 - t) ** (degree - i) for i in range(degree + 1)]
    return np.stack(columns, axis=-1)


def mirror_points(mirror, u, v):
    """Points and unit normals (n, 3), by central differences of a de Casteljau evaluation."""
    weights = np.ones(mirror.poles.shape[:2]) if mirror.weights is None else mirror.weights
    homogeneous = np.concatenate([mirror.poles * weights[..., None], weights[..., None]], axis=-1)

    def at(u, v):
        x = np.einsum(
            "ni,nj,ijk->nk",
            bernstein_basis(mirror.u_degree, u),
            bernstein_basis(mirror.v_degree, v),
            homogeneous,
        )
        return x[:, :3] / x[:, 3:]

    step = 1e-5
    normals = np.cross(at(u + step, v) - at(u - step, v), at(u, v + step) - at(u, v - step))
    return at(u, v), normals / np.linalg.norm(normals, axis=1)[:, None]


def parameters(random, count=50):
    return random.uniform(0.05, 0.95, count), random.uniform(0.05, 0.95, count)


@pytest.mark.parametrize("is_rational", [False, True])
@pytest.mark.parametrize("degrees", [(1, 1), (2, 1), (2, 2), (3, 2)])
def test_parallel_light_obeys_the_law_of_reflection(degrees, is_rational):
    random = np.random.default_rng(sum(degrees) + is_rational)
    mirror = random_mirror(random, *degrees, is_rational)
    direction, start, distance = np.array([0.3, -0.2, -2.0]), np.array([1.0, 2, 7]), 11.0
    wavefront = pn.mirror(mirror, direction=direction, start=start).offset(distance)
    assert len(wavefront.bsplines()) == 1
    u, v = parameters(random)
    x, normal = mirror_points(mirror, u, v)
    light = direction / np.linalg.norm(direction)
    point, ray = wavefront.evaluate(u, v)
    reflected = light - 2 * (normal @ light)[:, None] * normal
    assert np.abs(ray - reflected).max() < 1e-9
    path = (x - start) @ light
    assert np.abs(x + (distance - path)[:, None] * ray - point).max() < TOLERANCE * 10
    assert wavefront.certificate.exact
    assert wavefront.certificate.deviation < 1e-13


def test_light_of_a_point_obeys_the_law_of_reflection():
    random = np.random.default_rng(4)
    mirror, source = random_mirror(random, 2, 2, False), np.array([5.0, 4, 6])
    wavefront = pn.mirror(mirror, source=source)
    u, v = parameters(random)
    x, normal = mirror_points(mirror, u, v)
    point, ray = wavefront.evaluate(u, v)
    incoming = x - source
    image = x - incoming + 2 * np.einsum("ni,ni->n", incoming, normal)[:, None] * normal
    assert np.abs(point - image).max() < 1e-8
    lengths = [np.linalg.norm(path, axis=1) for path in (point - x, incoming)]
    assert np.abs(lengths[0] - lengths[1]).max() < TOLERANCE
    outgoing = (x - point) / np.linalg.norm(x - point, axis=1)[:, None]
    assert np.abs(ray - outgoing).max() < TOLERANCE
    assert "not rational" in refused("not_rational", lambda: wavefront.offset(1))
    assert len(wavefront.certificate.notes) == 1


def test_planes_and_mirror_give_the_cyclide_of_the_literature():
    a, b = sympy.Rational(3, 4), sympy.Rational(-1, 2)
    optics, paraboloid = formulas("optics", a=a, b=b), formulas("paraboloid", a=a, b=b)
    from_planes = pn.pn_surface(
        [coefficients(x) for x in (a * U, b * V, sympy.Integer(1), sympy.Integer(0))],
        coefficients(optics.h),
    )
    reflected = pn.mirror(patch(paraboloid.p), direction=(0, 0, 1))
    u, v = parameters(np.random.default_rng(1))
    point, normal = from_planes.evaluate(u, v)
    assert np.abs(point - values(optics.q1, u, v)).max() < 1e-14
    assert np.abs(normal - values(optics.n1, u, v)).max() < 1e-14
    assert np.abs(reflected.evaluate(u, v)[0] - values(paraboloid.q, u, v)).max() < 1e-14
    assert from_planes.degree == reflected.degree == (2, 2)


def test_both_sheets_of_a_mos_surface():
    optics = formulas("optics", a=sympy.Integer(1), b=sympy.Rational(1, 2))
    centre = [q + optics.r * n for q, n in zip(optics.q1, optics.n1)]
    sheets = pn.mos_envelope([quotient(x) for x in centre], quotient(optics.r))
    u, v = parameters(np.random.default_rng(2))
    m, r = values(centre, u, v), values([optics.r], u, v)
    by_u, by_v = (values(d, u, v) for d in derivatives(centre))
    r_u, r_v = values([optics.r.diff(U)], u, v), values([optics.r.diff(V)], u, v)
    points = []
    for sheet in sheets:
        assert len(sheet.bsplines()) == 1
        point, normal = sheet.evaluate(u, v)
        assert np.abs(point - m - r * normal).max() < TOLERANCE
        assert np.abs(np.einsum("ni,ni->n", normal, by_u) + r_u[:, 0]).max() < TOLERANCE
        assert np.abs(np.einsum("ni,ni->n", normal, by_v) + r_v[:, 0]).max() < TOLERANCE
        points.append(point)
    distances = [np.abs(point - values(optics.q1, u, v)).max() for point in points]
    assert min(distances) < TOLERANCE < 0.01 < max(distances)


def test_a_radius_function_makes_a_mos_surface_along_a_surface_from_planes():
    example = formulas("radius")
    a, b, c, d = example.qa, example.qb, example.qc, example.qd
    normal = sympy.Matrix(
        [2 * (a * c + b * d), 2 * (b * c - a * d), a**2 + b**2 - c**2 - d**2]
    )
    length = a**2 + b**2 + c**2 + d**2
    equations = sympy.Matrix([list(n) for n in (normal, normal.diff(U), normal.diff(V))])
    levels = sympy.Matrix([example.h, example.h.diff(U), example.h.diff(V)])
    centre = equations.LUsolve(levels) + example.wf * normal
    sheets = pn.mos_envelope(
        [quotient(sympy.cancel(x)) for x in centre], quotient(example.wf * length)
    )
    surface = pn.pn_surface([coefficients(x) for x in (a, b, c, d)], coefficients(example.h))
    u, v = parameters(np.random.default_rng(3))
    point, normals = surface.evaluate(u, v)
    found = [sheet.evaluate(u, v) for sheet in sheets if len(sheet.bsplines()) == 1]
    distances = [np.abs(p - point).max() + np.abs(n + normals).max() for p, n in found]
    assert min(distances) < TOLERANCE


def test_spheres_that_touch_a_plane_are_a_mos_surface():
    paraboloid = formulas("paraboloid", a=sympy.Integer(1), b=sympy.Integer(2))
    sheets = pn.mos_envelope([quotient(x) for x in paraboloid.p], quotient(paraboloid.p[2]))
    u, v = parameters(np.random.default_rng(2))
    heights = [np.abs(sheet.evaluate(u, v)[0][:, 2]).max() for sheet in sheets]
    assert min(heights) < 1e-15
    other = sheets[int(np.argmax(heights))].evaluate(u, v)[0]
    assert np.abs(other - values(paraboloid.q, u, v)).max() < TOLERANCE


def test_the_hyperboloid_reflects_light_from_its_centre_into_a_lemniscate_of_revolution():
    example = formulas("lemniscate")
    m = [sympy.cancel((x * (U + V)).subs({U: U + 1, V: V + 1}, simultaneous=True)) for x in example.m]
    wavefront = pn.mirror(patch(m, U + V + 2), source=(0, 0, 0))
    x, y, z = wavefront.evaluate(*parameters(np.random.default_rng(5)))[0].T
    symbols = sympy.symbols("x y z")
    assert np.abs(sympy.lambdify(symbols, example.F)(x, y, z)).max() < 1e-12
    assert wavefront.certificate.notes


def test_the_anticaustic_map():
    c = sympy.Rational(5, 2)
    symbols = {f"{n}{i}": sympy.Symbol(f"{n}{i}") for n in "pm" for i in range(3)}
    p = formulas("anticaustic", c=c, **symbols)
    by_u, by_v = derivatives(p.p)
    m = by_u.cross(by_v)
    known = {f"p{i}": p.p[i] for i in range(3)} | {f"m{i}": m[i] for i in range(3)}
    expected = [x.subs(known) for x in p.anticaustic]
    wavefront = pn.mirror(patch(p.p), direction=(0, 0, -1), start=(0, 0, float(c)))
    u, v = parameters(np.random.default_rng(5))
    count = len(wavefront.bsplines())
    assert count == 1
    assert np.abs(wavefront.evaluate(u, v)[0] - values(expected, u, v)).max() < TOLERANCE


@pytest.mark.parametrize("name", ["universal", "radius"])
def test_the_universal_parametrization(name):
    """The surface satisfies the equations of the planes and of their derivatives."""
    example = formulas(name)
    a, b, c, d = example.qa, example.qb, example.qc, example.qd
    normal = [2 * (a * c + b * d), 2 * (b * c - a * d), a**2 + b**2 - c**2 - d**2]
    length = a**2 + b**2 + c**2 + d**2
    # Off the parameters where the normals are stationary.
    moved = {U: U + 2, V: V - 1}
    a, b, c, d, h = (
        sympy.expand(sympy.sympify(x).subs(moved, simultaneous=True)) for x in (a, b, c, d, example.h)
    )
    surface = pn.pn_surface([coefficients(x) for x in (a, b, c, d)], coefficients(h))
    u, v = parameters(np.random.default_rng(6))
    faces = surface.bsplines()
    assert len(faces) == 1
    for distance in (0.0, 1.5):
        level = example.h + distance * length
        point, unit = surface.offset(distance).evaluate(u, v)
        equations = [(normal, level), *zip(derivatives(normal), (level.diff(U), level.diff(V)))]
        for vector, right in equations:
            left = np.einsum("ni,ni->n", values(vector, u + 2, v - 1), point)
            right = values([right], u + 2, v - 1)[:, 0]
            assert np.abs(left - right).max() < TOLERANCE * max(1, np.abs(right).max()) * 10
        expected = values([x / length for x in normal], u + 2, v - 1)
        assert np.abs(unit - expected).max() < 1e-13


def test_regular_range_of_light_from_the_axis_ends_at_the_focus():
    mirror = patch([2 * U - 1, 2 * V - 1, ((2 * U - 1) ** 2 + (2 * V - 1) ** 2) / 4])
    wavefront = pn.mirror(mirror, direction=(0, 0, -1), start=(0, 0, 5))
    lower, upper = wavefront.regular_range
    assert lower == -INFINITY
    assert 6 - 1e-5 < upper <= 6
    assert np.allclose(wavefront.focal_points[1].point, [0, 0, 1])


def test_a_spline_mirror_gives_a_face_for_every_span():
    face = SimpleNamespace(
        u_degree=2,
        v_degree=1,
        u_knots=[0, 1, 2],
        v_knots=[0, 1],
        u_multiplicities=[3, 1, 3],
        v_multiplicities=[2, 2],
        weights=None,
        poles=np.array([[[i, 3 * j, 0.1 * i * i] for j in range(2)] for i in range(4)], dtype=float),
    )
    wavefront = pn.mirror(face, direction=(0, 0.1, -1), start=(0, 0, 5)).offset(6)
    assert len(wavefront.bsplines()) == 2
    v = np.linspace(0, 1, 7)
    left, right = (wavefront.evaluate(np.full(7, t), v) for t in (1 - 1e-14, 1.0))
    for a, b in zip(left, right):
        assert np.abs(a - b).max() < 1e-12


PLANE = bezier([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]])


@pytest.mark.parametrize(
    "code, light",
    [
        ("grazing_light", {"direction": (1, 2, 0)}),
        ("grazing_light", {"source": (4, 4, 0)}),
        ("light_on_mirror", {"source": (0.25, 0.25, 0)}),
        ("light_on_mirror", {"source": (1, 1, 0)}),
        ("zero_length", {"source": (0, 0, 2)}),
        ("zero_length", {"direction": (0, 0, 0)}),
        ("not_finite", {"direction": (NAN, 0, 1)}),
        ("not_finite", {"source": (0, INFINITY, 1)}),
    ],
)
def test_light_that_is_not_reflected(code, light):
    refused(code, lambda: pn.mirror(PLANE, **light))


def test_bad_input():
    for light in ({}, {"direction": (0, 0, 1), "source": (0, 0, 1)}):
        with pytest.raises(ValueError, match="either"):
            pn.mirror(PLANE, **light)
    bad = SimpleNamespace(**vars(PLANE))
    bad.poles = np.where(bad.poles == 1, NAN, bad.poles)
    refused("not_finite", lambda: pn.mirror(bad, direction=(0, 0, 1)))
    one = np.ones((1, 1))
    refused("developable", lambda: pn.pn_surface([[[0], [1]], one, one, one], one))
    refused("not_finite", lambda: pn.pn_surface([[[0, NAN]], one, one, one], one))
    refused("wrong_shape", lambda: pn.pn_surface([[1], one, one, one], one))
    u, v = [[0], [1]], [[0, 1]]
    flat = [u, v, [[0]]]
    assert "MOS" in refused("not_rational", lambda: pn.mos_envelope(flat, [[0, 0], [0, 0.5]]))
    refused("zero_length", lambda: pn.mos_envelope([u, u, u], v))
    refused("wrong_shape", lambda: pn.mos_envelope(flat, ([[1]], [[0]])))
