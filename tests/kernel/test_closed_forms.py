# SPDX-License-Identifier: LGPL-2.1-or-later
"""Canal surfaces with an equation of their own: every exported point satisfies it to a few ulps."""

import mpmath
import numpy as np
import pnkernel as pn
import pytest
from canal import face_parameters
from mpmath import mpf
from splines import Spline, exactly, norm, surface_point

QUARTER = np.array([[1.0, 0, 0], [1, 1, 0], [0, 1, 0]])
QUARTER_TURN = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
# (1 - t^2, 2 t) / (1 + t^2) and its mirror image in turn: the same weight on both sides of a joint.
EXACT_WEIGHTS = [[1, 1, 2], [2, 1, 1]]
OFFSETS = (0.0, 0.75, -0.5)


def quarters(count):
    return [QUARTER @ np.linalg.matrix_power(QUARTER_TURN.T, i) for i in range(count)]


def circle(radius, count=4):
    """An exact circular arc of so many quarters."""
    return Spline.joined(
        [radius * quarter for quarter in quarters(count)], [EXACT_WEIGHTS[i % 2] for i in range(count)]
    )


def curve(spline):
    return pn.Curve.bspline(*spline.arguments)


def law(spline):
    return pn.Law.bspline(*spline.arguments)


def points(faces, count=25):
    random = np.random.default_rng(0)
    return [
        surface_point(face, u, v) for face in faces for u, v in face_parameters(face, random, count)
    ]


def assert_equation(surface, distance_to):
    """distance_to(point, d) is the signed distance to the surface at distance d."""
    for offset in OFFSETS:
        moved = surface.offset(offset)
        faces = moved.bsplines()
        few_ulps = 4 * np.spacing(max(np.abs(face.poles).max() for face in faces))
        for point in points(faces):
            error = abs(distance_to(point, mpf(offset)))
            assert error <= few_ulps
            assert error <= moved.certificate.deviation


@pytest.mark.parametrize("poles", [[0.0, 7.0], [0.0, 1.0, 7.0], [-0.3, 0.1, 0.2, 7.0]])
def test_cylinder_at_any_speed(poles):
    spine = pn.Curve.bezier([[0, 0, z] for z in poles])
    surface = pn.canal_surface(spine, pn.Law.constant(2))
    assert_equation(surface, lambda x, d: mpmath.hypot(x[0], x[1]) - 2 - d)
    assert list(surface.degree) == [len(poles) - 1, 2]
    assert surface.regular_range[1] == np.inf


def test_slanted_cylinder():
    axis = np.array([1.0, 2, 2]) / 3  # of unit length only up to rounding
    ends = np.array([[1.0, 0, -1], [1, 0, -1] + 9 * axis])
    surface = pn.canal_surface(pn.Curve.bezier(ends), pn.Law.constant(1.5))

    def distance_to(x, d):
        direction = exactly(ends[1]) - exactly(ends[0])
        return norm(np.cross(x - exactly(ends[0]), direction)) / norm(direction) - mpf(1.5) - d

    assert_equation(surface, distance_to)


def test_cone():
    # r = 2 + z / 4: the half angle has sine 1/4, and the tangent plane of z = 0 has support 2.
    spine, radius = pn.Curve.bezier([[0, 0, 0], [0, 0, 8]]), pn.Law.bezier([2, 4])
    surface = pn.canal_surface(spine, radius)
    sine = mpf(1) / 4
    cosine = mpmath.sqrt(1 - sine**2)
    assert_equation(surface, lambda x, d: mpmath.hypot(x[0], x[1]) * cosine - x[2] * sine - 2 - d)
    assert list(surface.degree) == [1, 2]
    assert surface.regular_range[0] == pytest.approx(-2, abs=1e-6)


