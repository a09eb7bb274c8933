# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges of trimmed faces: closed, on the boundary that was asked for, around nothing else."""

import math

import numpy as np
import pnkernel as pn
import pnocct
import pytest
from quadrics import Quadric
from rulings import Cones, random_pair
from splines import surface_point
from trims import area, clearance, is_on_face, points, polygon

TIGHT = 1e-9  # mm: what an edge may lie beside the true boundary, for bodies of some millimetres
ULPS = 1e-14  # the evaluation of a spline in doubles, for parameters up to 4
REGIONS = [
    ("ellipsoid", 3, 2, 1, {"z": (-0.3, 0.6)}),
    ("ellipsoid", 3, 2, 1, {"z": (0, 2)}),
    ("ellipsoid", 3, 2, 1, {"x": (0, 2), "y": (-0.5, 1), "z": (0, 1)}),
    ("ellipsoid", 3, 2, 1, {"x": (0, 1), "y": (-0.5, 0.5), "z": (0, 1)}),
    ("ellipsoid", 3, 2, 1, {"x": (-1.5, 1.5), "y": (-0.8, 0.8)}),
    ("ellipsoid", 3, 2, 1, {"angle": (0.2, 2)}),
    ("ellipsoid", 3, 2, 1, {"angle": (0.2, 5)}),
    ("ellipsoid", 3, 2, 1, {"z": (-0.3, 0.6), "angle": (0.2, 2)}),
    ("ellipsoid", 3, 3, 1, {"z": (-0.3, 0.6), "angle": (0.2, 2)}),
    ("ellipsoid", 2, 2, 2, {"x": (-1, 1), "y": (-1, 1), "z": (0, 2)}),
    ("one_sheet_hyperboloid", 3, 2, 3, {"z": (-1, 2)}),
    ("one_sheet_hyperboloid", 3, 2, 3, {"z": (-1, 2), "angle": (0, 1)}),
    ("two_sheet_hyperboloid", 3, 2, 1, {"z": (0, 1.2)}),
    ("two_sheet_hyperboloid", 3, 2, 1, {"z": (1.1, 1.2)}),
    ("two_sheet_hyperboloid", 3, 2, 1, {"x": (-1, 0.5), "y": (-1, 1)}),
    ("two_sheet_hyperboloid", 3, 1, 2, {"x": (-2.5, 3), "y": (-0.9, 0.9)}),
    ("two_sheet_hyperboloid", 3, 1, 2, {"z": (0, 3)}),
    ("two_sheet_hyperboloid", 3, 1, 2, {"z": (0, 3.5)}),
    ("two_sheet_hyperboloid", 3, 1, 2, {"z": (0, 8)}),
    ("two_sheet_hyperboloid", 3, 1, 2, {"z": (4.5, 5)}),
    ("two_sheet_hyperboloid", 3, 1, 2, {"z": (2, 5), "angle": (-0.5, 2)}),
    ("elliptic_paraboloid", 3, 2, 1, {"z": (-1, 3)}),
    ("elliptic_paraboloid", 3, 2, 1, {"z": (0.5, 2.4)}),
    ("elliptic_paraboloid", 3, 2, 1, {"x": (-1, 1.5), "y": (-1, 1)}),
    ("hyperbolic_paraboloid", 3, 2, 1, {"x": (-1, 1.5), "y": (-1, 1)}),
    ("hyperbolic_paraboloid", 3, 2, 1, {"x": (-1, 1), "y": (-1, 1), "angle": (0, 1)}),
    ("hyperbolic_paraboloid", 3, 2, 1, {"x": (-1, 1.5), "y": (-1, 1), "z": (-0.125, 0.0625)}),
    ("one_sheet_hyperboloid", 3, 2, 3, {"z": (-1, 2), "x": (1, 4)}),
    ("one_sheet_hyperboloid", 3, 2, 3, {"z": (-1, 2), "x": (0, 2), "y": (0.5, 3)}),
    ("elliptic_cylinder", 2, 2, 1, {"z": (-1, 2), "angle": (0.2, 5)}),
    ("elliptic_cylinder", 2, 2, 1, {"z": (-1, 2), "x": (-1, 1.5), "y": (0, 3)}),
    ("elliptic_cone", 2, 2, 3, {"z": (1, 2), "angle": (0.2, 2)}),
    ("elliptic_cone", 2, 2, 3, {"z": (1, 2), "x": (-1, 1)}),
    # The box touches the rim.
    ("elliptic_paraboloid", 3, 2, 1, {"x": (-3, 3), "y": (-2, 2), "z": (-1, 1)}),
]


