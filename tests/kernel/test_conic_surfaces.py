# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces of moving conics against their equation."""

from math import comb

import numpy as np
import pnkernel as pn
import pnocct
import pytest
from conics import beyond_cut, parameter_of, random_arcs, random_ellipses, residual, upright_frame
from splines import surface_point
from test_errors import refused

# What the rounding of poles leaves of an equation of size 1.
TIGHT = 1e-13


def samples(face, along, around):
    u = np.linspace(face.u_knots[0], face.u_knots[-1], along)
    v = np.linspace(face.v_knots[0], face.v_knots[-1], around)
    return [(a, surface_point(face, a, b)) for a in u for b in v]


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
@pytest.mark.parametrize("degree", [0, 1, 2, 4])
@pytest.mark.parametrize("seed", range(3))
def test_every_point_satisfies_the_equation(seed, degree, lines):
    span = (upright_frame(10), random_ellipses(np.random.default_rng(seed), degree), None)
    surface = pn.conic_surface(*span)
    assert surface.certificate_of(lines).deviation < 1e-11
    for face in surface.bsplines(lines):
        assert np.all(face.weights > 0)
        for _, x in samples(face, 4, 6):
            assert residual(span, x[2] / 10, x) < TIGHT


def test_the_ends_are_the_first_and_last_conic_and_the_face_closes():
    conic = random_ellipses(np.random.default_rng(1), 2)
    faces = pn.conic_surface(upright_frame(10), conic).bsplines()
    for v in np.linspace(0, 4, 9):
        assert float(surface_point(faces[0], 0, v)[2]) == pytest.approx(0, abs=1e-12)
        assert float(surface_point(faces[-1], 1, v)[2]) == pytest.approx(10, abs=1e-12)
    for face in faces:
        assert np.array_equal(face.poles[:, 0], face.poles[:, -1])
        assert np.array_equal(face.weights[:, 0], face.weights[:, -1])


# (cos, sin) = ((1 - t^2), 2 t) / (1 + t^2), Bernstein coefficients over [0, 1]: a quarter turn.
COS, SIN, ONE = np.array([1, 1, 0]), np.array([0, 1, 2]), np.array([1, 1, 2])


def quarter_of_torus(quarter, conic):
    """Conics (1, radial, z) in planes through the z-axis, around centres at distance 3."""
    frame = np.zeros((3, 4, 3))
    c, s = [(COS, SIN), (-SIN, COS), (-COS, -SIN), (SIN, -COS)][quarter]
    frame[:, 0, 0], frame[:, 1, 0], frame[:, 3, 0] = 3 * c, 3 * s, ONE
    frame[:, 0, 1], frame[:, 1, 1] = c, s
    frame[:, 2, 2] = ONE
    return frame, conic, None


def test_a_moving_circle_is_the_canal_surface_of_its_spheres():
    surface = pn.conic_surface(*quarter_of_torus(0, np.diag([-1.0, 1, 1])[None]))
    (face,) = surface.bsplines()
    assert surface.degree == (2, 2)
    for _, (x, y, z) in samples(face, 7, 9):
        assert (np.hypot(float(x), float(y)) - 3) ** 2 + float(z) ** 2 == pytest.approx(1, abs=1e-12)


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
def test_spans_around_an_axis_close_to_a_ring_of_known_volume(lines):
    # Half-axes 1 and 2.
    ellipse = np.diag([-4.0, 4, 1])[None]
    surface = pn.conic_surface_of_spans([quarter_of_torus(i, ellipse) for i in range(4)])
    faces = surface.bsplines(lines)
    ring = pnocct.capped_solid(faces)
    assert pnocct.check(ring, boolean=True) == []
    # Pappus: the area times the way of its centre.
    assert pnocct.volume(ring) == pytest.approx(2 * np.pi * 2 * np.pi * 3, rel=1e-9)
    assert surface.certificate_of(lines).deviation < 1e-13
    assert surface.self_intersection() is None


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
@pytest.mark.parametrize("seed", range(3))
def test_neighbouring_spans_share_their_conic_bit_for_bit(seed, lines):
    random = np.random.default_rng(seed)
    first, second = random_ellipses(random, 2), random_ellipses(random, 3)
    second[0] = 3 * first[-1]
    raised = upright_frame(7)
    raised[:, 2, 0] += 10
    surface = pn.conic_surface_of_spans([(upright_frame(10), first, None), (raised, second, None)])
    faces = surface.bsplines(lines)
    left = [face for face in faces if face.u_knots[-1] == 1]
    right = [face for face in faces if face.u_knots[0] == 1]
    for a, b in zip(left, right, strict=True):
        assert np.array_equal(a.poles[-1], b.poles[0])
        assert np.array_equal(a.weights[-1], b.weights[0])
    solid = pnocct.capped_solid(faces)
    assert pnocct.check(solid, boolean=True) == []
    assert surface.certificate_of(lines).deviation < 1e-11