@pytest.mark.parametrize("count", [1, 2, 4])
def test_torus(count):
    surface = pn.canal_surface(curve(circle(5, count)), pn.Law.constant(2))
    assert_equation(surface, lambda x, d: mpmath.hypot(mpmath.hypot(x[0], x[1]) - 5, x[2]) - 2 - d)
    assert list(surface.degree) == [4, 2]
    faces = surface.bsplines()
    assert np.array_equal(faces[0].poles[0], faces[-1].poles[-1]) == (count == 4)
    lower, upper = surface.regular_range
    assert -2 <= lower <= -2 + 1e-6
    assert 3 - 1e-6 <= upper <= 3


def test_torus_of_a_nurbs_circle():
    # The weight sqrt(1/2) of the usual NURBS circle is rounded, and so the circle is one to an ulp.
    spine = Spline.joined([5 * quarter for quarter in quarters(4)], [[1, np.sqrt(0.5), 1]] * 4)
    surface = pn.canal_surface(curve(spine), pn.Law.constant(2))
    assert surface.certificate.exact
    faces = surface.bsplines()
    for x in points(faces):
        assert abs(mpmath.hypot(mpmath.hypot(x[0], x[1]) - 5, x[2]) - 2) <= 8 * np.spacing(7.0)
    assert np.array_equal(faces[0].poles[0], faces[-1].poles[-1])


def test_dupin_cyclide():
    # The spheres about (a cos, b sin, 0) of radius m - c cos, with c^2 = a^2 - b^2, envelop
    # (x.x - m^2 + b^2)^2 = 4 (a x - c m)^2 + 4 b^2 y^2; offsets only change m.
    a, b, c, m = 5.0, 4.0, 3.0, 4.0
    unit = circle(1)
    spine = Spline(2, unit.knots, unit.multiplicities, unit.poles * [a, b, 1], unit.weights)
    radius = Spline(2, unit.knots, unit.multiplicities, m - c * unit.poles[:, 0], unit.weights)
    surface = pn.canal_surface(curve(spine), law(radius))

    def distance_to(x, d):
        size = m + d
        sphere, plane = x @ x - size**2 + b**2, a * x[0] - c * size
        value = sphere**2 - 4 * plane**2 - 4 * b**2 * x[1] ** 2
        gradient = 4 * sphere * x - np.array([8 * a * plane, 8 * b**2 * x[1], mpf(0)])
        return value / norm(gradient)

    assert_equation(surface, distance_to)
    assert list(surface.degree) == [4, 2]


def zone_faces(surface, spans):
    faces = surface.bsplines()
    assert len(faces) == spans + 1
    return faces


def test_sphere_zone_at_a_kink_of_the_radius():
    spine = Spline.joined([[[0, 0, 0], [0, 0, 4]], [[0, 0, 4], [0, 0, 8]]])
    radius = Spline.joined([[2, 3], [3, 2.5]])
    surface = pn.canal_surface(curve(spine), law(radius))
    before, zone, after = zone_faces(surface, 2)
    centre = exactly([0, 0, 4])
    for x in points([zone]):
        assert abs(norm(x - centre) - 3) <= 4 * np.spacing(4.0)
        # n.m' + r' = 0 gives the heights of the circles where the cones end and begin.
        assert 4 - 3 / 4 - 1e-14 <= x[2] <= 4 + 3 / 8 + 1e-14
    assert np.array_equal(before.poles[-1], zone.poles[0])
    assert np.array_equal(zone.poles[-1], after.poles[0])


def test_sphere_zone_at_a_corner_of_the_spine():
    corner = [0, 0, 8]
    spine = Spline.joined([[[0, 0, 0], corner], [corner, [8, 0, 8]]])
    surface = pn.canal_surface(curve(spine), pn.Law.constant(1))
    before, zone, after = zone_faces(surface, 2)
    for x in points([zone]):
        assert abs(norm(x - exactly(corner)) - 1) <= 4 * np.spacing(8.0)
    assert np.array_equal(before.poles[-1], zone.poles[0])
    assert np.array_equal(zone.poles[-1], after.poles[0])
