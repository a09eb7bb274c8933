# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids: their volumes against closed forms and Steiner's formula, and what ends them.

Between the distances d1 and d2 of a surface the wall along the normals has the volume

    V = [d A + d^2 / 2 B + d^3 / 3 C] from d1 to d2,    A, B, C the integrals of 1, div n, K,

which are found here from the definition of the surface, by Gauss's rule.
"""

import math
from typing import NamedTuple

import numpy as np
import pnkernel as pn
import pnocct
import pytest

BEND = np.array([[0, 0, 0], [15, 5, 0], [20, 15, 5], [20, 20, 0]], dtype=float)

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(80)


def gauss(low, high):
    """Nodes and weights between two limits."""
    return (high - low) / 2 * _NODES + (high + low) / 2, (high - low) / 2 * _WEIGHTS


def steiner(points, first, second, normal, hessian, weights, limits):
    """The volume from the unit normals' side, of F = 0 with gradient `normal` and its Hessian.

    `first` and `second` are derivatives of the points by the parameters of the weights.
    """
    area = np.linalg.norm(np.cross(first, second), axis=-1) * weights
    size = np.linalg.norm(normal, axis=-1)
    bent = np.einsum("...i,...ij,...j", normal, hessian, normal)
    divergence = (np.trace(hessian, axis1=-2, axis2=-1) * size**2 - bent) / size**3
    adjugate = np.stack(
        [np.cross(hessian[..., (i + 1) % 3, :], hessian[..., (i + 2) % 3, :]) for i in range(3)],
        axis=-2,
    )
    curvature = np.einsum("...i,...ij,...j", normal, adjugate, normal) / size**4
    coefficients = [np.sum(area), np.sum(area * divergence) / 2, np.sum(area * curvature) / 3]
    low, high = (sum(c * d ** (k + 1) for k, c in enumerate(coefficients)) for d in limits)
    return high - low


def wall(surface, limits):
    inner, outer = (surface.offset(d).bsplines() for d in limits)
    return pnocct.thick_solid(inner, outer)


def assert_volume(solid, exact, relative=1e-10):
    assert pnocct.check(solid, boolean=True) == []
    volume, error = pnocct.measured_volume(solid)
    assert volume == pytest.approx(exact, rel=relative)
    assert abs(volume - exact) <= error + relative * exact
    assert volume == pnocct.volume(solid)


def length(poles):
    t, weights = gauss(0, 1)
    legs = 3 * np.diff(poles, axis=0)
    speed = (
        np.outer((1 - t) ** 2, legs[0])
        + np.outer(2 * t * (1 - t), legs[1])
        + np.outer(t**2, legs[2])
    )
    return np.linalg.norm(speed, axis=1) @ weights


def capsule(radius, spine_length):
    return math.pi * radius**2 * spine_length + 4 / 3 * math.pi * radius**3


# Canal surfaces with flat and with spherical ends.


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
@pytest.mark.parametrize("radius", [0.5, 2])
def test_bent_capsule(lines, radius):
    """A pipe of constant radius has the volume of a straight one, wherever the spine turns."""
    pipe = pn.canal_surface(pn.Curve.bezier(BEND), pn.Law.constant(radius))
    spine_length = length(BEND)
    faces = pipe.bsplines(lines=lines)
    assert_volume(pnocct.domed_solid(faces), capsule(radius, spine_length), 1e-12)
    flat = pnocct.capped_solid(faces)
    assert_volume(flat, math.pi * radius**2 * spine_length, 1e-12)


@pytest.mark.parametrize("radii", [(2, 3), (3, 2), (1, 8), (0.5, 9.9)])
def test_cone_between_spheres(radii):
    """The convex hull of two balls."""
    (first, last), distance = radii, 10.0
    sine = (last - first) / distance
    cosine = math.sqrt(1 - sine**2)
    a, b = first * cosine, last * cosine
    height = distance - (last - first) * sine
    frustum = math.pi * height * (a**2 + a * b + b**2) / 3

    def segment(radius, height):
        return math.pi * height**2 * (3 * radius - height) / 3

    exact = frustum + segment(first, first * (1 - sine)) + segment(last, last * (1 + sine))
    cone = pn.canal_surface(pn.Curve.bezier([[0, 0, 0], [0, 0, distance]]), pn.Law.bezier(radii))
    solid = pnocct.domed_solid(cone.bsplines())
    assert_volume(solid, exact, 1e-12)
    assert pnocct.trim_deviation(solid) < 1e-13


def test_vessel():
    pipe = pn.canal_surface(pn.Curve.bezier(BEND), pn.Law.constant(2))
    solid = pnocct.domed_thick_solid(pipe.offset(-0.3).bsplines(), pipe.bsplines())
    spine_length = length(BEND)
    assert_volume(solid, capsule(2, spine_length) - capsule(1.7, spine_length), 1e-12)


def test_vessel_with_a_bore_of_another_law():
    spine = pn.Curve.bezier(BEND)
    outer = pn.canal_surface(spine, pn.Law.bezier([3, 2.5, 3]))
    bore = pn.canal_surface(spine, pn.Law.constant(1))
    solid = pnocct.domed_thick_solid(bore.bsplines(), outer.bsplines())
    inside = pnocct.volume(pnocct.domed_solid(outer.bsplines()))
    assert_volume(solid, inside - capsule(1, length(BEND)), 1e-12)


def test_domes_of_a_tapered_bend_follow_the_offset():
    """V(d) is a cubic, whose third derivative is that of a ball."""
    pipe = pn.canal_surface(pn.Curve.bezier(BEND), pn.Law.bezier([2, 1.8, 2, 2.5]))
    step = 0.2
    v0, v1, v2, v3, v4 = (
        pnocct.volume(pnocct.domed_solid(pipe.offset(step * i).bsplines())) for i in range(5)
    )
    third = (v3 - 3 * v2 + 3 * v1 - v0) / step**3
    assert third == pytest.approx(8 * math.pi, rel=1e-9)
    assert v4 - 4 * v3 + 6 * v2 - 4 * v1 + v0 == pytest.approx(0, abs=1e-11 * v4)


def test_no_dome_on_an_end_that_is_no_contact_circle():
    bowl = pn.quadric("ellipsoid", 20, 15, 10, {"z": (-10, 5)})
    with pytest.raises(ValueError, match="No sphere touches"):
        pnocct.domed_solid(bowl.bsplines())


@pytest.mark.parametrize("limits", [(0, 0.4), (-0.3, 0.2)])
def test_wall_of_a_bent_pipe(limits):
    pipe = pn.canal_surface(pn.Curve.bezier(BEND), pn.Law.constant(2))
    inner, outer = (2 + d for d in limits)
    assert_volume(wall(pipe, limits), math.pi * (outer**2 - inner**2) * length(BEND), 1e-12)


# Ruled surfaces.

RULED = {
    "bilinear": ([[0, 0, 0], [10, 0, 0]], [[0, 10, 0], [10, 10, 4]]),
    "blade": ([[0, 0, 0], [40, 25, 0], [90, 0, 0]], [[20, -20, 150], [50, 10, 150], [80, 40, 150]]),
    "cubic": (
        [[0, 0, 0], [10, 5, 0], [20, -5, 3], [30, 0, 0]],
        [[0, 15, 5], [12, 18, 0], [20, 20, 2], [33, 14, 6]],
    ),
}


def bezier(poles, t, derivative=0):
    poles = np.array(poles, dtype=float)
    for _ in range(derivative):
        poles = (len(poles) - 1) * np.diff(poles, axis=0)
    degree = len(poles) - 1
    basis = [math.comb(degree, i) * t**i * (1 - t) ** (degree - i) for i in range(degree + 1)]
    return sum(b[..., None] * pole for b, pole in zip(basis, poles)) if degree >= 0 else 0 * t


def ruled_volume(a, b, limits):
    """Steiner's formula by the fundamental forms."""
    (t, wt), (v, wv) = gauss(0, 1), gauss(0, 1)
    t, v = np.meshgrid(t, v, indexing="ij")
    weights = np.outer(wt, wv)
    v = v[..., None]
    along, across = (bezier(a, t, 1) * (1 - v) + bezier(b, t, 1) * v, bezier(b, t) - bezier(a, t))
    twice = bezier(a, t, 2) * (1 - v) + bezier(b, t, 2) * v if len(a) > 2 else np.zeros(across.shape)
    twist = bezier(b, t, 1) - bezier(a, t, 1)
    normal = np.cross(along, across)
    area = np.linalg.norm(normal, axis=-1)
    normal /= area[..., None]

    def dot(x, y):
        return np.sum(x * y, axis=-1)

    e, f, g = dot(along, along), dot(along, across), dot(across, across)
    l, m = dot(twice, normal), dot(twist, normal)
    determinant = e * g - f**2
    gaussian = -(m**2) / determinant
    divergence = -(g * l - 2 * f * m) / determinant
    coefficients = [
        np.sum(weights * area),
        np.sum(weights * area * divergence) / 2,
        np.sum(weights * area * gaussian) / 3,
    ]
    low, high = (sum(c * d ** (k + 1) for k, c in enumerate(coefficients)) for d in limits)
    return high - low


