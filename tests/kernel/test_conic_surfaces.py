# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces of moving ellipses against their equation."""

import numpy as np
import pnkernel as pn
import pnocct
import pytest
from conics import parameter_of, random_ellipses, residual, upright_frame
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
    surface = pn.conic_surface_of_spans(
        [(upright_frame(10), first, None), (raised, second, None)]
    )
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
        gradient = np.array([2 * x / a, 2 * y / b, -(x / a) ** 2 * 0.5 + (y / b) ** 2 * 0.3])
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
        "region_unbounded",
        lambda: pn.conic_surface(frame, np.array([circle, np.diag([-1.0, 1, -1])])),
    )
    assert "t = 0.5" in hyperbola
    gap = refused(
        "gap", lambda: pn.conic_surface_of_spans([(frame, circle[None], None)] * 2)
    )
    assert "Span 2" in gap