def excess(bounds, point):
    """How far a point is outside the bounds, in mm; negative inside. The sectors are below pi, or
    what is left out of them is."""
    values = []
    for axis, name in enumerate("xyz"):
        low, high = bounds.get(name, (-math.inf, math.inf))
        values += [low - point[axis], point[axis] - high]
    if "angle" in bounds:
        low, high = bounds["angle"]
        left_of_low = point[1] * math.cos(low) - point[0] * math.sin(low)
        left_of_high = point[1] * math.cos(high) - point[0] * math.sin(high)
        outside = -left_of_low, left_of_high
        values.append(max(outside) if high - low < math.pi else min(outside))
    return max(values)


def base_point(definition, face, distance, place):
    """The point of the base surface under a point of an offset, in doubles."""
    foot, _ = definition.contact(surface_point(face, *place), distance)
    return foot.astype(float)


def is_same_rectangle(face, other):
    """Faces of several parts of a region have their parameters in common."""
    return all(
        np.array_equal(getattr(face, knots), getattr(other, knots)) for knots in ("u_knots", "v_knots")
    )


def assert_closed(face):
    for loop in face.trims:
        for curve, following in zip(loop, [*loop[1:], loop[0]], strict=True):
            assert np.array_equal(curve.poles[-1], following.poles[0])


@pytest.mark.parametrize("case", REGIONS, ids=str)
def test_loops_are_closed_and_run_counterclockwise(case):
    for face in pn.quadric(*case).bsplines():
        assert_closed(face)
        areas = [area(polygon(loop)) for loop in face.trims]
        assert [a > 0 for a in areas] == [True, *[False] * (len(areas) - 1)][: len(areas)]
        for loop in face.trims:
            corners = polygon(loop)
            for axis, knots in enumerate((face.u_knots, face.v_knots)):
                assert knots[0] - ULPS <= corners[:, axis].min()
                assert corners[:, axis].max() <= knots[-1] + ULPS


@pytest.mark.parametrize("offset", [0.0, 0.125])
@pytest.mark.parametrize("case", REGIONS, ids=str)
def test_places_are_inside_the_loops_when_their_points_are_in_the_region(case, offset):
    definition = Quadric.of(*case[:4])
    random = np.random.default_rng(0)
    inside = outside = 0
    faces = pn.quadric(*case).offset(offset).bsplines()
    for face in faces:
        for _ in range(40):
            place = np.array(
                [random.uniform(knots[0], knots[-1]) for knots in (face.u_knots, face.v_knots)]
            )
            beyond = excess(case[4], base_point(definition, face, offset, place))
            parts = [other for other in faces if is_same_rectangle(face, other)]
            if min(clearance(part, place) for part in parts) < 1e-3:
                continue
            assert sum(is_on_face(part, place) for part in parts) == (beyond < 0)
            inside, outside = inside + (beyond < 0), outside + (beyond > 0)
    assert inside > 0


@pytest.mark.parametrize("offset", [0.0, 0.125])
@pytest.mark.parametrize("case", REGIONS, ids=str)
def test_edges_lie_on_the_bounds(case, offset):
    definition = Quadric.of(*case[:4])
    surface = pn.quadric(*case).offset(offset)
    assert surface.certificate.trim_deviation <= TIGHT
    for face in surface.bsplines():
        for loop in face.trims:
            for curve in loop:
                if curve.degree == 1:
                    continue  # a side that two faces share, or a pole
                for place in points(curve, 7):
                    point = base_point(definition, face, offset, place)
                    assert abs(excess(case[4], point)) <= TIGHT