@pytest.mark.parametrize("limits", [(0, 1), (-0.5, 0.5), (0.25, 2)])
@pytest.mark.parametrize("name", RULED)
def test_wall_of_a_ruled_surface(name, limits):
    a, b = RULED[name]
    surface = pn.ruled_surface(pn.Curve.bezier(a), pn.Curve.bezier(b))
    solid = wall(surface, limits)
    assert_volume(solid, ruled_volume(a, b, limits))
    assert pnocct.trim_deviation(solid) < 1e-8


# Quadrics.


class Level(NamedTuple):
    """A region of F = 0, the points and derivatives on a grid with weights."""

    points: np.ndarray
    first: np.ndarray
    second: np.ndarray
    weights: np.ndarray


def around(a, b, profile):
    """The points (a rho cos, b rho sin, z) for (rho, z, rho', z') on a grid of the second one."""
    s, weights, rho, z, rho_s, z_s = profile
    angle = np.linspace(0, 2 * math.pi, 400, endpoint=False)
    cosine, sine = np.cos(angle)[:, None], np.sin(angle)[:, None]
    one = np.ones_like(cosine)
    points = np.stack([a * cosine * rho, b * sine * rho, one * z], axis=-1)
    first = np.stack([-a * sine * rho, b * cosine * rho, 0 * one * z], axis=-1)
    second = np.stack([a * cosine * rho_s, b * sine * rho_s, one * z_s], axis=-1)
    return Level(points, first, second, np.outer(np.full(400, 2 * math.pi / 400), weights))