def test_volume_of_an_elliptic_frustum():
    # Half-axes 4 (1 - t / 2) and 2 (1 - t / 2): C = diag(-(2 - t)^2, 1 / 4, 1).
    conic = np.zeros((3, 3, 3))
    conic[:, 0, 0] = -4, -2, -1
    conic[:, 1, 1], conic[:, 2, 2] = 0.25, 1
    surface = pn.conic_surface(upright_frame(10), conic)
    assert surface.degree == (1, 2)
    solid = pnocct.capped_solid(surface.bsplines())
    volume = np.pi * 4 * 2 * 10 * (1 + 1 / 2 + 1 / 4) / 3
    assert pnocct.volume(solid) == pytest.approx(volume, rel=1e-12)


def test_a_cone_to_its_tip():
    conic = np.zeros((3, 3, 3))
    conic[:, 0, 0] = -4, 0, 0  # -4 (1 - t)^2
    conic[:, 1, 1], conic[:, 2, 2] = 0.25, 1
    surface = pn.conic_surface(upright_frame(9), conic)
    solid = pnocct.capped_solid(surface.bsplines())
    assert pnocct.volume(solid) == pytest.approx(np.pi * 4 * 2 * 9 / 3, rel=1e-12)


def test_normals_are_those_of_the_equation():
    # b^2 x^2 + a^2 y^2 = a^2 b^2, a^2 = 4 + 5 t, b^2 = 9 - 3 t.
    conic = np.zeros((3, 3, 3))
    conic[:, 0, 0] = -36, -(4 * 6 + 9 * 9) / 2, -54
    conic[:, 1, 1], conic[:, 2, 2] = (9, 7.5, 6), (4, 6.5, 9)
    surface = pn.conic_surface(upright_frame(10), conic)
    t, v = np.meshgrid(np.linspace(0.1, 0.9, 5), np.linspace(0, 4, 8))
    points, normals = surface.evaluate(t.ravel(), v.ravel())
    for (x, y, z), normal in zip(points, normals, strict=True):
        a, b = 4 + 5 * z / 10, 9 - 3 * z / 10
        gradient = np.array([2 * x / a, 2 * y / b, -((x / a) ** 2) * 0.5 + (y / b) ** 2 * 0.3])
        assert normal @ gradient / np.linalg.norm(gradient) == pytest.approx(1, abs=1e-12)


def test_ellipses_in_turning_planes():
    # Along a helical arc of degree 2 in planes that turn with it.
    random = np.random.default_rng(5)
    frame = np.zeros((3, 4, 3))
    frame[:, :3, 0], frame[:, 3, 0] = [[0, 0, 0], [5, 0, 0], [10, 6, 3]], 1
    frame[:, :3, 1] = [[0, 1, 0], [-0.3, 1, 0], [-1, 1, 0]]
    frame[:, :3, 2] = [[0, 0, 1], [0, 0, 1], [0, -0.5, 1]]
    span = (frame, random_ellipses(random, 2), None)
    surface = pn.conic_surface(*span)
    for face in surface.bsplines():
        for u, x in samples(face, 4, 5):
            t = parameter_of(frame, x, u)
            assert residual(span, t, x) < TIGHT


