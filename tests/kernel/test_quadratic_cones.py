# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes of quadratic cones against their definition: F = 0 and dF/dt = 0 at one t."""

import numpy as np
import pnkernel as pn
import pytest
from numpy.polynomial import Polynomial
from test_errors import refused

LENGTH = 10


def opening_cones(growth):
    """Along the z-axis, x² / (1 + growth t) + y² / 2 = (z - LENGTH t)²."""
    vertex = np.array([[0, 0, 0, 1], [0, 0, LENGTH, 1]])
    directions = np.array([np.diag([2.0, 1, -2]), np.diag([2.0, 1 + growth, -2 * (1 + growth)])])
    return vertex, directions


def residual(growth, point):
    """|F| / |x|² at the root of dF/dt in [0, 1] where it is least."""
    x, y, z = point
    t = Polynomial([0, 1])
    m, height = 1 + growth * t, z - LENGTH * t
    f = 2 * x**2 + m * y**2 - 2 * m * height**2
    roots = f.deriv().roots()
    inside = [t.real for t in roots if abs(t.imag) < 1e-9 and -1e-9 < t.real < 1 + 1e-9]
    return min((abs(f(t)) for t in inside), default=np.inf) / (point @ point)


def samples(surface):
    count = len(surface.bsplines())
    t, v = np.meshgrid(np.linspace(0.01, count - 0.01, 4 * count), np.linspace(0.05, 0.95, 5))
    return surface.evaluate(t.ravel(), v.ravel())


def distance_of(surface, point):
    """Of a point near the inner part of the only face, by the method of Gauss and Newton."""
    step, place = 1e-6, np.array([0.5, 0.5])
    for _ in range(20):
        t, v = place[:, None] + step * np.array([[0, 1, -1, 0, 0], [0, 0, 0, 1, -1]])
        (here, *around), _ = surface.evaluate(t, v)
        tangents = np.transpose([around[0] - around[1], around[2] - around[3]]) / (2 * step)
        place = place + np.linalg.lstsq(tangents, point - here, rcond=None)[0]
        place = np.clip(place, step, 1 - step)
    return np.linalg.norm(here - point)


ARC = [[4, 2, 6], [6, 0, 6], [4, -2, 6]]


@pytest.mark.parametrize("growth", [1, 3])
def test_the_cones_touch_the_surface(growth):
    surface = pn.quadratic_cone_envelope(*opening_cones(growth), arc=ARC)
    points, normals = samples(surface)
    assert max(residual(growth, point) for point in points) < 1e-10
    assert np.allclose(np.linalg.norm(normals, axis=1), 1)
    assert surface.certificate.exact
    for face in surface.bsplines():
        assert np.all(face.weights > 0)


def test_matrices_give_the_same_surface():
    # (x - 10 t)² + y² = (1 + t)² z², with Bernstein coefficients of degree 4; and by vertex and M.
    vertex = [[0, 0, 0, 1], [LENGTH, 0, 0, 1]]
    opening = [6, 9, 13, 18, 24]  # of 6 (1 + t)²
    cones = np.zeros((5, 4, 4))
    directions = np.zeros((5, 3, 3))
    for k in range(5):
        cones[k, 0, 0] = cones[k, 1, 1] = directions[k, 0, 0] = directions[k, 1, 1] = 6
        cones[k, 2, 2] = directions[k, 2, 2] = -opening[k]
        cones[k, 0, 3] = cones[k, 3, 0] = -6 * LENGTH * k / 4
        cones[k, 3, 3] = 50 * k * (k - 1)
    # At t = 1/2 the contact is where 5 - x = 0.15 z².
    arc = [[1.25, 6.5, 5], [-10, 0, 10], [1.25, -6.5, 5]]
    surfaces = [
        pn.quadratic_cone_envelope(cones, arc=arc),
        pn.quadratic_cone_envelope(vertex, directions, arc=arc),
    ]
    first, second = (surface.evaluate([0.25, 0.75], [0.5, 0.5])[0] for surface in surfaces)
    assert np.allclose(first, second, rtol=1e-12)


