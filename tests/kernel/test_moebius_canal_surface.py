# SPDX-License-Identifier: LGPL-2.1-or-later
"""Canal surfaces from squared radii against the equations of their spheres, at 60 digits."""

import mpmath
import numpy as np
import pnkernel as pn
import pytest
from conics import at
from mpmath import mpf
from splines import exactly, surface_point
from test_errors import refused

SPINE = [[0, 0, 0], [10, 5, 0], [20, -5, 5], [30, 0, 0]]
# What the rounding of poles leaves, in mm.
TIGHT = 1e-12


def samples(surface):
    for face in surface.bsplines():
        for u in np.linspace(face.u_knots[0], face.u_knots[-1], 5):
            for v in np.linspace(face.v_knots[0], face.v_knots[-1], 7):
                yield surface_point(face, u, v)


def derivative(coefficients):
    return (len(coefficients) - 1) * np.diff(np.asarray(coefficients, float), axis=0)


def from_envelope(x, spine, squared_radius):
    """How far x is from the spheres where (x - m).m' + (r^2)' / 2 = 0, the nearest of them."""
    slopes = derivative(spine), derivative(squared_radius)

    def plane(t):
        return (x - at(spine, t)) @ at(slopes[0], t) + at(slopes[1], t) / 2

    starts = np.linspace(-0.01, 1.01, 12)
    values = [plane(mpf(t)) for t in starts]
    roots = [
        mpmath.findroot(plane, (mpf(a), mpf(b)), solver="anderson")
        for a, b, p, q in zip(starts, starts[1:], values, values[1:])
        if p * q <= 0
    ]
    rays = [(x - at(spine, t), mpmath.sqrt(at(squared_radius, t))) for t in roots]
    return min(abs(mpmath.sqrt(ray @ ray) - radius) for ray, radius in rays)


@pytest.mark.parametrize("law", [[4, 5], [4, 7, 5], [4, 5, 6, 9], [4, 6, 9]])
def test_every_point_is_on_the_envelope_of_its_spheres(law):
    surface = pn.moebius_canal_surface(pn.Curve.bezier(SPINE), pn.Law.bezier(law))
    for x in samples(surface):
        assert from_envelope(x, SPINE, law) < TIGHT


@pytest.mark.parametrize("degree", [2, 3])
def test_spheres_that_are_small_against_their_spine(degree):
    """The conics turn far around then, and the double cones of their matrices are thin."""
    rng = np.random.default_rng(degree)
    spine = 1000 * (np.linspace([0, 0, 0], [1, 0, 0], degree + 1) + rng.random((degree + 1, 3)) / 4)
    law = 1 + rng.random(degree + 1) / 4
    surface = pn.moebius_canal_surface(pn.Curve.bezier(spine), pn.Law.bezier(law))
    for x in samples(surface):
        assert from_envelope(x, spine, law) < 1000 * TIGHT


def test_with_a_rational_radius_it_is_the_canal_surface_with_its_offsets():
    spine = pn.Curve.bezier(SPINE)
    surface = pn.moebius_canal_surface(spine, pn.Law.bezier([4, 6, 9]))
    same = pn.canal_surface(spine, pn.Law.bezier([2, 3]))
    assert surface.has_offsets
    for a, b in zip(surface.offset(0.5).bsplines(), same.offset(0.5).bsplines()):
        assert np.array_equal(a.poles, b.poles)
        assert np.array_equal(a.weights, b.weights)


def test_otherwise_offsets_are_refused():
    surface = pn.moebius_canal_surface(pn.Curve.bezier(SPINE), pn.Law.bezier([4, 5]))
    assert not surface.has_offsets
    refused("not_rational", lambda: surface.offset(0.5))


def test_circles_of_a_rational_radius_lie_on_the_canal_surface():
    """The circles alone, without the factorization, of the cone of m = (10 t, 0, 0), r = 2 + t."""
    frame = np.zeros((2, 4, 3))
    frame[:, 0, 0] = [-0.2, 9.7]  # 10 t - r r' / |m'|
    frame[:, 3, 0] = frame[:, 1, 1] = frame[:, 2, 2] = 1
    conic = np.zeros((3, 3, 3))
    conic[:, 1, 1] = conic[:, 2, 2] = 1
    conic[:, 0, 0] = -0.99 * np.array([4, 6, 9])
    for x in samples(pn.conic_surface(frame, conic)):
        assert from_envelope(x, [[0, 0, 0], [10, 0, 0]], [4, 6, 9]) < 1e-14
    spine = pn.Curve.bezier([[0, 0, 0], [10, 0, 0]])
    for x in samples(pn.canal_surface(spine, pn.Law.bezier([2, 3]))):
        assert from_envelope(x, [[0, 0, 0], [10, 0, 0]], [4, 6, 9]) < TIGHT


def sphere(x, y, z, square):
    """The point of P^4."""
    rest = x * x + y * y + z * z - square
    return [rest + 1, 2 * x, 2 * y, 2 * z, rest - 1]


def test_a_conic_in_p4_is_a_darboux_cyclide():
    curve = [sphere(0, 0, 0, 4), sphere(3, 1, 0, 12), sphere(6, 0, 0, 3)]
    for x in samples(pn.moebius_canal_surface(np.array(curve, float))):
        square = x @ x
        point = np.array([square + 1, *(2 * x), square - 1])
        a, b, c = exactly(curve) @ (point * [-1, 1, 1, 1, 1])
        # a (1 - t)^2 + 2 b t (1 - t) + c t^2 has a double root: degree four in x.
        assert abs(b * b - a * c) < 1e-11 * (b * b + abs(a * c) + square**2)


def test_what_has_no_envelope_is_refused():
    spine, surface = pn.Curve.bezier(SPINE), pn.moebius_canal_surface
    refused("negative_radius", lambda: surface(spine, pn.Law.bezier([4, -4])))
    refused("radius_too_steep", lambda: surface(spine, pn.Law.bezier([1, 900])))
    refused("not_finite", lambda: surface(np.full((3, 5), np.nan)))
    refused("wrong_shape", lambda: surface(np.zeros((3, 4))))
    refused("wrong_shape", lambda: surface(np.zeros((3, 5))))