def designers_arcs(weights):
    """Arcs between two curves, with tangents that meet on a third: y1^2 = k y0 y2 / 4 and y1 > 0."""
    frame = np.zeros((2, 4, 3))
    frame[:, 3] = 1
    frame[:, 0], frame[:, 1], frame[1, 2] = [[-4, 0, 5], [-3, 1, 6]], [[0, 4, 0], [0, 6, 1]], 10
    conic = np.zeros((len(weights), 3, 3))
    conic[:, 1, 1], conic[:, 0, 2] = 1, -np.array(weights) / 8
    conic[:, 2, 0] = conic[:, 0, 2]
    return frame, conic, np.array([[0.0, 1, 0]])


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
@pytest.mark.parametrize("weights", [[1, 1], [1, 4], [1, 4, 16], [0.25, 2, 9], [2, 3, 7], [8, 40]])
def test_rational_ends_are_sides_of_the_face(weights, lines):
    span = designers_arcs(weights)
    surface = pn.conic_surface(*span)
    for face in surface.bsplines(lines):
        assert face.trims == []
        for u, x in samples(face, 4, 5):
            t = x[2] / 10
            assert residual(span, t, x) < TIGHT
            assert beyond_cut(span, t, x) > -1e-14
        for u in np.linspace(0, 1, 5):
            ends = [surface_point(face, u, v) for v in (0, 1)]
            t = ends[0][2] / 10
            low, high = sorted(ends, key=lambda x: x[0])
            assert max(abs(low - [t - 4, 0, 10 * t])) < 1e-14
            assert max(abs(high - [5 + t, t, 10 * t])) < 1e-14
    assert surface.certificate_of(lines).trim_deviation == 0


# k of random_arcs: ellipses, parabolas at the start, hyperbolas, and from ellipses to hyperbolas.
KINDS = {
    "ellipses": (0.5, 0.75),
    "parabolas": (0, 0.25),
    "hyperbolas": (-0.5, -0.25),
    "all": (0.5, -0.5),
}


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
@pytest.mark.parametrize("degree", [1, 2, 3])
@pytest.mark.parametrize("kinds", KINDS)
@pytest.mark.parametrize("seed", range(2))
def test_arcs_lie_on_their_conics_and_end_on_their_cuts(seed, kinds, degree, lines):
    span = (upright_frame(4), *random_arcs(np.random.default_rng(seed), degree, KINDS[kinds]))
    surface = pn.conic_surface(*span)
    certificate = surface.certificate_of(lines)
    assert certificate.deviation < 1e-12 and certificate.trim_deviation < 1e-11
    faces = surface.bsplines(lines)
    for face in faces:
        for _, x in samples(face, 4, 5):
            assert residual(span, x[2] / 4, x) < TIGHT
        ((low, right, high, left),) = face.trims
        for edge in low, high:
            for u, v in edge.poles[:: len(edge.poles) - 1]:
                x = surface_point(face, u, v)
                assert abs(beyond_cut(span, x[2] / 4, x)) < 1e-11
        middle = (low.poles[0] + high.poles[-1]) / 2
        x = surface_point(face, *middle)
        assert beyond_cut(span, x[2] / 4, x) > 0
    assert pnocct.check(pnocct.shell(faces), boolean=True) == []


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
@pytest.mark.parametrize("seed", range(3))
def test_neighbouring_arcs_hang_together(seed, lines):
    random = np.random.default_rng(seed)
    first, second = random_arcs(random, 2, (0.5, 0)), random_arcs(random, 2, (0, -0.5))
    # The same conic with the same side of its cut, of other size.
    second[0][0], second[1][0] = 3 * first[0][-1], 2 * first[1][-1]
    raised = upright_frame(7)
    raised[:, 2, 0] += 4
    spans = [(upright_frame(4), *first), (raised, *second)]
    faces = pn.conic_surface_of_spans(spans).bsplines(lines)
    shell = pnocct.shell(faces)
    assert shell.splitlines().count("Sh") == 1
    assert pnocct.check(shell, boolean=True) == []
    shifted = second[1] * np.array([1.25, 1, 1])
    refused("gap", lambda: pn.conic_surface_of_spans([spans[0], (raised, second[0], shifted)]))
    ellipses = random_arcs(random, 1, (0.5, 0.5))
    opposite = ellipses[0], -ellipses[1]
    refused(
        "gap",
        lambda: pn.conic_surface_of_spans(
            [(upright_frame(4), *[part[::-1] for part in ellipses]), (raised, *opposite)]
        ),
    )


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
def test_sectors_of_circles_have_known_areas(lines):
    # Arcs of 90, 180 and 300 degrees of circles of radius 2 over a height of 5.
    circle = np.diag([-4.0, 1, 1])[None]
    for cut, angle in ([-np.sqrt(2), 0, 1], 90), ([0, 0, 1.0], 180), ([np.sqrt(3), 0, 1], 300):
        surface = pn.conic_surface(upright_frame(5), circle, np.array([cut]))
        shell = pnocct.shell(surface.bsplines(lines))
        assert pnocct.area(shell) == pytest.approx(np.radians(angle) * 2 * 5, rel=1e-12)