def test_an_offset_is_refused():
    surface = pn.quadratic_cone_envelope(*opening_cones(1), arc=ARC)
    assert not surface.has_offsets
    refused("not_rational", lambda: surface.offset(1))


def test_bad_cones_are_refused():
    vertex, directions = opening_cones(1)

    def code(expected, *cones, **arc):
        refused(expected, lambda: pn.quadratic_cone_envelope(*cones, **arc))

    code("zero_length", vertex[:1], directions)
    code("developable", vertex, directions[:1])
    code("no_real_points", vertex, np.abs(directions))
    code("not_finite", vertex * np.nan, directions)
    code("not_finite", vertex, directions, arc=np.full((3, 3), np.nan))
    code("wrong_shape", vertex, directions, arc=ARC[:2])
    code("wrong_shape", np.eye(4)[None])
    code("singular_conics", np.diag([1.0, 1, 0, 0])[None])


def test_cones_of_revolution_agree_with_the_envelope_of_their_spheres():
    # Spheres a, r and b, s, linear in t: the cones have the vertices (r b - s a) / (r - s) and,
    # with the axis c = b - a, the directions (c.c - (s - r)²) d.d = (c.d)².
    a, b = np.array([[0, 0, 0], [0, 0, 20]]), np.array([[30, 0, -2], [30, 4, 22]])
    r, s = np.array([4, 5]), np.array([8, 7])
    line = (1, [0, 1], [2, 2])
    spheres = pn.cone_envelope(
        pn.Curve.bspline(*line, a),
        pn.Law.bspline(*line, r),
        pn.Curve.bspline(*line, b),
        pn.Law.bspline(*line, s),
    )

    def product(p, q):
        """Of linear polynomials, by Bernstein coefficients."""
        return np.array([p[0] * q[0], (p[0] * q[1] + p[1] * q[0]) / 2, p[1] * q[1]])

    c = b - a
    columns = [product(r, b[:, i]) - product(s, a[:, i]) for i in range(3)]
    weight = product(r - s, np.ones(2))
    square = sum(product(c[:, i], c[:, i]) for i in range(3)) - product(s - r, s - r)
    directions = np.array(
        [[square * (i == j) - product(c[:, i], c[:, j]) for j in range(3)] for i in range(3)]
    )
    points, _ = spheres.evaluate([0.5, 0.5, 0.5], [0.25, 0.5, 0.75])
    cones = pn.quadratic_cone_envelope(
        np.stack([*columns, weight], axis=-1), np.moveaxis(directions, -1, 0), arc=points
    )

    def linear(p):
        return Polynomial([p[0], p[1] - p[0]])

    centre, axis = [linear(a[:, i]) for i in range(3)], [linear(c[:, i]) for i in range(3)]
    radius, slope = linear(r), linear(s - r)
    axis_squared = sum(e * e for e in axis)

    def touching(x):
        """|F| at the root of dF/dt where it is least: F is the discriminant in v of the spheres
        |x - a - v c|² = (r + v (s - r))²."""
        arm = [x[i] - centre[i] for i in range(3)]
        along, arm_squared = sum(e * f for e, f in zip(arm, axis)), sum(e * e for e in arm)
        f = (arm_squared - radius**2) * (axis_squared - slope**2) - (along + radius * slope) ** 2
        roots = [t.real for t in f.deriv().roots() if abs(t.imag) < 1e-7 and -0.1 < t.real < 1.1]
        return min(abs(f(t)) for t in roots) / axis_squared(0) ** 2

    of_spheres, _ = spheres.evaluate([0.1, 0.4, 0.8], [0.2, 0.5, 0.9])
    of_cones, _ = samples(cones)
    assert max(touching(x) for x in [*of_spheres, *of_cones]) < 1e-11
    # The ends of the arc are met up to the rounding of their generators, so not they are compared.
    inside, _ = spheres.evaluate([0.2, 0.2, 0.5, 0.5, 0.8, 0.8], [0.3, 0.6, 0.3, 0.6, 0.3, 0.6])
    assert len(cones.bsplines()) == 1
    assert all(distance_of(cones, point) < 1e-12 for point in inside)
