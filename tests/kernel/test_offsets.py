# SPDX-License-Identifier: LGPL-2.1-or-later
"""Offsets are sections of one hypersurface; regular_range says where they are not singular."""

import numpy as np
import pnkernel as pn
import pytest
from canal import random_canal
from splines import Spline

TIGHTNESS = 1e-6  # mm, promised of the inner bounds


def all_bits(surface, lines="even"):
    return [
        (face.poles.tobytes(), face.weights.tobytes(), face.u_knots.tobytes())
        for face in surface.bsplines(lines)
    ]


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
def test_offset_of_an_offset_is_an_offset_bit_for_bit(lines):
    random = np.random.default_rng(0)
    surface = random_canal(0, 3, spans=2).surface()
    for d, e in random.uniform(-1, 1, (5, 2)):
        twice = surface.offset(d).offset(e)
        assert twice.distance == d + e
        assert all_bits(twice, lines) == all_bits(surface.offset(d + e), lines)
    assert all_bits(surface.offset(0.5).offset(-0.5), lines) == all_bits(surface, lines)


def test_offset_does_not_depend_on_what_was_asked_before():
    canal = random_canal(1, 3)
    used = canal.surface()
    for d in (2.0, -1.0, 1e3):
        used.offset(d).bsplines()
    assert all_bits(used.offset(0.1)) == all_bits(canal.surface().offset(0.1))


@pytest.mark.parametrize("rational", [False, True])
def test_poles_are_linear_in_the_distance(rational):
    surface = random_canal(2, 3, spans=2, rational=rational).surface()
    base, once, twice = (surface.offset(d).bsplines() for d in (0.0, 0.5, 1.0))
    for a, b, c in zip(base, once, twice, strict=True):
        assert np.array_equal(a.weights, b.weights) and np.array_equal(a.weights, c.weights)
        few_ulps = 4 * np.spacing(np.abs(a.poles).max())
        assert np.abs(a.poles - 2 * b.poles + c.poles).max() <= few_ulps
        assert np.abs(c.poles - a.poles).max() > 0.5


def test_points_move_along_their_normals():
    canal = random_canal(3, 4)
    surface = canal.surface()
    begin, end = canal.spine.knots
    random = np.random.default_rng(0)
    t, u = random.uniform(begin, end, 50), random.uniform(0, 4, 50)
    points, normals = surface.evaluate(t, u)
    for d in (0.5, -1.0, 20.0):
        moved, same = surface.offset(d).evaluate(t, u)
        np.testing.assert_array_equal(same, normals)
        np.testing.assert_allclose(moved, points + d * normals, rtol=0, atol=1e-13)


def focal_distances(canal, span, t, angle):
    """The distances at which offsets are singular at the normals of these parameters and angles.

    The offset x = m + (r + d) n has x_t = m' + r' n + (r + d) n_t and x_angle = (r + d) n_angle: it
    is singular where det(x_t, n_angle, n) = 0, which is linear in d. The derivatives are taken by a
    complex step, exact to rounding.
    """
    step = 1e-30
    components = [np.array(c, dtype=float) for c in canal.spine.span_polynomials[span]]
    law = [np.array(c, dtype=float) for c in canal.radius.span_polynomials[span]]
    polyval, polyder = np.polynomial.polynomial.polyval, np.polynomial.polynomial.polyder

    def jet(numerators, denominator, at):
        q, q1 = polyval(at, denominator), polyval(at, polyder(denominator))
        p = np.array([polyval(at, c) for c in numerators])
        p1 = np.array([polyval(at, polyder(c)) for c in numerators])
        return p / q, (p1 - p / q * q1) / q

    def dot(a, b):
        return np.sum(a * b, axis=0)

    def cross(a, b):
        return np.cross(a, b, axis=0)

    def normal(at, around):
        _, m1 = jet(components[:3], components[3], at)
        _, (r1,) = jet(law[:1], law[1], at)
        length = np.sqrt(dot(m1, m1))
        axis = m1 / length
        side = cross(np.array([0.36, 0.48, 0.8])[:, None] * np.ones_like(axis), axis)
        side = side / np.sqrt(dot(side, side))
        cosine = -r1 / length
        turn = np.cos(around) * side + np.sin(around) * cross(axis, side)
        return cosine * axis + np.sqrt(1 - cosine**2) * turn

    (r,), (r1,) = jet(law[:1], law[1], t)
    _, m1 = jet(components[:3], components[3], t)
    n = normal(t + 0j, angle + 0j).real
    n_t = normal(t + 1j * step, angle + 0j).imag / step
    n_angle = normal(t + 0j, angle + 1j * step).imag / step
    plane = cross(n_angle, n)
    with np.errstate(divide="ignore"):
        reach = -dot(m1 + r1 * n, plane) / dot(n_t, plane)
    return np.where(reach > 0, reach, np.inf) - r


