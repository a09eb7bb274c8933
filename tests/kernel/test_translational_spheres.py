# SPDX-License-Identifier: LGPL-2.1-or-later
"""Skins of translational families of spheres against their definition and against quadrics."""

import re

import numpy as np
import pnkernel as pn
import pnocct
import pytest
from quadrics import Quadric
from sphere_families import orientations
from sphere_translations import Translation, random_translation
from splines import Spline, norm, surface_point
from test_errors import refused
from trims import area, places_on, points, points_and_normals, polygon

SEEDS = range(3)
SIGNS = (1, -1)  # the outer skin, then the inner one
TIGHT = 1e-9  # mm: what an edge may lie beside the true boundary, for plates of 100 mm


def spline(curve):
    return pn.SphereSpline.bspline(curve.degree, curve.knots, curve.multiplicities, curve.poles)


def skins(translation):
    return pn.sphere_family_translational(spline(translation.c), spline(translation.d)).skins


def skin(translation, sign, distance=0.0):
    return skins(translation)[SIGNS.index(sign)].offset(distance)


def side(surface):
    """1 where the normals of a surface over the (x, y)-plane point upwards, else -1."""
    _, ((_, _, z),) = surface.evaluate([0.5], [0.5])
    return np.sign(z)


def bezier(spheres):
    return Spline.bezier(np.array(spheres, dtype=float))


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("sign", SIGNS)
@pytest.mark.parametrize(("spans", "distance"), [((1, 1), 0), ((1, 1), 1.5), ((2, 3), -1.25)])
def test_every_point_is_on_the_envelope_within_the_deviation(seed, sign, spans, distance):
    random = np.random.default_rng(seed)
    translation = random_translation(random, spans)
    surface = skin(translation, sign, distance)
    faces, deviation = surface.bsplines(), surface.certificate.deviation
    assert len(faces) == spans[0] * spans[1]
    assert deviation < 1e-11
    for face in faces:
        (place,) = places_on(face, 1, random)
        point = surface_point(face, *place)
        u, v = translation.parameters(point, sign, distance)
        assert -TIGHT < u < spans[0] + TIGHT and -TIGHT < v < spans[1] + TIGHT
        assert norm(point - translation.point(u, v, sign, distance)) <= deviation


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("sign", SIGNS)
def test_edges_are_those_of_the_rectangle(seed, sign):
    translation = random_translation(np.random.default_rng(seed))
    surface = skin(translation, sign, 0.5)
    (face,) = surface.bsplines()
    assert (face.u_degree, face.v_degree) == (8, 6)
    assert surface.certificate.trim_deviation < TIGHT
    (loop,) = face.trims
    assert area(polygon(loop)) > 0
    corners = [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]
    edges = list(zip(corners, corners[1:], strict=False))
    if sign < 0:  # the loop runs the other way round, seen from the outer side
        edges = [(end, start) for start, end in reversed(edges)]
    for curve, (start, end) in zip(loop, edges, strict=True):
        for part, place in zip(np.linspace(0, 1, 5), points(curve, 5), strict=True):
            u, v = (1 - part) * np.array(start) + part * np.array(end)
            assert norm(surface_point(face, *place) - translation.point(u, v, sign, 0.5)) < TIGHT


@pytest.mark.parametrize("sign", SIGNS)
def test_faces_of_many_spans_are_one_shell(sign):
    translation = random_translation(np.random.default_rng(5), (3, 2))
    shell = pnocct.shell(skin(translation, sign, 0.25).bsplines())
    assert pnocct.check(shell, boolean=True) == []
    assert pnocct.trim_deviation(shell) < 1e-8
    # Of 3 times 2 quadrangles, each edge once.
    assert len(re.findall(r"^Ed$", shell, re.MULTILINE)) == 3 * 3 + 2 * 4


def edges_of(surface):
    """Points and normals along each edge of each face."""
    return [
        points_and_normals(surface, number, curve)
        for number, face in enumerate(surface.bsplines())
        for curve in face.trims[0]
    ]


def shared(edges):
    """How many edges have a reversed one with the same points and normals."""
    return sum(
        min(np.abs(edge - other[::-1]).max() for other in edges if other is not edge) < 1e-9
        for edge in edges
    )


def joined(curve, factor):
    """The curve and a second span that goes on in its direction, with another speed and bend."""
    *_, before, last = curve.poles
    further = last + factor * (last - before)
    end = 2 * further - last + [0, 0, -3, 0.25]
    return Spline.joined([curve.poles, [last, further, end]])


