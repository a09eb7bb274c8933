# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces of moving ellipses against their equation."""

import numpy as np
import pnkernel as pn
import pytest
from splines import surface_point
from test_errors import refused

TIGHT = 1e-10  # what evaluation in doubles leaves of an equation of size 1


def bernstein_value(coefficients, t):
    """Value at t of polynomials by their Bernstein coefficients (k + 1, ...), by de Casteljau."""
    rows = list(np.asarray(coefficients, dtype=float))
    while len(rows) > 1:
        rows = [(1 - t) * a + t * b for a, b in zip(rows, rows[1:])]
    return rows[0]


def upright_frame(length):
    """Planes z = length t with the coordinates (1, x, y)."""
    frame = np.zeros((2, 4, 3))
    frame[:, 0, 1] = frame[:, 1, 2] = frame[:, 3, 0] = 1
    frame[1, 2, 0] = length
    return frame


def random_ellipses(random, degree):
    """Symmetric matrices whose Bernstein coefficients are circles, moved and turned a little."""
    conic = np.zeros((degree + 1, 3, 3))
    for matrix in conic:
        turned = np.eye(3) + 0.25 * random.integers(-1, 2, (3, 3))
        matrix[:] = turned.T @ np.diag([-4.0, 1.0, 1.0]) @ turned
    return conic


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("degree", [0, 1, 2, 4])
def test_every_point_satisfies_the_equation(seed, degree):
    conic = random_ellipses(np.random.default_rng(seed), degree)
    surface = pn.conic_surface(upright_frame(10), conic)
    assert surface.deviation < 1e-11
    for face in surface.bsplines():
        assert np.all(face.weights > 0)
        for u in np.linspace(face.u_knots[0], face.u_knots[-1], 5):
            for v in np.linspace(0, 1, 13):
                x, y, z = np.array(surface_point(face, u, v), dtype=float)
                matrix = bernstein_value(conic, z / 10)
                place = np.array([1, x, y])
                size = np.abs(place) @ np.abs(matrix) @ np.abs(place)
                assert abs(place @ matrix @ place) < TIGHT * size


def test_the_ends_are_the_first_and_last_conic_and_the_face_closes():
    conic = random_ellipses(np.random.default_rng(1), 2)
    faces = pn.conic_surface(upright_frame(10), conic).bsplines()
    for v in np.linspace(0, 1, 9):
        assert float(surface_point(faces[0], 0, v)[2]) == pytest.approx(0, abs=1e-12)
        assert float(surface_point(faces[-1], 1, v)[2]) == pytest.approx(10, abs=1e-12)
    for face in faces:
        assert np.array_equal(face.poles[:, 0], face.poles[:, -1])
        assert np.array_equal(face.weights[:, 0], face.weights[:, -1])


def test_a_moving_circle_is_the_canal_surface_of_its_spheres():
    # A torus: circles of radius 1 in the planes through z, centres at distance 3.
    # (cos, sin) = ((1 - t^2), 2 t) / (1 + t^2), Bernstein coefficients over [0, 1].
    cos, sin, one = np.array([1, 1, 0]), np.array([0, 1, 2]), np.array([1, 1, 2])
    frame = np.zeros((3, 4, 3))
    frame[:, 0, 0], frame[:, 1, 0], frame[:, 3, 0] = 3 * cos, 3 * sin, one
    frame[:, 0, 1], frame[:, 1, 1] = cos, sin
    frame[:, 2, 2] = one
    surface = pn.conic_surface(frame, np.diag([-1.0, 1, 1])[None])
    (face,) = surface.bsplines()
    assert surface.degree == (2, 2)
    for u in np.linspace(0, 1, 7):
        for v in np.linspace(0, 1, 9):
            x, y, z = np.array(surface_point(face, u, v), dtype=float)
            assert (np.hypot(x, y) - 3) ** 2 + z**2 == pytest.approx(1, abs=1e-12)


def test_tangent_planes_give_the_same_surface_as_the_conic():
    # Circles of radius 2 in the planes z = t: e^T D e = 4 (e1^2 + e2^2) - (e3 t + e4)^2.
    d = np.zeros((3, 4, 4))
    d[:, 0, 0] = d[:, 1, 1] = 4
    d[:, 3, 3] = -1
    d[:, 2, 3] = d[:, 3, 2] = 0, -0.5, -1
    d[2, 2, 2] = -1
    surface = pn.conic_surface_of_tangent_planes(d)
    assert surface.degree == (1, 2)
    for face in surface.bsplines():
        for v in np.linspace(0, 1, 9):
            x, y, z = np.array(surface_point(face, 0.5, v), dtype=float)
            assert (np.hypot(x, y), z) == pytest.approx((2, 0.5), abs=1e-12)


def test_refusals_say_why():
    frame = upright_frame(1)
    circle = np.diag([-1.0, 1, 1])
    refused("wrong_shape", lambda: pn.conic_surface(frame[:, :3], circle[None]))
    refused("wrong_shape", lambda: pn.conic_surface(frame, circle))
    refused("wrong_shape", lambda: pn.conic_surface(frame, (circle + np.eye(3, k=1))[None]))
    refused("not_finite", lambda: pn.conic_surface(frame, circle[None] * np.nan))
    refused("wrong_shape", lambda: pn.conic_surface_of_tangent_planes(np.eye(4)[None]))
    refused("singular_conics", lambda: pn.conic_surface(frame, np.diag([0.0, 1, 1])[None]))
    refused("no_real_points", lambda: pn.conic_surface(frame, np.array([circle, np.eye(3)])))
    refused("region_unbounded", lambda: pn.conic_surface(frame, np.diag([-1.0, 1, -1])[None]))
    refused("not_rational", lambda: pn.conic_surface(frame, circle[None]).offset(1))
