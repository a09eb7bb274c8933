# SPDX-License-Identifier: LGPL-2.1-or-later
"""Skins of two-parameter families of spheres against their definition."""

import numpy as np
import pnkernel as pn
import pytest
from sphere_families import Family, orientations, random_spheres
from splines import norm, surface_point
from test_errors import refused
from trims import area, places_on, points, polygon

SEEDS = range(4)
SIGNS = (1, -1)  # the outer skin, then the inner one
TIGHT = 1e-9  # mm: what an edge may lie beside the true boundary, for plates of 100 mm
CORNERS = [(0, 0), (1, 0), (0, 1), (0, 0)]


def plate(seed, **shape):
    return random_spheres(np.random.default_rng(seed), **shape)


def single_face(spheres, sign, distance=0.0):
    surface = pn.sphere_family(spheres).skins[SIGNS.index(sign)].offset(distance)
    (face,) = surface.bsplines()
    return surface, face


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("sign", SIGNS)
@pytest.mark.parametrize("distance", [0, 1.5, -2.25])
def test_every_point_is_on_the_envelope_within_the_deviation(seed, sign, distance):
    spheres = plate(seed, dome=True)
    family = Family.of(spheres)
    surface, face = single_face(spheres, sign, distance)
    deviation = surface.certificate.deviation
    assert deviation < 1e-11
    for place in places_on(face, 3, np.random.default_rng(seed)):
        point = surface_point(face, *place)
        u, v = family.parameters(point, sign, distance, (1 / 3, 1 / 3))
        assert u > -TIGHT and v > -TIGHT and u + v < 1 + TIGHT
        assert norm(point - family.point(u, v, sign, distance)) <= deviation


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("sign", SIGNS)
def test_edges_are_those_of_the_triangle(seed, sign):
    spheres = plate(seed, dome=True)
    family = Family.of(spheres)
    surface, face = single_face(spheres, sign, 0.5)
    assert surface.certificate.trim_deviation < TIGHT
    (loop,) = face.trims
    assert len(loop) == 3
    assert area(polygon(loop)) > 0
    edges = list(zip(CORNERS, CORNERS[1:], strict=False))
    if sign < 0:  # the loop runs the other way round, seen from the outer side
        edges = [(end, start) for start, end in reversed(edges)]
    for curve, (start, end) in zip(loop, edges, strict=True):
        ends = [surface_point(face, *place) for place in (points(curve, 2))]
        for point, corner in zip(ends, (start, end), strict=True):
            assert norm(point - family.point(*corner, sign, 0.5)) < TIGHT
        for place in points(curve, 7):
            point = surface_point(face, *place)
            u, v = family.parameters(point, sign, 0.5, (1 / 3, 1 / 3))
            assert min(abs(u), abs(v), abs(1 - u - v)) < TIGHT / 10
            assert norm(point - family.point(u, v, sign, 0.5)) < TIGHT


@pytest.mark.parametrize("seed", SEEDS)
def test_no_face_leaves_the_triangle(seed):
    spheres = plate(seed)
    family = Family.of(spheres)
    random = np.random.default_rng(seed)
    for sign, surface in zip(SIGNS, pn.sphere_family(spheres).skins, strict=True):
        for face in surface.bsplines():
            for place in places_on(face, 3, random):
                u, v = family.parameters(surface_point(face, *place), sign, 0, (1 / 3, 1 / 3))
                assert min(u, v, 1 - u - v) > -TIGHT


def test_normals_point_away_from_the_mid_surface():
    spheres = plate(1, dome=True)
    family = Family.of(spheres)
    for sign in SIGNS:
        surface, face = single_face(spheres, sign)
        (place,) = places_on(face, 1, np.random.default_rng(0))
        (point,), (normal,) = surface.evaluate([place[0]], [place[1]])
        u, v = family.parameters(point, sign, 0, (1 / 3, 1 / 3))
        expected = np.array(family.normal(u, v, sign), dtype=float)
        assert np.allclose(normal, expected, rtol=0, atol=1e-12)
        (moved,), _ = surface.offset(2).evaluate([place[0]], [place[1]])
        assert np.allclose(moved, point + 2 * normal, rtol=0, atol=1e-12)


def test_equal_radii_are_named_as_an_offset():
    spheres = plate(2)
    spheres[:, 3] = 2
    family = pn.sphere_family(spheres)
    assert any("offsets of the mid-surface" in note for note in family.notes)
    assert family.skins[0].certificate.notes == family.notes


def test_bad_input_is_refused_with_its_reason():
    spheres = plate(0)
    refused("wrong_shape", lambda: pn.sphere_family(spheres[:5]))
    refused("wrong_shape", lambda: pn.sphere_family(spheres[:, :3]))
    for bad in (np.nan, np.inf):
        broken = spheres.copy()
        broken[4, 1] = bad
        refused("not_finite", lambda broken=broken: pn.sphere_family(broken))
    for direction in (0, 1):
        line = spheres.copy()
        line[:, :3] = direction * np.outer(np.arange(6), [1, 2, 3])
        refused("zero_length", lambda line=line: pn.sphere_family(line))
    swallowing = spheres.copy()
    swallowing[0, 3] += 150
    sentence = refused("radius_too_steep", lambda: pn.sphere_family(swallowing))
    assert "swallows" in sentence and "% of the triangle has one" in sentence


def test_the_part_with_an_envelope_is_found():
    spheres = plate(0)
    spheres[0, 3] += 150
    region = pn.real_region(spheres, halvings=4)
    assert len(region["real"]) and len(region["unreal"]) and len(region["border"])
    areas = [
        abs(np.linalg.det(corners[:2] - corners[2]))
        for kind in ("real", "unreal", "border")
        for corners in region[kind]
    ]
    assert sum(areas) == 1
    for control, corners in zip(region["families"], region["real"], strict=True):
        sphere, _, _ = Family.of(spheres).sphere(*corners[0])
        assert np.allclose(control[0], np.array(sphere, dtype=float), rtol=1e-15, atol=1e-13)
        assert pn.sphere_family(control).skins


def test_the_regular_range_is_inside_the_focal_distances():
    """Offsets within it have S_u x S_v along the normal everywhere on the face."""
    spheres = plate(3, dome=True)
    for surface in pn.sphere_family(spheres).skins:
        lower, upper = surface.regular_range
        assert lower < 0 < upper
        for distance in (0.999 * lower, 0.999 * upper):
            (face,) = surface.offset(distance).bsplines()
            places = places_on(face, 20, np.random.default_rng(0))
            assert (orientations(surface.offset(distance), places) > 0).all()
