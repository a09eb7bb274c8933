# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes of rational families of spheres against their definition and printed formulas."""

import numpy as np
import pnkernel as pn
import pytest
from numpy.polynomial import polynomial
from test_errors import refused

ZERO, ONE = [[0, 0], [0, 0]], [[1, 0], [0, 0]]
U, V = [[0, 0], [1, 0]], [[0, 1], [0, 0]]
AWAY_FROM_SINGULAR = ((0.25, 0.5), (0.375, 0.75))


def ln_type_1():
    """Lines that join (1, 0, u, 0) and (0, 1, 0, -v), with u^2/2 and v^2/2."""
    minus_v = [[0, -1], [0, 0]]
    a, b = [[0], [0], [0.5]], [[0, 0, 0.5]]
    return pn.sphere_family_from_net([ONE, ZERO, U, ZERO], [ZERO, ONE, ZERO, minus_v], a, b)


def plate():
    """Six spheres: nearly flat, of varying thickness, in millimetres."""
    x, y = [[0, 0, 0.5], [40, 3, 0], [2, 0, 0]], [[1, 50, -1], [0, 2, 0], [0.25, 0, 0]]
    z, r = [[0, 2, 4], [1, -1.5, 0], [5, 0, 0]], [[3, 0.5, 0.25], [-0.5, 0.125, 0], [0.5, 0, 0]]
    return [np.array(c) for c in (x, y, z, r)]


def samples(bounds, count=5):
    (p0, p1), (q0, q1) = bounds
    t, u = np.meshgrid(np.linspace(0, 1, count), np.linspace(0, 1, count))
    return t.ravel(), u.ravel(), (p0 + (p1 - p0) * t).ravel(), (q0 + (q1 - q0) * u).ravel()


def check_touches_spheres(family, sheet, bounds, scale):
    """|x - m| = r, and n is normal to the family, by differences of the spheres."""
    surface = family.skin(sheet, bounds)
    assert len(surface.bsplines()) == 1
    t, u, p, q = samples(bounds)
    points, normals = surface.evaluate(t, u)
    spheres = family.spheres(p, q)
    m, r = spheres[:, :3], spheres[:, 3:]
    assert np.allclose(points, m + r * normals, rtol=0, atol=1e-11 * scale)
    step = 1e-5
    for dp, dq in ((step, 0), (0, step)):
        change = family.spheres(p + dp, q + dq) - family.spheres(p - dp, q - dq)
        change /= np.abs(change).max()
        along = np.einsum("ij,ij->i", change[:, :3], normals) + change[:, 3]
        assert np.abs(along).max() < 1e-7


@pytest.mark.parametrize("sheet", [0, 1])
def test_sheets_of_a_net_touch_the_spheres(sheet):
    family = ln_type_1()
    assert family.is_over_normals
    check_touches_spheres(family, sheet, AWAY_FROM_SINGULAR, 10)


def test_the_first_sheet_is_over_its_stereographic_normals():
    t, u, p, q = samples(AWAY_FROM_SINGULAR)
    _, normals = ln_type_1().skin(0, AWAY_FROM_SINGULAR).evaluate(t, u)
    assert np.allclose(normals[:, 0] / (1 + normals[:, 2]), p, rtol=0, atol=1e-13)
    assert np.allclose(normals[:, 1] / (1 + normals[:, 2]), q, rtol=0, atol=1e-13)


def test_a_net_has_the_printed_spheres():
    s, t = np.array([0.25, 0.3]), np.array([0.5, 0.7])
    square = s * s + t * t
    # <w, f_u> = 0 for f = (-u^2/2, -v^2/2, u, v): 2 s u = 1 - s^2 - t^2, 2 t v = -1 - s^2 - t^2.
    u, v = (1 - square) / (2 * s), -(1 + square) / (2 * t)
    expected = np.column_stack([-u * u / 2, -v * v / 2, u, -v])
    assert np.allclose(ln_type_1().spheres(s, t), expected, rtol=1e-14, atol=0)
    assert np.allclose(ln_type_1().parameters(s, t), np.column_stack([u, v]), rtol=1e-14, atol=0)


def test_the_normals_of_a_plate_satisfy_its_equations():
    spheres = plate()
    family = pn.sphere_family_from_surface(spheres[:3], spheres[3])
    bounds = ((-0.0625, 0.0625), (-0.03125, 0.09375))
    t, around, s, q = samples(bounds)
    points, normals = family.skin(0, bounds).evaluate(t, around)
    u, v = family.parameters(s, q).T
    x, y, z, r = (polynomial.polyval2d(u, v, c) for c in spheres)
    assert np.allclose(points, np.column_stack([x, y, z]) + r[:, None] * normals, rtol=1e-12)
    for axis in (0, 1):
        by = [polynomial.polyval2d(u, v, polynomial.polyder(c, axis=axis)) for c in spheres]
        size = np.abs(by).max()
        assert np.abs(np.einsum("ji,ij->i", by[:3], normals) + by[3]).max() < 1e-12 * size


