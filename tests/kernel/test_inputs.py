# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves, laws and the small print of the interface."""

from dataclasses import replace

import numpy as np
import pnkernel as pn
import pytest
from canal import face_parameters, random_canal
from splines import surface_point

LINE = [[0, 0, 0], [0, 0, 5]]


def test_curve_domain_breaks_and_degree():
    poles = [[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 0, 1]]
    curve = pn.Curve.bspline(2, [-1, 0.5, 3], [3, 1, 3], poles)
    assert curve.domain == (-1, 3)
    np.testing.assert_array_equal(curve.breaks, [-1, 0.5, 3])
    assert curve.degree == 2
    assert pn.Curve.bezier(LINE).domain == (0, 1)


def test_degree_is_that_of_the_data():
    # A straight line written as a cubic is of degree 1, at even speed.
    assert pn.Curve.bezier([[0, 0, 0], [0, 0, 1], [0, 0, 2], [0, 0, 3]]).degree == 1
    raised = pn.canal_surface(
        pn.Curve.bezier([[0, 0, 0], [0, 0, 1], [0, 0, 2], [0, 0, 3]]), pn.Law.bezier([1, 1.5, 2])
    )
    plain = pn.canal_surface(pn.Curve.bezier([[0, 0, 0], [0, 0, 3]]), pn.Law.bezier([1, 2]))
    assert list(raised.degree) == list(plain.degree) == [1, 2]


def test_chain_runs_on_by_the_lengths_of_the_domains():
    first = pn.Curve.bspline(1, [2, 5], [2, 2], LINE)
    second = pn.Curve.bspline(1, [-1, 1, 2], [2, 1, 2], [[0, 0, 5], [0, 3, 5], [4, 3, 5]])
    chain = pn.Curve.chain([first, second])
    assert chain.domain == (2, 8)
    np.testing.assert_array_equal(chain.breaks, [2, 5, 7, 8])


def test_a_chain_is_its_spans():
    poles = np.array([[0, 0, 0], [1, 0, 3], [2, 2, 5], [1, 4, 8.0]])
    whole = pn.canal_surface(pn.Curve.bezier(poles), pn.Law.constant(0.5))
    left, right = halves(poles)
    parts = pn.canal_surface(
        pn.Curve.chain([pn.Curve.bezier(left), pn.Curve.bezier(right)]), pn.Law.constant(0.5)
    )
    t = np.linspace(0, 1, 9)
    points, normals = parts.evaluate(2 * t, np.full(9, 1.0))
    assert list(parts.degree) == list(whole.degree)
    for parameter, point, normal in zip(t, points, normals, strict=True):
        centre = point - 0.5 * normal
        np.testing.assert_allclose(centre, bezier_point(poles, parameter), rtol=0, atol=1e-14)


def halves(poles):
    """De Casteljau at 1/2; exact for these poles."""
    left, right = [poles[0]], [poles[-1]]
    while len(poles) > 1:
        poles = (poles[:-1] + poles[1:]) / 2
        left.append(poles[0])
        right.insert(0, poles[-1])
    return np.array(left), np.array(right)


def bezier_point(poles, t):
    while len(poles) > 1:
        poles = (1 - t) * poles[:-1] + t * poles[1:]
    return poles[0]


def test_equal_weights_change_nothing():
    plain = random_canal(2, 3)
    weighted = replace(
        plain,
        spine=replace(plain.spine, weights=2 * plain.spine.weights),
        radius=replace(plain.radius, weights=3 * plain.radius.weights),
    )
    surface = weighted.surface()
    assert list(surface.degree) == list(plain.surface().degree) == [5, 2]
    (face,) = surface.bsplines()
    for u, v in face_parameters(face, np.random.default_rng(0), 6):
        point = surface_point(face, u, v)
        assert plain.distance(point, 0, u, 0) <= surface.certificate.deviation


def test_degrees_are_tuples():
    surface = random_canal(0, 2).surface()
    assert isinstance(surface.degree, tuple)
    assert isinstance(surface.certificate.bidegree, tuple)


