# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving conic sections against their definition at 60 digits."""

import numpy as np
import pnkernel as pn
import pytest
from mpmath import mpf
from splines import Spline, norm, surface_point
from test_errors import refused

CUBIC = Spline.bezier([[0, 0, 0], [40, 5, 0], [70, 40, 10], [80, 90, 5]])
LINE = pn.Curve.bezier([[0, 0, 0], [0, 0, 100]])


def foot(point, spine, near):
    """The parameter of the section through a point, (x - m).m' = 0, by Newton's method."""
    t = mpf(near)
    for _ in range(60):
        m, m1, m2 = spine.derivatives(t, 0)
        step = ((point - m) @ m1) / ((point - m) @ m2 - m1 @ m1)
        t -= step
        if abs(step) < mpf(10) ** -40:
            return t
    raise ArithmeticError(f"no section near parameter {near}")


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
def test_points_are_on_the_ellipses_of_their_sections(lines):
    up = np.array([mpf(x) for x in (0.1, 0.2, 1)])
    widths, heights = (12, 20, 8), (6, 9)
    surface = pn.moving_conic_section(
        pn.Curve.bspline(*CUBIC.arguments),
        up=(0.1, 0.2, 1),
        half_axes=(pn.Law.bezier(widths), pn.Law.bezier(heights)),
    )
    assert surface.degree == (9, 2)
    deviation = surface.certificate_of(lines).deviation
    assert deviation < 1e-13
    for face in surface.bsplines(lines=lines):
        for u in np.linspace(face.u_knots[0], face.u_knots[-1], 4):
            # The parameter along is that of the spine.
            for v in np.linspace(face.v_knots[0], face.v_knots[-1], 7):
                x = surface_point(face, u, v)
                t = foot(x, CUBIC, u)
                m, tangent, _ = CUBIC.derivatives(t, 0)
                side = np.cross(tangent, up)
                above = np.cross(side, tangent)
                a = widths[0] * (1 - t) ** 2 + 2 * widths[1] * t * (1 - t) + widths[2] * t**2
                b = heights[0] * (1 - t) + heights[1] * t
                p, q = ((x - m) @ axis / norm(axis) for axis in (side, above))
                value = (p / a) ** 2 + (q / b) ** 2 - 1
                slope = 2 * norm(np.array([p / a**2, q / b**2]))
                assert abs(value) / slope <= 2 * deviation


def test_circles_have_the_degree_of_the_canal_surface():
    """Although the directions of the half-axes are parallel at parameters that are not real."""
    spine, radius = pn.Curve.bspline(*CUBIC.arguments), pn.Law.constant(6)
    surface = pn.moving_conic_section(spine, up=(0.1, 0.2, 1), half_axes=(radius, radius))
    assert surface.degree == pn.canal_surface(spine, radius).degree == (5, 2)
    deviation = surface.certificate_of("even").deviation
    for face in surface.bsplines():
        for u in np.linspace(face.u_knots[0], face.u_knots[-1], 4):
            for v in np.linspace(face.v_knots[0], face.v_knots[-1], 7):
                x = surface_point(face, u, v)
                m, *_ = CUBIC.derivatives(foot(x, CUBIC, u), 0)
                assert abs(norm(x - m) - 6) <= deviation < 1e-13


def test_sections_from_the_vertex_change_their_type():
    # From hyperbolas by a parabola to ellipses.
    radius, constant, depth = (10, 14), (-2.5, 0.5), 5
    surface = pn.moving_conic_section(
        LINE,
        up=(0, 1, 0),
        vertex=(pn.Law.bezier(radius), pn.Law.bezier(constant), pn.Law.constant(depth)),
    )
    (face,) = surface.bsplines()
    for u, v in np.random.default_rng(0).uniform(size=(40, 2)):
        u = face.u_knots[0] + u * (face.u_knots[-1] - face.u_knots[0])
        v = face.v_knots[0] + v * (face.v_knots[-1] - face.v_knots[0])
        x, y, z = surface_point(face, u, v)
        t = z / 100
        r = radius[0] * (1 - t) + radius[1] * t
        k = constant[0] * (1 - t) + constant[1] * t
        assert abs(x**2 - 2 * r * y + (1 + k) * y**2) < 1e-10


def test_there_are_no_offsets():
    surface = pn.moving_conic_section(
        LINE, up=(0, 1, 0), half_axes=(pn.Law.constant(2), pn.Law.constant(1))
    )
    assert not surface.has_offsets
    refused("not_rational", lambda: surface.offset(1))


def test_either_half_axes_or_vertex():
    with pytest.raises(ValueError, match="either half_axes or vertex"):
        pn.moving_conic_section(LINE, up=(0, 1, 0))


def test_planes_are_of_one_kind():
    axes = pn.Law.constant(2), pn.Law.constant(1)
    for planes, normal in (("upright", (0, 0, 1)), ("tilted", None)):
        with pytest.raises(ValueError, match="planes must be"):
            pn.moving_conic_section(LINE, up=(0, 1, 0), planes=planes, normal=normal, half_axes=axes)


def test_upright_sections_from_the_vertex_of_a_spine_in_space():
    up = (0.1, 0.2, 1)
    surface = pn.moving_conic_section(
        pn.Curve.bspline(*CUBIC.arguments),
        up=up,
        planes="upright",
        vertex=(pn.Law.constant(8), pn.Law.constant(-1.5), pn.Law.constant(4)),
    )
    deviation = surface.certificate.deviation
    assert deviation < 1e-13
    above = np.array([mpf(x) for x in up])
    above /= norm(above)
    (face,) = surface.bsplines()
    for u in np.linspace(face.u_knots[0], face.u_knots[-1], 4):
        for v in np.linspace(face.v_knots[0], face.v_knots[-1], 5):
            x = surface_point(face, u, v)
            # The parameter along is that of the spine.
            m, tangent, _ = CUBIC.derivatives(mpf(u), 0)
            side = np.cross(tangent, above)
            side /= norm(side)
            p, q = (x - m) @ side, (x - m) @ above
            assert norm(x - m - p * side - q * above) < 1e-12
            value, half_slope = p**2 - 16 * q - 0.5 * q**2, norm(np.array([p, 8 + 0.5 * q]))
            assert abs(value) / (2 * half_slope) <= 2 * deviation


def test_refusals_name_the_place():
    one = pn.Law.constant(1)
    sentence = refused(
        "bad_axis",
        lambda: pn.moving_conic_section(LINE, up=(0, 1, 0), half_axes=(pn.Law.bezier([1, -1]), one)),
    )
    assert "negative at parameters 0.5 to 1" in sentence
    refused("bad_axis", lambda: pn.moving_conic_section(LINE, up=(0, 0, 1), half_axes=(one, one)))
    sentence = refused(
        "not_rational",
        lambda: pn.moving_conic_section(
            pn.Curve.bspline(*CUBIC.arguments), up=(0, 0, 1), vertex=(one, pn.Law.constant(-1), one)
        ),
    )
    assert "parallel sections" in sentence