@pytest.mark.parametrize("sign", SIGNS)
@pytest.mark.parametrize("distance", [0, 0.75])
def test_neighbours_share_edges_and_normals_where_splines_are_smooth(sign, distance):
    """C1 splines, and joints of one direction with two speeds."""
    c1 = random_translation(np.random.default_rng(6), (3, 2))
    edges = edges_of(skin(c1, sign, distance))
    assert (len(edges), shared(edges)) == (4 * 6, 2 * 7)
    curves = [
        bezier([[0, 0, 0, 2], [50, 0, 8, 2.5], [100, 0, 4, 2]]),
        bezier([[0, 0, 0, 2], [0, 50, 6, 2.5], [0, 100, 2, 2.25]]),
    ]
    two_speeds = Translation(joined(curves[0], 0.5), joined(curves[1], 2))
    edges = edges_of(skin(two_speeds, sign, distance))
    assert (len(edges), shared(edges)) == (4 * 4, 2 * 4)


def test_normals_point_away_from_the_mid_surface():
    translation = random_translation(np.random.default_rng(1))
    for sign in SIGNS:
        surface = skin(translation, sign)
        (face,) = surface.bsplines()
        (place,) = places_on(face, 1, np.random.default_rng(0))
        (point,), (normal,) = surface.evaluate([place[0]], [place[1]])
        u, v = translation.parameters(point, sign, 0)
        expected = np.array(translation.normal(u, v, sign), dtype=float)
        assert np.allclose(normal, expected, rtol=0, atol=1e-12)
        (moved,), _ = surface.offset(2).evaluate([place[0]], [place[1]])
        assert np.allclose(moved, point + 2 * normal, rtol=0, atol=1e-12)


def paraboloid(kind, radius):
    """z = x^2 / 8 + y^2 / 2, or - y^2 / 2, over |x| <= 2, |y| <= 1; each curve has half the radius."""
    bend = 1 / 2 if kind == "elliptic_paraboloid" else -1 / 2
    return Translation(
        bezier([[-2, 0, 1 / 2, radius / 2], [0, 0, -1 / 2, radius / 2], [2, 0, 1 / 2, radius / 2]]),
        bezier([[0, -1, bend, radius / 2], [0, 0, -bend, radius / 2], [0, 1, bend, radius / 2]]),
    )


@pytest.mark.parametrize("kind", ["elliptic_paraboloid", "hyperbolic_paraboloid"])
@pytest.mark.parametrize("sign", SIGNS)
def test_parabolas_of_constant_radius_are_the_offset_of_a_paraboloid(kind, sign):
    """As point sets: each lies on the other, both over the same rectangle, with one area."""
    radius, distance = 0.25, 0.125
    translation = paraboloid(kind, radius)
    surface = skin(translation, sign, distance)
    assert any("offsets of the mid-surface" in note for note in surface.certificate.notes)
    definition = Quadric.of(kind, 2, 1, 1 / 2)
    quadric = pn.quadric(kind, 2, 1, 1 / 2, {"x": (-2, 2), "y": (-1, 1)})
    offset = quadric.offset(side(quadric) * sign * (radius + distance))
    random = np.random.default_rng(0)
    (face,) = surface.bsplines()
    for place in places_on(face, 5, random):
        point = surface_point(face, *place)
        foot = min(definition.feet(point), key=lambda y: abs(norm(point - y) - radius - distance))
        tolerance = surface.certificate.deviation
        assert abs(norm(point - foot) - radius - distance) <= tolerance
        assert abs(foot[0]) <= 2 + TIGHT and abs(foot[1]) <= 1 + TIGHT
    for face in offset.bsplines():
        for place in places_on(face, 3, random):
            point = surface_point(face, *place)
            u, v = translation.parameters(point, sign, distance)
            assert -TIGHT < u < 1 + TIGHT and -TIGHT < v < 1 + TIGHT
            tolerance = offset.certificate.deviation
            assert norm(point - translation.point(u, v, sign, distance)) <= tolerance
    areas = [pnocct.area(pnocct.shell(s.bsplines())) for s in (surface, offset)]
    assert np.isclose(*areas, rtol=1e-9, atol=0)


