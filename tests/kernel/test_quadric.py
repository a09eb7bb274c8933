# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quadrics and their offsets against the definition: implicit equations and normals at 60 digits."""

import mpmath
import numpy as np
import pnkernel as pn
import pnocct
import pytest
from canal import face_parameters
from mpmath import mpf
from quadrics import Quadric, bounded_kinds, quadric, support
from splines import exactly, surface_point
from test_errors import refused

TIGHTNESS = 1e-6  # of the size: the limits stay behind the true ones by no more
REVOLUTION = [
    ("ellipsoid", 3, 3, 1, None),
    ("ellipsoid", 1, 1, 3, None),
    ("ellipsoid", 3, 1, 1, None),
    ("ellipsoid", 2, 2, 2, None),
    ("two_sheet_hyperboloid", 2, 2, 1, {"z": (0.5, 3)}),
    ("elliptic_paraboloid", 2, 2, 1, {"z": (-1, 3)}),
    ("one_sheet_hyperboloid", 2, 2, 3, {"z": (-1, 1)}),
]


def deviations(surface, definition, count=6):
    """How far exported points are from the surface at this distance, in mm."""
    random = np.random.default_rng(0)
    for face in surface.bsplines():
        for u, v in face_parameters(face, random, count):
            point = surface_point(face, u, v)
            yield abs(definition.contact(point, surface.distance)[1] - surface.distance)


def assert_certified(surface, definition, size):
    certificate = surface.certificate
    assert certificate.exact
    assert max(deviations(surface, definition)) <= certificate.deviation
    assert certificate.deviation <= 1e-12 * (size + abs(surface.distance))


@pytest.mark.parametrize("offset", [0.0, 0.25, -0.125])
@pytest.mark.parametrize("case", [*bounded_kinds(), *REVOLUTION], ids=str)
def test_points_lie_at_their_distance(case, offset):
    surface, definition = quadric(*case)
    assert_certified(surface.offset(offset), definition, 5)


def samples(surface, count=40):
    """Points and normals of the last face."""
    face = surface.bsplines()[-1]
    random = np.random.default_rng(1)
    return surface.evaluate(
        random.uniform(face.u_knots[0], face.u_knots[-1], count),
        random.uniform(face.v_knots[0], face.v_knots[-1], count),
    )


@pytest.mark.parametrize("case", bounded_kinds(), ids=lambda case: case[0])
def test_normals_and_their_side(case):
    surface, definition = quadric(*case)
    points, normals = samples(surface)
    for point, normal in zip(points, normals, strict=True):
        expected = definition.normal(exactly(point)).astype(float)
        np.testing.assert_allclose(normal, expected, rtol=0, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, rtol=0, atol=1e-14)
    moved, same = samples(surface.offset(0.25))
    np.testing.assert_allclose(moved, points + 0.25 * normals, rtol=0, atol=1e-13)
    np.testing.assert_allclose(same, normals, rtol=0, atol=1e-14)


def test_sides_in_words():
    (point,), (normal,) = (x[:1] for x in samples(pn.quadric("ellipsoid", 3, 2, 1)))
    assert point @ normal > 0
    for kind in ("one_sheet_hyperboloid", "elliptic_cylinder", "elliptic_cone"):
        surface = pn.quadric(kind, 2, 2, 3, {"z": (1, 2)})
        points, normals = samples(surface)
        assert ((points * normals)[:, :2].sum(axis=1) > 0).all()
    for kind in ("two_sheet_hyperboloid", "elliptic_paraboloid", "parabolic_cylinder"):
        points, normals = samples(pn.quadric(kind, 3, 2, 1, {"x": (-1, 1), "y": (-1, 1)}))
        assert (normals[:, 2] < 0).all() and (points[:, 2] >= 0).all()
    _, normals = samples(pn.quadric("hyperbolic_paraboloid", 3, 2, 1, {"x": (-1, 1), "y": (-1, 1)}))
    assert (normals[:, 2] > 0).all()


def test_support_function_of_an_ellipsoid():
    # h^2 = n.diag(a^2, b^2, c^2) n, for the offset h + d.
    for half_axes in ((3, 2, 1), (1, 5, 4), (2, 2, 7)):
        surface = pn.quadric("ellipsoid", *half_axes)
        for offset in (0.0, 0.5):
            for point, normal in zip(*samples(surface.offset(offset)), strict=True):
                expected = float(support(half_axes, normal)) + offset
                assert normal @ point == pytest.approx(expected, abs=1e-13 * max(half_axes))


