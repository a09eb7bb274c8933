# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a CAD system needs of the faces: C1, closed, positive weights, boundaries, same bits."""

from concurrent.futures import ThreadPoolExecutor

import mpmath
import numpy as np
import pnkernel as pn
import pytest
from canal import random_canal
from mpmath import mpf
from splines import Spline, surface_point

LEAST_WEIGHT_RATIO = 0.01

CORNERED = Spline.joined(
    [
        [[0, 0, 0], [3, 0, 1], [6, 0, 0], [8, 1, 0]],
        [[8, 1, 0], [8, 4, 0], [7, 6, 2], [8, 9, 2]],
        [[8, 9, 2], [9, 12, 2], [9, 14, 4], [9, 17, 7]],
    ]
)
CLOSED = Spline.joined(
    [
        [[5, 0, 0], [5, 3, 1], [3, 5, 1], [0, 5, 0]],
        [[0, 5, 0], [-3, 5, -1], [-5, 3, 0], [-5, 0, 0]],
        [[-5, 0, 0], [-5, -3, 0], [-3, -5, 1], [0, -5, 0]],
        [[0, -5, 0], [3, -5, -1], [5, -3, -1], [5, 0, 0]],
    ]
)

SURFACES = {
    "one span": lambda: random_canal(0, 3).surface(),
    "one rational span": lambda: random_canal(1, 4, rational=True).surface(),
    "spans": lambda: random_canal(0, 3, spans=3).surface(),
    "corners": lambda: pn.canal_surface(pn.Curve.bspline(*CORNERED.arguments), pn.Law.constant(1)),
    "closed": lambda: pn.canal_surface(pn.Curve.bspline(*CLOSED.arguments), pn.Law.constant(1)),
    "substituted": lambda: pn.canal_surface(
        pn.Curve.bezier([[0, 0, 0], [1, 0, 2], [0, 0, 4]]), pn.Law.bezier([2, 1.5, 3])
    ),
}


@pytest.fixture(params=SURFACES)
def surface(request):
    return SURFACES[request.param]()


def bits(surface, lines):
    return [
        (face.poles.tobytes(), face.weights.tobytes(), face.u_knots.tobytes(), face.v_knots.tobytes())
        for face in surface.bsplines(lines)
    ]


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
def test_arrays_fit_each_other(surface, lines):
    for face in surface.bsplines(lines):
        u_count, v_count = face.weights.shape
        assert face.poles.shape == (u_count, v_count, 3)
        assert face.poles.dtype == face.weights.dtype == face.u_knots.dtype == np.float64
        for degree, knots, multiplicities, count in (
            (face.u_degree, face.u_knots, face.u_multiplicities, u_count),
            (face.v_degree, face.v_knots, face.v_multiplicities, v_count),
        ):
            assert len(knots) == len(multiplicities)
            assert np.all(np.diff(knots) > 0)
            assert multiplicities[0] == multiplicities[-1] == degree + 1
            assert sum(multiplicities) == count + degree + 1
            assert degree <= 25
        assert np.all(np.isfinite(face.poles)) and np.all(face.weights > 0)
        assert face.trims == []


def test_even_faces_are_closed_and_smooth(surface):
    for face in surface.bsplines():
        assert np.array_equal(face.poles[:, 0], face.poles[:, -1])
        assert np.array_equal(face.weights[:, 0], face.weights[:, -1])
        assert all(m < face.u_degree for m in face.u_multiplicities[1:-1])
        assert all(m < face.v_degree for m in face.v_multiplicities[1:-1])
        assert face.weights.min() > LEAST_WEIGHT_RATIO * face.weights.max()


def joints(surface):
    """The faces before and after each joint along the spine, closed spines included."""
    faces = surface.bsplines()
    closed = np.array_equal(faces[0].poles[0], faces[-1].poles[-1])
    return [*zip(faces, faces[1:]), *([(faces[-1], faces[0])] if closed else [])]


def test_even_faces_share_their_circles():
    for name, count in (("corners", 3), ("closed", 4)):
        pairs = joints(SURFACES[name]())
        assert len(pairs) == count
        for before, after in pairs:
            assert np.array_equal(before.poles[-1], after.poles[0])
            scale = after.weights[0] / before.weights[-1]
            assert np.ptp(scale) == 0  # homogeneous coordinates are free up to one factor


def test_smooth_spans_make_one_face():
    (face,) = SURFACES["spans"]().bsplines()
    assert len(face.u_knots) >= 4


def strips_of(faces):
    """The faces of each piece of the spine, arc by arc around it."""
    strips = []
    for face in faces:
        if face.v_knots[0] == 0:
            strips.append([])
        strips[-1].append(face)
    assert {len(strip) for strip in strips} == {len(strips[0])}
    return strips