def scanned_range(canal):
    """The offsets without a singular point, from ever finer grids around the worst place."""
    least, radii = np.inf, []
    for span, (begin, end) in enumerate(zip(canal.spine.knots, canal.spine.knots[1:])):
        t, angle = np.linspace(begin, end, 401), np.linspace(0, 2 * np.pi, 181)
        radii.append(min(float(canal.radius.derivatives(value, span)[0][0]) for value in t))
        for _ in range(8):
            grid = [g.ravel() for g in np.meshgrid(t, angle)]
            distances = focal_distances(canal, span, *grid)
            worst = np.argmin(distances)
            least = min(least, distances[worst])
            t, angle = (
                np.linspace(centre - 2 * h, centre + 2 * h, 21)
                for centre, h in ((grid[0][worst], t[1] - t[0]), (grid[1][worst], angle[1] - angle[0]))
            )
            t = np.clip(t, begin, end)
    return -min(radii), least


@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("degree", [2, 3, 4, 5])
@pytest.mark.parametrize("spans", [1, 3])
def test_regular_range_is_inside_and_tight(degree, spans, rational):
    canal = random_canal(5, degree, spans, rational)
    lower, upper = canal.surface().regular_range
    first, last = scanned_range(canal)
    assert first - 1e-9 <= lower
    assert upper <= last + 1e-9 * max(1.0, abs(last))
    assert last - upper <= TIGHTNESS * max(1.0, abs(last))
    # The scan of radii is only as fine as its grid, so its minimum is approached from above.
    assert lower - first <= 1e-3


def test_regular_range_of_a_straight_spine():
    # r = 2 - t + 2 t^2 about m = (0, 0, 4 t): r'' = 4, D = 16 - r'^2, singular at d = D / r'' - r.
    surface = pn.canal_surface(pn.Curve.bezier([[0, 0, 0], [0, 0, 4]]), pn.Law.bezier([2, 1.5, 3]))
    t = np.linspace(0, 1, 100001)
    radius, slope = 2 - t + 2 * t**2, 4 * t - 1
    lower, upper = surface.regular_range
    assert -radius.min() <= lower + 1e-9 <= -radius.min() + TIGHTNESS
    focal = ((16 - slope**2) / 4 - radius).min()
    assert focal - TIGHTNESS <= upper <= focal + 1e-9


def test_regular_range_is_counted_from_distance_zero():
    surface = random_canal(1, 3).surface()
    assert surface.offset(0.75).regular_range == surface.regular_range


def test_no_regular_offset():
    # The spine's curvature radius falls to 1/4 where the sphere's radius is 2.
    surface = pn.canal_surface(
        pn.Curve.bezier([[-1, 2, 0], [0, -2, 0], [1, 2, 0]]), pn.Law.constant(2)
    )
    lower, upper = surface.regular_range
    assert upper == pytest.approx(1 / 4 - 2, abs=TIGHTNESS)
    assert lower == pytest.approx(-2, abs=TIGHTNESS)


def test_spine_of_zero_radius_has_only_positive_offsets():
    spine = Spline.bezier([[0, 0, 0], [5, 0, 1], [9, 3, 0]])
    surface = pn.canal_surface(pn.Curve.bspline(*spine.arguments), pn.Law.constant(0))
    lower, upper = surface.regular_range
    assert 0 <= lower <= TIGHTNESS < upper
    points, normals = surface.offset(1).evaluate([0.5], [1.0])
    centre = np.array(spine.derivatives(0.5, 0)[0], dtype=float)
    np.testing.assert_allclose(points, centre + normals, rtol=0, atol=1e-14)
