# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first singular points beyond the regular range are centres of curvature of the surface."""

import numpy as np
import pnkernel as pn
import pytest
from canal import random_canal
from rulings import Cones, random_pair

SURFACES = {
    "cubic pipe": lambda: pn.canal_surface(
        pn.Curve.bezier([[0, 0, 0], [15, 5, 0], [20, 15, 5], [20, 20, 0]]),
        pn.Law.bezier([2, 1.8, 2, 2.5]),
    ),
    "random horn": lambda: random_canal(5, 3, 1).surface(),
    "random horn of three spans": lambda: random_canal(6, 4, 3).surface(),
    "rational horn": lambda: random_canal(7, 3, 1, rational=True).surface(),
    "sheet": lambda: Cones(random_pair(1, 2)).surface(),
    "twisted sheet": lambda: Cones(random_pair(2, 3)).surface(),
    "saddle": lambda: pn.quadric("hyperbolic_paraboloid", 10, 12, 5, {"x": (-9, 9), "y": (-9, 9)}),
    "bowl": lambda: pn.quadric("elliptic_paraboloid", 10, 12, 5, {"z": (0, 5)}),
    "egg": lambda: pn.quadric("ellipsoid", 30, 20, 10),
    "tower": lambda: pn.quadric("one_sheet_hyperboloid", 10, 12, 20, {"z": (-10, 15)}),
}


def samples(surface):
    """Points of the faces on grids of parameters."""
    points = []
    for face in surface.bsplines():
        t = np.linspace(face.u_knots[0], face.u_knots[-1], 301)
        u = np.linspace(face.v_knots[0], face.v_knots[-1], 301)
        points.append(surface.evaluate(*(g.ravel() for g in np.meshgrid(t, u)))[0])
    return np.concatenate(points)


@pytest.mark.parametrize("name", SURFACES)
def test_a_base_point_is_nearest_until_its_focal_point(name):
    surface = SURFACES[name]()
    points = samples(surface)
    limits = surface.regular_range
    assert limits[0] < limits[1]
    for focal, limit in zip(surface.focal_points, limits, strict=True):
        assert (focal is None) == np.isinf(limit)
        if focal is None:
            continue
        arm = focal.point - focal.base
        reach = np.linalg.norm(arm)
        assert reach == pytest.approx(abs(focal.distance), rel=1e-9)
        assert abs(focal.distance - limit) <= 1e-5 * reach
        near = points[np.linalg.norm(points - focal.base, axis=1) < reach / 2]
        assert np.linalg.norm(near - focal.base, axis=1).min() < reach / 20
        for share in (0.5, 0.9):
            nearest = np.linalg.norm(near - (focal.base + share * arm), axis=1).min()
            assert nearest >= share * reach * (1 - 1e-9)
        # Beyond it the base point is no longer nearest: the surface bends more than the sphere.
        nearest = np.linalg.norm(near - (focal.base + 1.2 * arm), axis=1).min()
        assert nearest < 1.2 * reach * (1 - 1e-5)


def check(focal, base, point):
    np.testing.assert_allclose(focal.base, base, rtol=0, atol=1e-6)
    np.testing.assert_allclose(focal.point, point, rtol=0, atol=1e-6)


def test_closed_forms():
    egg = pn.quadric("ellipsoid", 30, 20, 10).focal_points
    side = np.sign(egg[0].base[0])
    check(egg[0], [30 * side, 0, 0], [(30 - 100 / 30) * side, 0, 0])
    assert egg[1] is None
    saddle = pn.quadric("hyperbolic_paraboloid", 10, 12, 5, {"x": (-5, 5), "y": (-5, 5)})
    check(saddle.focal_points[0], [0, 0, 0], [0, 0, -14.4])
    check(saddle.focal_points[1], [0, 0, 0], [0, 0, 10])
    bowl = pn.quadric("elliptic_paraboloid", 10, 12, 5, {"z": (0, 5)})
    check(bowl.focal_points[0], [0, 0, 0], [0, 0, 10])
    cone = pn.quadric("elliptic_cone", 10, 10, 5, {"z": (1, 5)}).focal_points[0]
    np.testing.assert_allclose(cone.point, [0, 0, 5], rtol=0, atol=1e-6)
    assert cone.base[2] == pytest.approx(1)


def test_all_offsets_have_those_of_their_base():
    surface = SURFACES["cubic pipe"]()
    for own, others in zip(surface.focal_points, surface.offset(0.5).focal_points, strict=True):
        np.testing.assert_array_equal(own.base, others.base)
        np.testing.assert_array_equal(own.point, others.point)


def test_where_nothing_is_claimed_there_is_none():
    back = pn.Curve.bezier([[0, 0, 0], [4, 0, 0], [0, 0, 0]])
    assert pn.canal_surface(back, pn.Law.constant(0.5)).focal_points == (None, None)
