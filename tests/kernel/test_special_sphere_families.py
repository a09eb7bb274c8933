# SPDX-License-Identifier: LGPL-2.1-or-later
"""Families of spheres without a chart of normals, or with a base point in a special place."""

import numpy as np
import pnkernel as pn
import pnocct
import pytest
from sphere_families import Family
from splines import norm, surface_point
from test_rounded_solid import defined_volume
from trims import points

TRIANGLE = ((1, 0), (0, 1), (0, 0))


def spheres_of(sphere, corners=TRIANGLE):
    """The control spheres of a quadratic (x, y, z, r)(u, v) over a triangle."""
    p, q, s = np.array(corners, dtype=float)

    def at(a, b):
        return np.array(sphere(*((a + b) / 2)), dtype=float)

    def between(a, b):
        return 2 * at(a, b) - (at(a, a) + at(b, b)) / 2

    return np.array([at(p, p), between(p, q), at(q, q), between(p, s), between(q, s), at(s, s)])


def bent(u, v):
    return 64 * u + 4 * v * v, 64 * v + 8 * u * v, 8 * u * u + 16 * u * v - 12 * v


def with_parabolic_line(u, v):
    """Along v = 0 a skin touches a plane; the root of the sextic is multiple."""
    return 64 * u, 64 * v + 8 * u * u, -16 * v * v, 4


FAMILIES = {
    "flat": spheres_of(lambda u, v: (64 * u + 8 * v * v, 64 * v + 8 * u * v, 0, 3)),
    "flat, linear thickness": spheres_of(lambda u, v: (64 * u, 64 * v + 8 * u * v, 0, 4 + 8 * u)),
    "flat, quadratic thickness": spheres_of(
        lambda u, v: (64 * u, 64 * v + 8 * u * v, 0, 4 + 8 * u * u + 4 * v * v)
    ),
    "on one plane": spheres_of(lambda u, v: (*bent(u, v), 16 + bent(u, v)[2])),
    "bent one way": spheres_of(lambda u, v: (64 * u, 64 * v, 16 * u * u, 4)),
    "bent one way, conical": spheres_of(
        lambda u, v: (64 * u, 64 * v - 16 * u, 16 * (u + v / 2) ** 2, 4 + (u + v / 2) ** 2 + v)
    ),
    "base point inside": spheres_of(with_parabolic_line, ((1, -0.5), (0, 0.5), (0, -0.25))),
    "base point on an edge": spheres_of(with_parabolic_line, ((1, 0), (-0.25, 1), (-0.25, 0))),
    "base point in a corner": spheres_of(with_parabolic_line, ((1, 0.5), (0, 1), (0, 0))),
}


@pytest.fixture(params=FAMILIES, ids=lambda name: name.replace(" ", "_"))
def spheres(request):
    return FAMILIES[request.param]


@pytest.mark.parametrize("distance", [0, 1.25])
def test_edges_lie_on_the_envelope(spheres, distance):
    family = Family.of(spheres)
    corners = [(0, 0), (1, 0), (0, 1), (0, 0)]
    for sign, skin in zip((1, -1), pn.sphere_family(spheres).skins, strict=True):
        surface = skin.offset(distance)
        assert surface.certificate.deviation < 1e-11
        (face,) = surface.bsplines()
        around = list(zip(corners, corners[1:], strict=False))
        if sign < 0:
            around = [(end, start) for start, end in reversed(around)]
        for curve, (start, end) in zip(face.trims[0], around, strict=True):
            places = points(curve, 5)
            for part, place in zip((0, 0.25, 0.5, 0.75, 1), places, strict=True):
                u, v = (1 - part) * np.array(start) + part * np.array(end)
                point = surface_point(face, *place)
                assert norm(point - family.point(u, v, sign, distance)) < 1e-9


def test_the_solid_is_clean_and_its_volume_a_cubic(spheres):
    solid = pn.sphere_family(spheres).solid()
    volumes = []
    for distance in range(4):
        brep = pnocct.capped_solid(solid.offset(distance).bsplines())
        assert pnocct.check(brep, boolean=True) == []
        volumes.append(pnocct.volume(brep))
    assert np.diff(volumes, 3) == pytest.approx(8 * np.pi, abs=1e-7 * volumes[0])


@pytest.mark.parametrize("name", ["flat, quadratic thickness", "bent one way, conical"])
def test_the_volume_is_that_of_the_definition(name):
    """Strips of bidegree (6, 4), skins in the chart of normals and in that of circles."""
    brep = pnocct.capped_solid(pn.sphere_family(FAMILIES[name]).solid(0.5).bsplines())
    value, error = pnocct.measured_volume(brep)
    assert abs(value - defined_volume(FAMILIES[name], 0.5, nodes=36)) < 1e-9 * value + error


def test_a_flat_triangle_has_steiners_volume():
    """Spheres of one radius along a triangle: 2 r A + pi r^2 P / 2 + 4 pi r^3 / 3."""
    corners = np.array([[64.0, 0, 0], [0, 48, 0], [0, 0, 0]])
    a, b, c = corners
    spheres = np.column_stack([[a, (a + b) / 2, b, (a + c) / 2, (b + c) / 2, c], [3.0] * 6])
    area, perimeter = 64 * 48 / 2, 64 + 48 + 80
    for distance in (0, 2):
        r = 3 + distance
        solid = pnocct.capped_solid(pn.sphere_family(spheres).solid(distance).bsplines())
        expected = 2 * r * area + np.pi * r**2 * perimeter / 2 + 4 * np.pi * r**3 / 3
        assert pnocct.volume(solid) == pytest.approx(expected, rel=1e-12)


def test_degrees_are_those_of_their_own_formulas():
    def degree(name):
        return [skin.degree for skin in pn.sphere_family(FAMILIES[name]).skins]

    assert degree("flat") == [(2, 2), (2, 2)]
    assert degree("on one plane") == [(6, 6), (2, 2)]
    assert degree("bent one way") == [(1, 6), (1, 6)]
    assert degree("base point inside") == [(8, 6), (8, 6)]