def test_support_functions_may_be_rational():
    minus_v = [[0, -1], [0, 0]]
    a, b = [[0], [-1], [0], [1]], (ONE, V)  # u^3 - u and 1/v
    family = pn.sphere_family_from_net([ONE, ZERO, U, ZERO], [ZERO, ONE, ZERO, minus_v], a, b)
    s, t = np.array([0.25]), np.array([0.5])
    u, v = family.parameters(s, t).T
    # f = (a - u a', b - v b', a', b'), and the radius is -f4.
    expected = np.column_stack([-2 * u**3, 2 / v, 3 * u * u - 1, 1 / v**2])
    assert np.allclose(family.spheres(s, t), expected, rtol=1e-14, atol=0)
    check_touches_spheres(family, 0, ((0.25, 0.375), (0.5, 0.625)), 100)


def test_six_spheres_have_the_same_skin_as_a_triangular_family():
    spheres = plate()
    family = pn.sphere_family_from_surface(spheres[:3], spheres[3])
    value = lambda u, v: np.array([polynomial.polyval2d(u, v, c) for c in spheres])  # noqa: E731
    corners = {"200": (1, 0), "020": (0, 1), "002": (0, 0)}
    net = {name: value(*place) for name, place in corners.items()}
    for name, (first, second) in {
        "110": ("200", "020"),
        "101": ("200", "002"),
        "011": ("020", "002"),
    }.items():
        middle = value(*(np.add(corners[first], corners[second]) / 2))
        net[name] = 2 * middle - (net[first] + net[second]) / 2
    control = [net[name] for name in ("200", "110", "020", "101", "011", "002")]
    inside = pn.sphere_family(control)
    for skin in inside.skins:
        (face,) = skin.bsplines()
        corner = np.mean(face.trims[0][0].poles, axis=0)
        point, normal = (x[0] for x in skin.evaluate([corner[0]], [corner[1]]))
        s, t = normal[0] / (1 + normal[2]), normal[1] / (1 + normal[2])
        same = family.skin(0, ((s - 1e-3, s + 1e-3), (t - 1e-3, t + 1e-3)))
        points, normals = same.evaluate([0.5], [0.5])
        assert np.allclose(points[0], point, rtol=0, atol=1e-8)
        assert np.allclose(normals[0], normal, rtol=0, atol=1e-10)


@pytest.mark.parametrize("sheet", [0, 1])
def test_normals_that_are_rational_keep_the_parameters(sheet):
    uv = [[0, 0], [0, 0.5]]
    family = pn.sphere_family_from_surface([U, V, uv], np.negative(uv))
    assert not family.is_over_normals
    p, q = np.array([0.2, -0.5]), np.array([0.75, 0.1])
    assert np.allclose(family.spheres(p, q), np.column_stack([p, q, p * q / 2, -p * q / 2]))
    check_touches_spheres(family, sheet, ((-0.5, 0.5), (-0.25, 0.75)), 1)


def test_offsets_are_parallel_within_the_certified_range():
    surface = ln_type_1().skin(0, AWAY_FROM_SINGULAR)
    lower, upper = surface.regular_range
    assert lower < 0 < upper
    t, u, _, _ = samples(AWAY_FROM_SINGULAR)
    points, normals = surface.evaluate(t, u)
    distance = min(upper, 1) / 2
    moved, same = surface.offset(distance).evaluate(t, u)
    assert np.allclose(moved, points + distance * normals, rtol=0, atol=1e-12)
    assert np.allclose(same, normals, rtol=0, atol=1e-12)
    assert surface.certificate.deviation < 1e-12


def test_bad_families_are_refused():
    surface, net = pn.sphere_family_from_surface, pn.sphere_family_from_net
    uv, cubic = [[0, 0], [0, 1]], [[0, 0, 1], [0, 0, 0], [0, 0, 0], [0, 1, 0]]
    refused("not_finite", lambda: surface([U, V, [[np.nan]]], ONE))
    refused("wrong_shape", lambda: surface([U, V, [0, 1]], ONE))
    refused("wrong_shape", lambda: surface([U, V, (ONE, ZERO)], ONE))
    refused("zero_length", lambda: surface([U, U, U], V))
    assert "not rational" in refused("not_rational", lambda: surface([U, V, cubic], uv))
    lines = [ONE, ZERO, U, ZERO], [ZERO, ONE, ZERO, V]
    assert "do not fit" in refused("not_rational", lambda: net(*lines, uv, V))
    refused("bad_bounds", lambda: ln_type_1().skin(0, ((1, 1), (0, 1))))
    refused("not_finite", lambda: ln_type_1().skin(0, ((0, np.inf), (0, 1))))
    refused("wrong_shape", lambda: ln_type_1().spheres([0.5], [0.5, 0.25]))
    # Where s t = 0 the sphere that touches lies at infinity.
    refused("weights_not_positive", lambda: ln_type_1().skin(0, ((-1, 1), (-1, 1))).bsplines())
    with pytest.raises(ValueError, match="sheet"):
        ln_type_1().skin(2, AWAY_FROM_SINGULAR)