def ellipsoid(a, b, c, low, high):
    s, w = gauss(math.asin(low / c), math.asin(high / c))
    return around(a, b, (s, w, np.cos(s), c * np.sin(s), -np.sin(s), c * np.cos(s)))


def one_sheet(a, b, c, low, high):
    s, w = gauss(math.asinh(low / c), math.asinh(high / c))
    return around(a, b, (s, w, np.cosh(s), c * np.sinh(s), np.sinh(s), c * np.cosh(s)))


def two_sheet(a, b, c, low, high):
    s, w = gauss(0, math.acosh(high / c))
    return around(a, b, (s, w, np.sinh(s), c * np.cosh(s), np.cosh(s), c * np.sinh(s)))


def paraboloid(a, b, c, low, high):
    s, w = gauss(0, math.sqrt(high / c))
    return around(a, b, (s, w, s, c * s**2, np.ones_like(s), 2 * c * s))


def cylinder(a, b, c, low, high):
    s, w = gauss(low, high)
    return around(a, b, (s, w, np.ones_like(s), s, 0 * s, np.ones_like(s)))


def cone(a, b, c, low, high):
    s, w = gauss(low, high)
    return around(a, b, (s, w, s / c, s, np.full_like(s, 1 / c), np.ones_like(s)))


def graph(x_square, y_square):
    def region(a, b, c, x_limits, y_limits):
        (x, wx), (y, wy) = gauss(*x_limits), gauss(*y_limits)
        x, y = np.meshgrid(x, y, indexing="ij")
        p, q = x_square * c / a**2, y_square * c / b**2
        one, zero = np.ones_like(x), np.zeros_like(x)
        return Level(
            np.stack([x, y, p * x**2 + q * y**2], axis=-1),
            np.stack([one, zero, 2 * p * x], axis=-1),
            np.stack([zero, one, 2 * q * y], axis=-1),
            np.outer(wx, wy),
        )

    return region