@pytest.mark.parametrize("distance", [0.0, 0.4])
def test_lowest_degree_faces(surface, distance):
    moved = surface.offset(distance)
    strips = strips_of(moved.bsplines("lowest_degree"))
    closed = np.array_equal(strips[0][0].poles[0], strips[-1][0].poles[-1])
    along, around = moved.degree
    # The lines stay where the algebra puts them, or turn linearly where weights or closing ask for
    # it; zones of spheres are of a lower degree.
    assert max(face.u_degree for face in strips[0]) in (along, along + 2)
    assert all(
        face.u_degree <= along + 2 and face.v_degree == around for strip in strips for face in strip
    )
    for strip in strips:
        for face, neighbour in zip(strip, strip[1:] + strip[:1]):
            assert np.array_equal(face.poles[:, -1], neighbour.poles[:, 0])
    for strip, following in zip(strips, strips[1:] + (strips[:1] if closed else [])):
        for face, neighbour in zip(strip, following):
            assert np.array_equal(face.poles[-1], neighbour.poles[0])


def test_lowest_degree_is_that_of_the_algebra():
    surface = random_canal(3, 3, spans=2).surface()
    degrees = {(face.u_degree, face.v_degree) for face in surface.bsplines("lowest_degree")}
    assert degrees == {tuple(surface.degree)}


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
def test_faces_turn_their_normal_outwards(lines):
    canal = random_canal(4, 3)
    step = mpf(10) ** -25
    for face in canal.surface().bsplines(lines):
        u, v = (
            mpf(knots[0]) + mpf("0.37") * (mpf(knots[-1]) - mpf(knots[0]))
            for knots in (face.u_knots, face.v_knots)
        )
        point = surface_point(face, u, v)
        along = (surface_point(face, u + step, v) - point) / step
        around = (surface_point(face, u, v + step) - point) / step
        (m, _, _), _ = canal.spheres(u, 0)
        cross = np.cross(along, around)
        arm = point - m
        cosine = cross @ arm / mpmath.sqrt((cross @ cross) * (arm @ arm))
        assert cosine == pytest.approx(1, abs=1e-12)


def test_evaluate_gives_points_of_the_faces():
    canal = random_canal(6, 3, spans=3)
    surface = canal.surface().offset(0.3)
    (face,) = surface.bsplines()
    random = np.random.default_rng(0)
    t = np.array([*canal.spine.knots, *random.uniform(0, canal.spine.knots[-1], 10)])
    u = np.array([0, 4, 1, 2, *random.uniform(0, 4, len(t) - 4)])
    points, normals = surface.evaluate(t, u)
    assert points.shape == normals.shape == (len(t), 3)
    for i, point in enumerate(points):
        exact = np.array(surface_point(face, t[i], u[i]), dtype=float)
        np.testing.assert_allclose(point, exact, rtol=0, atol=16 * np.spacing(canal.size))


def test_same_bits_in_repeated_runs(surface):
    for lines in ("even", "lowest_degree"):
        assert bits(surface, lines) == bits(surface.offset(0.0), lines)
    for make in SURFACES.values():
        assert bits(make(), "even") == bits(make(), "even")


def test_same_bits_from_many_threads():
    distances = [0.1 * i for i in range(16)]
    alone = SURFACES["spans"]()
    expected = [
        bits(alone.offset(d), "even") + bits(alone.offset(d), "lowest_degree") for d in distances
    ]
    shared = SURFACES["spans"]()

    def work(d):
        moved = shared.offset(d)
        return bits(moved, "even") + bits(moved, "lowest_degree")

    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(work, distances)) == expected
        assert list(pool.map(lambda _: bits(SURFACES["spans"](), "even"), range(8))) == (
            [bits(alone, "even")] * 8
        )


def test_certificate_describes_the_even_faces(surface):
    certificate = surface.certificate
    faces = surface.bsplines()
    assert certificate.exact
    assert 0 < certificate.deviation < 1e-12
    assert certificate.precision_bits >= 104
    assert tuple(certificate.bidegree) == (
        max(face.u_degree for face in faces),
        max(face.v_degree for face in faces),
    )
    assert certificate.poles == sum(face.weights.size for face in faces)


def test_notes_tell_of_an_overlap_at_a_corner_only():
    (note,) = SURFACES["corners"]().certificate.notes
    assert "parameter 1" in note and "(8, 1, 0)" in note
    for name in SURFACES.keys() - {"corners"}:
        assert SURFACES[name]().certificate.notes == []


def test_closing_a_rounding_gap_is_told_and_counted():
    tiny = 1e-9
    spine = Spline.joined([[[0, 0, 0], [0, 0, 4]], [[0, 0, 4], [tiny, 0, 8]]])
    surface = pn.canal_surface(pn.Curve.bspline(*spine.arguments), pn.Law.constant(1))
    certificate = surface.certificate
    assert not certificate.exact
    (note,) = certificate.notes
    assert "parameter 1" in note
    assert tiny / 8 < certificate.deviation < tiny