def graph_area(height, slopes, region, count=400):
    """Of a graph over [x0, x1] x [y0, y1], by Gauss."""
    nodes, weights = np.polynomial.legendre.leggauss(count // 4)
    (x0, x1), (y0, y1) = region
    x, y = np.meshgrid((x0 + x1 + (x1 - x0) * nodes) / 2, (y0 + y1 + (y1 - y0) * nodes) / 2)
    p, q = slopes(x, y, height(x, y))
    return (np.sqrt(1 + p * p + q * q) * np.outer(weights, weights)).sum() * (
        (x1 - x0) * (y1 - y0) / 4
    )


@pytest.mark.parametrize("sign", [1, -1])
def test_area_over_a_rectangle_of_paraboloids(sign):
    kind = "elliptic_paraboloid" if sign > 0 else "hyperbolic_paraboloid"
    box = (-1, 1.5), (-1, 1)
    shell = pnocct.shell(pn.quadric(kind, 3, 2, 1, {"x": box[0], "y": box[1]}).bsplines())
    expected = graph_area(lambda x, y: 0, lambda x, y, z: (2 * x / 9, sign * 2 * y / 4), box)
    assert pnocct.area(shell) == pytest.approx(expected, abs=10 * TIGHT)


def test_area_over_a_rectangle_of_a_hyperboloid():
    box = (0.25, 1), (-0.5, 1)
    shell = pnocct.shell(
        pn.quadric("two_sheet_hyperboloid", 3, 2, 2.5, {"x": box[0], "y": box[1]}).bsplines()
    )
    expected = graph_area(
        lambda x, y: 2.5 * np.sqrt(1 + x**2 / 9 + y**2 / 4),
        lambda x, y, z: (2.5**2 * x / (9 * z), 2.5**2 * y / (4 * z)),
        box,
    )
    assert pnocct.area(shell) == pytest.approx(expected, abs=10 * TIGHT)


def test_two_parts_of_an_ellipsoid_are_the_whole():
    whole = pnocct.area(pnocct.shell(pn.quadric("ellipsoid", 3, 2, 1).offset(0.25).bsplines()))
    for one, other in (
        ({"z": (-2, 0.3)}, {"z": (0.3, 2)}),
        ({"x": (-4, 1)}, {"x": (1, 4)}),
        ({"angle": (0.2, 2)}, {"angle": (2, 0.2 + 2 * math.pi)}),
    ):
        parts = (
            pnocct.area(pnocct.shell(pn.quadric("ellipsoid", 3, 2, 1, bounds).offset(0.25).bsplines()))
            for bounds in (one, other)
        )
        assert sum(parts) == pytest.approx(whole, abs=100 * TIGHT)


@pytest.mark.parametrize("case", REGIONS, ids=str)
def test_shells_of_regions_are_valid(case):
    for offset in (0.0, 0.125):
        faces = pn.quadric(*case).offset(offset).bsplines()
        shell = pnocct.shell(faces)
        assert pnocct.check(shell, boolean=True) == []
        assert pnocct.trim_deviation(shell) <= TIGHT


@pytest.mark.parametrize("offset", [0.0, 0.125])
def test_a_region_of_two_parts_is_a_compound_of_two_shells(offset):
    region = {"x": (0, 1), "y": (-0.5, 0.5)}
    faces = pn.quadric("ellipsoid", 3, 2, 1, region).offset(offset).bsplines()
    assert [len(face.trims) for face in faces] == [1, 1]
    shells = [pnocct.shell([face]) for face in faces]
    both = pnocct.shell(faces)
    assert both.splitlines().count("Sh") == 2
    assert pnocct.check(both, boolean=True) == []
    areas = [pnocct.area(shell) for shell in shells]
    assert areas[0] == pytest.approx(areas[1], abs=TIGHT)
    assert pnocct.area(both) == pytest.approx(sum(areas), abs=TIGHT)


# Bands of ruled surfaces ----------------------------------------------------------------------------


@pytest.mark.parametrize("offset", [0.0, 0.5])
@pytest.mark.parametrize(("seed", "degree", "spans"), [(0, 1, 1), (1, 2, 1), (2, 3, 1), (0, 3, 3)])
def test_bands_end_at_their_directrices(seed, degree, spans, offset):
    cones = Cones(random_pair(seed, degree, spans, noise=0.5))
    surface = cones.surface().offset(offset)
    assert surface.certificate.trim_deviation <= TIGHT
    random = np.random.default_rng(0)
    for face in surface.bsplines():
        assert_closed(face)
        (loop,) = face.trims
        assert area(polygon(loop)) > 0

        def across(place):
            """v on the ruling under a place, and its length."""
            point = surface_point(face, *place)
            span = cones.centres[0].span_at(place[0])
            t, v, _ = cones.contact(point, offset, place[0], span)
            assert abs(t - place[0]) < 1e-12
            return float(v), float(np.linalg.norm(cones.spheres(t, v, span)[0][2].astype(float)))

        ends = set()
        for curve in loop:
            if curve.degree == 1:
                assert curve.poles[0][0] == curve.poles[-1][0]  # along a ruling
                continue
            for place in points(curve, 7)[1:-1]:
                v, length = across(place)
                ends.add(round(v))
                assert abs(v - round(v)) * length <= TIGHT
        assert ends == {0, 1}
        for _ in range(30):
            place = np.array([random.uniform(face.u_knots[0], face.u_knots[-1]), random.uniform(0, 1)])
            if clearance(face, place) > 1e-3:
                v, _ = across(place)
                assert is_on_face(face, place) == (0 < v < 1)


def test_neighbours_in_a_band_share_their_rulings():
    cones = Cones(random_pair(2, 2, 3, noise=0.5))
    for offset in (0.0, 0.5):
        shell = pnocct.shell(cones.surface().offset(offset).bsplines())
        assert pnocct.check(shell, boolean=True) == []
        assert pnocct.trim_deviation(shell) <= TIGHT