def test_evaluate_takes_lists_and_returns_pairs_of_rows():
    surface = random_canal(0, 2).surface()
    points, normals = surface.evaluate([0.0, 0.1], [0, 4])
    assert points.shape == normals.shape == (2, 3)
    assert points.dtype == normals.dtype == np.float64
    points, normals = surface.evaluate([], [])
    assert points.shape == normals.shape == (0, 3)


def test_distance_and_offset():
    surface = random_canal(0, 2).surface()
    assert surface.distance == 0
    assert surface.offset(1.5).distance == 1.5
    assert surface.distance == 0


def test_every_name_of_the_interface_is_documented():
    for thing in (
        pn,
        pn.Curve,
        pn.Law,
        pn.PNSurface,
        pn.BSplineSurface,
        pn.Certificate,
        pn.GeometryError,
        pn.canal_surface,
        pn.Curve.bezier,
        pn.Curve.bspline,
        pn.Curve.chain,
        pn.Law.constant,
        pn.Law.bezier,
        pn.Law.bspline,
        pn.PNSurface.offset,
        pn.PNSurface.evaluate,
        pn.PNSurface.bsplines,
        pn.PNSurface.regular_range,
    ):
        assert thing.__doc__ and thing.__doc__.strip()


def test_example_of_the_interface():
    spine = pn.Curve.bezier([[0, 0, 0], [10, 0, 0], [20, 10, 5], [30, 10, 20]])
    surface = pn.canal_surface(spine, pn.Law.bezier([2, 3, 1.5, 2]))
    wall = surface.offset(0.25)
    lower, upper = wall.regular_range
    assert lower < wall.distance < upper
    (face,) = wall.bsplines(lines="even")
    assert face.poles.shape[2] == 3
    assert wall.certificate.exact
    with pytest.raises(pn.GeometryError, match="faster"):
        pn.canal_surface(spine, pn.Law.bezier([2, 60]))


def bernstein(coefficients, s):
    """de Casteljau's algorithm."""
    rows = list(np.asarray(coefficients))
    while len(rows) > 1:
        rows = [(1 - s) * a + s * b for a, b in zip(rows, rows[1:])]
    return rows[0]


def test_spans_of_a_curve_are_the_curve():
    radius, weight = 5.0, np.sqrt(0.5)
    arc = pn.Curve.bspline(
        2,
        [1, 3, 4],
        [3, 2, 3],
        radius * np.array([[1, 0, 0], [1, 1, 0], [0, 1, 0], [-1, 1, 0], [-1, 0, 0]]),
        [1, weight, 1, weight, 1],
    )
    spans = arc.spans
    assert [span[:2] for span in spans] == [(1, 3), (3, 4)]
    for _, _, coefficients in spans:
        for s in np.linspace(0, 1, 7):
            *xyz, w = bernstein(coefficients, s)
            assert np.linalg.norm(xyz) / w == pytest.approx(radius, rel=1e-15)
    assert tuple(bernstein(spans[0][2], 1)[:3] / bernstein(spans[0][2], 1)[3]) == (0, radius, 0)


def test_spans_of_a_law_are_over_the_spine():
    spine = pn.Curve.bspline(1, [0, 2, 5], [2, 1, 2], [[0, 0, 0], [0, 0, 5], [0, 3, 5]])
    for law, exact in (
        (pn.Law.constant(2.5), lambda t: 2.5),
        (pn.Law.bspline(1, [0, 5], [2, 2], [1, 2]), lambda t: 1 + t / 5),
    ):
        for first, last, coefficients in law.spans_over(spine):
            for s in np.linspace(0, 1, 5):
                value, weight = bernstein(coefficients, s)
                t = first + (last - first) * s
                assert value / weight == pytest.approx(exact(t), rel=1e-15)
    with pytest.raises(pn.GeometryError):
        pn.Law.bezier([1, 2]).spans_over(spine)