@pytest.mark.parametrize(
    ("case", "degree"),
    [
        (("ellipsoid", 3, 2, 1), (8, 4)),
        (("ellipsoid", 3, 3, 1), (8, 2)),
        (("ellipsoid", 3, 1, 1), (8, 2)),
        (("ellipsoid", 2, 2, 2), (2, 2)),
        (("two_sheet_hyperboloid", 3, 2, 1, {"z": (0, 1.2)}), (8, 4)),
        (("two_sheet_hyperboloid", 2, 2, 1, {"z": (0, 3)}), (8, 2)),
        (("elliptic_paraboloid", 3, 2, 1, {"z": (0, 3)}), (6, 4)),
        (("elliptic_paraboloid", 2, 2, 1, {"z": (0, 3)}), (6, 2)),
        (("one_sheet_hyperboloid", 3, 2, 4, {"z": (-1, 1)}), (4, 4)),
        (("hyperbolic_paraboloid", 3, 2, 1, {"x": (-1, 1), "y": (-1, 1)}), (5, 4)),
        (("parabolic_cylinder", 3, 1, 2, {"x": (0, 1), "y": (0, 1)}), (7, 1)),
        (("elliptic_cylinder", 2, 2, 1, {"z": (0, 1)}), (1, 2)),
        (("elliptic_cone", 2, 2, 1, {"z": (1, 2)}), (1, 2)),
    ],
    ids=str,
)
def test_degrees(case, degree):
    surface = pn.quadric(*case)
    assert tuple(surface.degree) == degree
    assert tuple(surface.offset(0.25).degree) == degree


@pytest.mark.parametrize("difference", [1e-3, 1e-6, 1e-9, 1e-12, 4.5e-16])
def test_nearly_equal_axes(difference):
    for half_axes in (
        (3, 3 + 3 * difference, 1),
        (3, 1, 1 + difference),
        (2 + 2 * difference, 2, 2 + difference),
    ):
        surface, definition = quadric("ellipsoid", *half_axes)
        assert_certified(surface.offset(0.25), definition, 3)
    for kind in ("two_sheet_hyperboloid", "elliptic_paraboloid"):
        surface, definition = quadric(kind, 2, 2 + 2 * difference, 1, {"x": (-1, 0.5), "y": (-0.5, 1)})
        assert_certified(surface.offset(0.25), definition, 3)


@pytest.mark.parametrize("size", [1e-6, 1e-3, 1e6])
def test_sizes(size):
    for kind, a, b, c, bounds in bounded_kinds():
        # Of a paraboloid c is a height, at x = a.
        scaled = bounds and {key: (size * low, size * high) for key, (low, high) in bounds.items()}
        surface, definition = quadric(kind, size * a, size * b, size * c, scaled)
        assert_certified(surface.offset(size / 8), definition, 5 * size)


def test_slender_and_flat_ellipsoids():
    for half_axes in ((100, 1, 1), (100, 2, 1), (100, 99, 1), (1, 1, 100)):
        surface, definition = quadric("ellipsoid", *half_axes)
        assert_certified(surface.offset(0.5), definition, 100)


# Regular range --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("case", "lower", "upper"),
    [
        # The radius of curvature b^2/a of the ends of the major axis, c^2/a where c is the shortest.
        (("ellipsoid", 3, 2, 1), -1 / 3, np.inf),
        (("ellipsoid", 2, 2, 2), -2, np.inf),
        # A^2 / C of the vertex, where A is the shorter half-axis of x and y.
        (("two_sheet_hyperboloid", 3, 2, 2.5, {"x": (-1, 1), "y": (-1, 1)}), -4 / 2.5, np.inf),
        (("elliptic_paraboloid", 3, 2, 1, {"x": (-1, 1), "y": (-1, 1)}), -2, np.inf),
        (("hyperbolic_paraboloid", 3, 2, 1, {"x": (-1, 1), "y": (-1, 1)}), -2, 4.5),
        # At the waist: a inwards, c^2 / a outwards.
        (("one_sheet_hyperboloid", 2, 2, 3, {"z": (-1, 1)}), -2, 4.5),
        # a^2 / (2 c) of the vertex.
        (("parabolic_cylinder", 3, 1, 2, {"x": (-1, 1), "y": (0, 1)}), -9 / 4, np.inf),
        (("elliptic_cylinder", 2, 2, 1, {"z": (0, 1)}), -2, np.inf),
        # z sqrt(a^2 + c^2) a / c^2 at the lower end.
        (("elliptic_cone", 2, 2, 1, {"z": (1, 2)}), -2 * np.sqrt(5), np.inf),
    ],
    ids=str,
)
def test_regular_range(case, lower, upper):
    first, last = pn.quadric(*case).regular_range
    assert lower <= first <= lower + TIGHTNESS
    if upper == np.inf:
        assert last == np.inf
    else:
        assert upper - TIGHTNESS <= last <= upper