def test_a_line_of_spheres_along_a_parabola_is_a_cylinder_over_its_offset():
    radius = 0.5
    translation = Translation(
        bezier([[0, 0, 0, radius / 2], [0, 5, 0, radius / 2]]),
        bezier([[-2, 0, 1, radius / 2], [0, 0, -1, radius / 2], [2, 0, 1, radius / 2]]),
    )
    definition = Quadric.of("parabolic_cylinder", 2, 1, 1)
    quadric = pn.quadric("parabolic_cylinder", 2, 1, 1, {"x": (-2, 2), "y": (0, 5)})
    # m_u x m_v = (0, 1, 0) x (1, 0, .) is downwards: the outer skin is that below.
    for sign, distance in zip(SIGNS, (radius, -radius), strict=True):
        surface = skin(translation, sign)
        assert surface.degree == (1, 6)
        (face,) = surface.bsplines()
        for place in places_on(face, 4, np.random.default_rng(0)):
            point = surface_point(face, *place)
            foot = min(definition.feet(point), key=lambda y, p=point: norm(p - y))
            assert abs(norm(point - foot) - radius) <= surface.certificate.deviation
            assert (foot - point)[2] * sign > 0
        offset = quadric.offset(distance)
        areas = [pnocct.area(pnocct.shell(s.bsplines())) for s in (surface, offset)]
        assert np.isclose(*areas, rtol=1e-9, atol=0)


def test_two_lines_of_spheres_have_planes_for_skins():
    translation = Translation(
        bezier([[0, 0, 0, 1], [10, 0, 0, 2]]), bezier([[0, 0, 0, 1], [0, 20, 5, 3]])
    )
    for sign, surface in zip(SIGNS, skins(translation), strict=True):
        (face,) = surface.bsplines()
        normal = translation.normal(0, 0, sign)
        level = normal @ translation.point(0, 0, sign)
        for place in places_on(face, 4, np.random.default_rng(0)):
            point = surface_point(face, *place)
            assert abs(normal @ point - level) <= surface.certificate.deviation


def test_the_regular_range_is_inside_the_focal_distances():
    """Offsets within it have S_u x S_v along the normal everywhere on the face."""
    for surface in skins(random_translation(np.random.default_rng(3))):
        lower, upper = surface.regular_range
        assert lower < 0 < upper
        for distance in (0.999 * lower, 0.999 * upper):
            (face,) = surface.offset(distance).bsplines()
            places = places_on(face, 20, np.random.default_rng(0))
            assert (orientations(surface.offset(distance), places) > 0).all()


GOOD = [[0, 0, 0, 1], [5, 0, 1, 1.5], [10, 0, 0, 1]]
ACROSS = pn.SphereSpline.bezier([[0, 0, 0, 1], [0, 5, 1, 1], [0, 10, 0, 1.5]])


def family(spheres):
    return pn.sphere_family_translational(pn.SphereSpline.bezier(spheres), ACROSS)


def test_arrays_and_knots_of_the_wrong_shape_are_refused():
    assert "(n, 4)" in refused("wrong_shape", lambda: pn.SphereSpline.bezier(np.zeros((3, 3))))
    refused("wrong_shape", lambda: pn.SphereSpline.bezier(GOOD[:1]))
    refused("bad_knots", lambda: pn.SphereSpline.bspline(2, [0, 1], [3, 2], GOOD))


@pytest.mark.parametrize(
    ("code", "sentence", "make"),
    [
        ("not_finite", "finite", lambda: family([*GOOD[:2], [10, np.nan, 0, 1]])),
        ("not_finite", "finite", lambda: family([*GOOD[:2], [10, 0, 0, np.inf]])),
        (
            "zero_length",
            "first curve of spheres, at parameter 0, stands still for a span",
            lambda: family([GOOD[0], GOOD[0]]),
        ),
        (
            "zero_length",
            r"one direction near \(u, v\) = \(",
            lambda: pn.sphere_family_translational(ACROSS, ACROSS),
        ),
        (
            "radius_too_steep",
            r"no envelope near \(u, v\) = \(.*swallows",
            lambda: family([*GOOD[:2], [10, 0, 0, 20]]),
        ),
        (
            "not_rational",
            "first curve of spheres has degree 3.*quadratic spline",
            lambda: family([*GOOD, [15, 0, 5, 1]]),
        ),
        (
            "corner_too_sharp",
            "first curve of spheres, at parameter 1, has a corner.*multiplicity 1",
            lambda: pn.sphere_family_translational(
                pn.SphereSpline.bspline(1, [0, 1, 2], [2, 1, 2], GOOD), ACROSS
            ),
        ),
        (
            "corner_too_sharp",
            "second curve of spheres, at parameter 1, has a corner",
            lambda: pn.sphere_family_translational(
                ACROSS, pn.SphereSpline.bspline(1, [0, 1, 2], [2, 1, 2], GOOD)
            ),
        ),
        (
            "weights_not_positive",
            "normals turn too far within a span",
            lambda: family([GOOD[0], [5, 0, 1e6, 1], GOOD[2]]).skins,
        ),
    ],
)
def test_bad_input_is_refused_with_its_reason(code, sentence, make):
    assert re.search(sentence, refused(code, make))