def test_a_parabolic_trough_has_the_area_of_its_arc():
    parabola = np.zeros((1, 3, 3))
    parabola[0, 1, 1], parabola[0, 0, 2], parabola[0, 2, 0] = 1, -0.5, -0.5
    surface = pn.conic_surface(upright_frame(3), parabola, np.array([[1.0, 0, -1]]))
    length = np.sqrt(5) + np.arcsinh(2) / 2  # of y = x^2, -1 < x < 1
    assert pnocct.area(pnocct.shell(surface.bsplines())) == pytest.approx(3 * length, rel=1e-12)


def test_what_crosses_itself_is_found():
    # In the normal planes of a parabola, beyond its radius of curvature, 1/2.
    frame = np.zeros((3, 4, 3))
    frame[:, :2, 0], frame[:, 3, 0] = [[-1, 1], [0, -1], [1, 1]], 1
    frame[:, :2, 1] = [[-2, -1], [0, -1], [2, -1]]
    frame[:, 2, 2] = 1
    crossing = pn.conic_surface(frame, np.diag([-1.0, 1, 1])[None]).self_intersection()
    assert crossing.point[0] == pytest.approx(0, abs=1e-9)


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
        for v in np.linspace(0, 4, 9):
            x, y, z = np.array(surface_point(face, 0.5, v), dtype=float)
            assert (np.hypot(x, y), z) == pytest.approx((2, 0.5), abs=1e-12)


def test_a_conic_surface_says_what_it_is():
    surface = pn.conic_surface(upright_frame(1), np.diag([-1.0, 1, 1])[None])
    assert not surface.has_offsets
    assert surface.regular_range == (0, 0)
    assert surface.certificate.exact and surface.certificate.notes == []


def test_refusals_say_why():
    frame = upright_frame(1)
    circle = np.diag([-1.0, 1, 1])
    refused("wrong_shape", lambda: pn.conic_surface(frame[:, :3], circle[None]))
    refused("wrong_shape", lambda: pn.conic_surface(frame, circle))
    refused("wrong_shape", lambda: pn.conic_surface(frame, (circle + np.eye(3, k=1))[None]))
    refused("wrong_shape", lambda: pn.conic_surface_of_spans([]))
    refused("not_finite", lambda: pn.conic_surface(frame, circle[None] * np.nan))
    refused("wrong_shape", lambda: pn.conic_surface_of_tangent_planes(np.eye(4)[None]))
    refused("singular_conics", lambda: pn.conic_surface(frame, np.diag([0.0, 1, 1])[None]))
    refused("no_real_points", lambda: pn.conic_surface(frame, np.array([circle, np.eye(3)])))
    refused("not_rational", lambda: pn.conic_surface(frame, circle[None]).offset(1))
    hyperbola = refused(
        "region_unbounded", lambda: pn.conic_surface(frame, np.array([circle, np.diag([-1.0, 1, -1])]))
    )
    assert "t = 0.5" in hyperbola
    gap = refused("gap", lambda: pn.conic_surface_of_spans([(frame, circle[None], None)] * 2))
    assert "Span 2" in gap