class Case(NamedTuple):
    """A kind of quadric: half-axes, bounds, its points, and F up to a sign: its diagonal, and the
    coefficient of z alone."""

    kind: str
    axes: tuple
    bounds: dict
    level: Level
    diagonal: tuple
    linear: float


def _cases():
    a, b, c = 20.0, 15.0, 10.0
    x, y, z = 2 / a**2, 2 / b**2, 2 / c**2
    rectangle = {"x": (-10, 12), "y": (-8, 9)}
    plane = rectangle["x"], rectangle["y"]
    return [
        Case("ellipsoid", (a, b, c), {}, ellipsoid(a, b, c, -c, c), (x, y, z), 0),
        Case("ellipsoid", (a, b, c), {"z": (-5, 6)}, ellipsoid(a, b, c, -5, 6), (x, y, z), 0),
        Case(
            "one_sheet_hyperboloid",
            (a, b, c),
            {"z": (-10, 12)},
            one_sheet(a, b, c, -10, 12),
            (x, y, -z),
            0,
        ),
        Case(
            "two_sheet_hyperboloid",
            (a, b, c),
            {"z": (0, 20)},
            two_sheet(a, b, c, 0, 20),
            (x, y, -z),
            0,
        ),
        Case(
            "elliptic_paraboloid",
            (a, b, c),
            {"z": (0, 10)},
            paraboloid(a, b, c, 0, 10),
            (c * x, c * y, 0),
            -1,
        ),
        Case(
            "hyperbolic_paraboloid",
            (a, b, c),
            rectangle,
            graph(1, -1)(a, b, c, *plane),
            (-c * x, c * y, 0),
            1,
        ),
        Case(
            "parabolic_cylinder", (a, b, c), rectangle, graph(1, 0)(a, b, c, *plane), (c * x, 0, 0), -1
        ),
        Case(
            "elliptic_cylinder", (a, a, c), {"z": (-10, 12)}, cylinder(a, a, c, -10, 12), (x, x, 0), 0
        ),
        Case("elliptic_cone", (a, a, c), {"z": (2, 12)}, cone(a, a, c, 2, 12), (x, x, -z), 0),
    ]


@pytest.mark.parametrize("limits", [(0, 1), (-0.5, 0.75)])
@pytest.mark.parametrize("case", _cases(), ids=lambda case: f"{case.kind}{case.bounds}")
def test_wall_of_a_quadric(case, limits):
    surface = pn.quadric(case.kind, *case.axes, case.bounds)
    normal = case.level.points * np.array(case.diagonal) + np.array([0, 0, case.linear])
    hessian = np.broadcast_to(np.diag(case.diagonal), (*normal.shape, 3))
    exact = steiner(*case.level[:3], normal, hessian, case.level.weights, limits)
    assert_volume(wall(surface, limits), exact)


def test_two_parts_are_two_solids():
    """Above and below a rectangle an ellipsoid has two parts that mirror each other."""
    surface = pn.quadric("ellipsoid", 20, 15, 10, {"x": (-6, 10), "y": (-6, 6)})
    solid = wall(surface, (0, 1))
    assert pnocct.check(solid, boolean=True) == []
    x, wx = gauss(-6, 10)
    y, wy = gauss(-6, 6)
    x, y = np.meshgrid(x, y, indexing="ij")
    z = 10 * np.sqrt(1 - x**2 / 400 - y**2 / 225)
    one, zero = np.ones_like(x), np.zeros_like(x)
    diagonal = np.array([2 / 400, 2 / 225, 2 / 100])
    points = np.stack([x, y, z], axis=-1)
    exact = steiner(
        points,
        np.stack([one, zero, -x / 4 / z], axis=-1),
        np.stack([zero, one, -y * 100 / 225 / z], axis=-1),
        points * diagonal,
        np.broadcast_to(np.diag(diagonal), (*points.shape, 3)),
        np.outer(wx, wy),
        (0, 1),
    )
    assert pnocct.volume(solid) == pytest.approx(2 * exact, rel=1e-10)


def test_open_surfaces_that_differ_have_no_wall():
    pipe = pn.canal_surface(pn.Curve.bezier(BEND), pn.Law.constant(1))
    thin, wide = pipe.bsplines(), pipe.offset(1).bsplines(lines="lowest_degree")
    with pytest.raises(ValueError, match="do not correspond"):
        pnocct.thick_solid(thin, wide)