def test_regular_range_where_a_whole_line_is_sharpest():
    # The equator of an ellipsoid of revolution; there the proof needs room.
    first, last = pn.quadric("ellipsoid", 3, 3, 1).regular_range
    assert -1 / 3 <= first <= -1 / 3 + 1e-4
    assert last == np.inf


def test_regular_range_of_a_region_without_the_sharpest_place():
    # On the equator of an ellipsoid of revolution the sharper radius is c^2 / a; at a height z the
    # meridian has (a^4 z^2 + c^4 r^2)^(3/2) / (a c)^4 with r^2 = a^2 (1 - z^2 / c^2).
    a, c, z = 3.0, 1.0, 0.5
    first, last = pn.quadric("ellipsoid", a, a, c, {"z": (z, 2)}).regular_range
    r = a * np.sqrt(1 - z**2 / c**2)
    radius = (a**4 * z**2 + c**4 * r**2) ** 1.5 / (a * c) ** 4
    assert -radius <= first <= -radius + 1e-3
    assert last == np.inf


# Solids ---------------------------------------------------------------------------------------------


def integrals_over_the_sphere(half_axes, count=160):
    """Area, and the integral of the mean curvature, of an ellipsoid: of (a b c)^2 / h^4 and of h
    over all unit normals; by Gauss in the height and equal steps around."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    angles = np.arange(count) * 2 * np.pi / count
    z, angle = np.meshgrid(nodes, angles, indexing="ij")
    normals = np.stack([np.sqrt(1 - z**2) * np.cos(angle), np.sqrt(1 - z**2) * np.sin(angle), z])
    h = np.sqrt(sum((a * n) ** 2 for a, n in zip(half_axes, normals, strict=True)))
    measure = weights[:, None] * 2 * np.pi / count
    return (np.prod(half_axes) ** 2 / h**4 * measure).sum(), (h * measure).sum()


@pytest.mark.parametrize("half_axes", [(3.0, 2.0, 1.5), (2.0, 2.0, 1.0), (1.5, 1.5, 1.5)])
def test_steiner(half_axes):
    # V(d) = V + d A + d^2 H + d^3 4 pi / 3 with H the integral of the mean curvature.
    area, mean = integrals_over_the_sphere(half_axes)
    surface = pn.quadric("ellipsoid", *half_axes)

    def volume(d):
        return 4 * np.pi / 3 * (np.prod(half_axes) + d**3) + area * d + mean * d**2

    faces = {d: surface.offset(d).bsplines() for d in (-0.25, 0.0, 1.0)}
    assert pnocct.area(pnocct.shell(faces[0.0])) == pytest.approx(area, rel=1e-10)
    for inner, outer in ((-0.25, 0.0), (0.0, 1.0), (-0.25, 1.0)):
        solid = pnocct.thick_solid(faces[inner], faces[outer])
        assert pnocct.check(solid, boolean=True) == []
        assert pnocct.volume(solid) == pytest.approx(volume(outer) - volume(inner), rel=1e-10)


@pytest.mark.parametrize("case", bounded_kinds(), ids=lambda case: case[0])
def test_shells_are_valid_and_pass_through_step(case, tmp_path):
    surface, _ = quadric(*case)
    shell = pnocct.shell(surface.offset(0.125).bsplines())
    assert pnocct.check(shell, boolean=True) == []
    path = tmp_path / "quadric.step"
    pnocct.write_step(path, [shell], [case[0]])
    assert "OFFSET_SURFACE" not in path.read_text()
    (read,) = pnocct.read_step(path)
    assert pnocct.check(read) == []
    assert pnocct.area(read) == pytest.approx(pnocct.area(shell), rel=1e-9)
    for face, original in zip(pnocct.faces(read), surface.offset(0.125).bsplines(), strict=True):
        assert np.array_equal(face.poles, original.poles)


def test_closed_shells_keep_their_volume_in_step(tmp_path):
    surface = pn.quadric("ellipsoid", 3, 2, 1)
    solid = pnocct.thick_solid(surface.bsplines(), surface.offset(0.5).bsplines())
    path = tmp_path / "wall.step"
    pnocct.write_step(path, [solid], ["wall"])
    (read,) = pnocct.read_step(path)
    assert pnocct.volume(read) == pytest.approx(pnocct.volume(solid), rel=1e-12)


# Refusals -------------------------------------------------------------------------------------------


def test_bad_axis():
    for bad in (0, -1):
        assert "half-axis b" in refused("bad_axis", lambda: pn.quadric("ellipsoid", 3, bad, 1))


def test_bad_bounds():
    for bounds in ({"z": (1, 0)}, {"x": (1, 1)}, {"angle": (2, 1)}, {"angle": (0, float("inf"))}):
        refused("bad_bounds", lambda: pn.quadric("ellipsoid", 3, 2, 1, bounds))


def test_region_empty():
    refused("region_empty", lambda: pn.quadric("ellipsoid", 3, 2, 1, {"z": (2, 3)}))
    refused("region_empty", lambda: pn.quadric("elliptic_paraboloid", 3, 2, 1, {"z": (-2, -1)}))
    refused("region_empty", lambda: pn.quadric("two_sheet_hyperboloid", 3, 2, 1, {"z": (-2, 0)}))


@pytest.mark.parametrize("kind", [kind for kind, *_ in bounded_kinds() if kind != "ellipsoid"])
def test_region_unbounded(kind):
    refused("region_unbounded", lambda: pn.quadric(kind, 2, 2, 1))
    refused("region_unbounded", lambda: pn.quadric(kind, 2, 2, 1, {"x": (1, float("inf"))}))


def test_region_unsupported():
    for kind, bounds in (
        ("hyperbolic_paraboloid", {"x": (-1, 1), "y": (-1, 1), "z": (0, 1)}),  # two wedges
        ("one_sheet_hyperboloid", {"z": (0, 1), "angle": (0, 6)}),
        ("parabolic_cylinder", {"x": (-1, 1), "y": (-1, 1), "angle": (0, 1)}),
        ("parabolic_cylinder", {"x": (-1, 1), "y": (-1, 1), "z": (0.125, 1)}),  # two strips
        ("elliptic_cone", {"z": (-1, 1)}),
        ("ellipsoid", {"z": (0, 1e-9)}),
    ):
        refused("region_unsupported", lambda: pn.quadric(kind, 2, 2, 1, bounds))


def test_heights_of_a_parabolic_cylinder_are_widths():
    # z = x^2 / 2: z = 1/8 at x = 1/2.
    for bounds in ({"y": (0, 1), "z": (-1, 0.125)}, {"x": (0, 1), "y": (0, 1), "z": (0.125, 1)}):
        points, _ = samples(pn.quadric("parabolic_cylinder", 2, 1, 2, bounds))
        assert (points[:, 2] >= bounds["z"][0] - 1e-14).all()
        assert (points[:, 2] <= bounds["z"][1] + 1e-14).all()
    refused(
        "region_empty",
        lambda: pn.quadric("parabolic_cylinder", 2, 1, 2, {"x": (-1, 1), "y": (0, 1), "z": (-1, 0)}),
    )


def test_not_rational():
    for kind in ("elliptic_cylinder", "elliptic_cone"):
        assert "elliptic" in refused("not_rational", lambda: pn.quadric(kind, 3, 2, 1, {"z": (1, 2)}))


def test_names():
    with pytest.raises(ValueError, match="no kind of quadric"):
        pn.quadric("banana", 1, 1, 1)
    with pytest.raises(ValueError, match="no bound"):
        pn.quadric("ellipsoid", 1, 1, 1, {"w": (0, 1)})


# One definition, two constructions ------------------------------------------------------------------


def test_sphere():
    surface = pn.quadric("ellipsoid", 2, 2, 2)
    for face in surface.offset(0.5).bsplines():
        for u, v in face_parameters(face, np.random.default_rng(0), 20):
            point = surface_point(face, u, v)
            assert abs(mpmath.sqrt(point @ point) - mpf(2.5)) <= 2 * np.spacing(2.5)


def test_cylinder_and_cone_as_canal_surfaces():
    # r = z a / c on the axis, moved to where the spheres touch: the canal surface of the cone.
    a, c = 3.0, 4.0
    cone = pn.quadric("elliptic_cone", a, a, c, {"z": (4, 8)})
    slope = (a * a + c * c) / c**2
    canal = pn.canal_surface(
        pn.Curve.bezier([[0, 0, 4 * slope], [0, 0, 8 * slope]]),
        pn.Law.bezier([4 * slope * a / 5, 8 * slope * a / 5]),
    )
    definition = Quadric.of("elliptic_cone", a, a, c)
    for surface in (cone, canal):
        assert list(surface.degree) == [1, 2]
        assert_certified(surface.offset(0.25), definition, 20)
    areas = [pnocct.area(pnocct.shell(s.offset(0.25).bsplines())) for s in (cone, canal)]
    assert areas[0] == pytest.approx(areas[1], rel=1e-12)