def test_refusals_of_spans_name_the_span():
    frame, circle = upright_frame(1), np.diag([-1.0, 1, 1])[None]
    raised = upright_frame(1)
    raised[:, 2, 0] += 1
    vanishing = np.array([circle[0], np.eye(3)])
    sentence = refused(
        "no_real_points",
        lambda: pn.conic_surface_of_spans([(frame, circle, None), (raised, vanishing, None)]),
    )
    assert sentence.startswith("Span 2: ") and "t > 0.5" in sentence


def test_a_degree_above_25_is_refused():
    # b^2 x^2 + a^2 y^2 = a^2 b^2 with irreducible a^2, b^2 of degree 16, up to small changes.
    random = np.random.default_rng(0)
    a, b = (1 + random.integers(1, 9, 17) / 16 for _ in range(2))
    product = np.polynomial.polynomial.polymul(a, b)
    conic = np.zeros((33, 3, 3))
    for power, entry, sign in ((product, 0, -1), (b, 1, 1), (a, 2, 1)):
        # Powers of t in the basis of Bernstein, exact for these short numbers up to rounding.
        for i, c in enumerate(power):
            for j in range(i, 33):
                conic[j, entry, entry] += sign * c * comb(j, i) / comb(32, i)
    sentence = refused("degree_too_high", lambda: pn.conic_surface(upright_frame(1), conic))
    assert "25" in sentence


def test_conics_in_one_plane_are_noted():
    flat = upright_frame(0)
    circles = np.array([np.diag([-1.0, 1, 1]), np.diag([-4.0, 1, 1])])
    surface = pn.conic_surface(flat, circles)
    (note,) = surface.certificate.notes
    assert "one plane" in note
    # A ring between circles of radius 1 and 2.
    shell = pnocct.shell(surface.bsplines())
    assert pnocct.area(shell) == pytest.approx(3 * np.pi, rel=1e-12)


def test_ellipses_that_are_flat_at_one_end_make_an_edge():
    # Half-axes 1 and t: t^2 x^2 + y^2 = t^2, at t = 0 a segment that is run through twice.
    conic = np.zeros((3, 3, 3))
    conic[2, 0, 0], conic[2, 1, 1], conic[:, 2, 2] = -1, 1, 1
    span = (upright_frame(2), conic, None)
    surface = pn.conic_surface(*span)
    assert surface.degree == (1, 2)
    for face in surface.bsplines():
        for _, x in samples(face, 4, 9):
            if x[2] > 0:
                assert residual(span, x[2] / 2, x) < TIGHT


def test_conics_that_are_lines_at_single_parameters_do_no_harm():
    # A double cone, from one side of its tip to the other: t runs from -1 to 2.
    conic = np.zeros((3, 3, 3))
    conic[:, 0, 0] = -1, 2, -4  # -(3 t - 1)^2
    conic[:, 1, 1] = conic[:, 2, 2] = 1
    span = (upright_frame(3), conic, None)
    surface = pn.conic_surface(*span)
    assert surface.degree == (1, 2)
    for face in surface.bsplines():
        for _, (x, y, z) in samples(face, 7, 7):
            assert abs(x**2 + y**2 - (z - 1) ** 2) < TIGHT


def test_a_frame_that_is_flat_at_single_parameters_may_span_a_regular_conic():
    # Circles of radius 1 in the coordinates (1, xi, y) of the frame (m, (2 t - 1) e_x, e_y).
    frame, conic = upright_frame(4), np.zeros((3, 3, 3))
    frame[:, 0, 1] = -1, 1
    conic[:, 0, 0], conic[:, 1, 1], conic[:, 2, 2] = -1, (1, -1, 1), 1
    surface = pn.conic_surface(frame, conic)
    assert surface.degree == (1, 2)
    for face in surface.bsplines():
        for _, (x, y, _) in samples(face, 3, 9):
            assert abs(x**2 + y**2 - 1) < TIGHT
    sentence = refused(
        "singular_conics", lambda: pn.conic_surface(frame, conic, np.array([[0, 0, 1.0]]))
    )
    assert "t = 0.5" in sentence
    frame[:, :, 2] = frame[:, :, 1]
    refused("singular_conics", lambda: pn.conic_surface(frame, conic))
