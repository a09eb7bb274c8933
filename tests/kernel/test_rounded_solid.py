# SPDX-License-Identifier: LGPL-2.1-or-later
"""The closed solid of six spheres: valid, of the right volume, smooth, whole after Booleans."""

import itertools

import numpy as np
import pnkernel as pn
import pnocct
import pytest
from sphere_families import random_spheres
from test_errors import refused
from trims import points_and_normals

STEP = 1e-5  # central differences: 1e-10 of what is integrated


def dome(seed, **shape):
    return random_spheres(np.random.default_rng(seed), dome=True, **shape)


class Envelope:
    """The boundary of the union of balls in doubles, by its definition."""

    def __init__(self, spheres):
        b200, b110, b020, b101, b011, b002 = spheres
        self.power = (
            2 * (b200 - 2 * b101 + b002),
            2 * (b110 - b101 - b011 + b002),
            2 * (b020 - 2 * b011 + b002),
            2 * (b101 - b002),
            2 * (b011 - b002),
            b002,
        )

    def sphere(self, u, v):
        a1, a2, a3, a4, a5, a6 = self.power
        return (
            a1 * u * u / 2 + a2 * u * v + a3 * v * v / 2 + a4 * u + a5 * v + a6,
            a1 * u + a2 * v + a4,
            a2 * u + a3 * v + a5,
        )

    def normal(self, u, v, sign):
        _, by_u, by_v = self.sphere(u, v)
        tangents = np.array([by_u[:3], by_v[:3]])
        flat = np.linalg.lstsq(tangents, -np.array([by_u[3], by_v[3]]), rcond=None)[0]
        across = np.cross(*tangents)
        return flat + sign * np.sqrt(1 - flat @ flat) * across / np.linalg.norm(across)

    def skin(self, sign, distance):
        def point(s, t):
            u, v = s, (1 - s) * t
            sphere, _, _ = self.sphere(u, v)
            normal = self.normal(u, v, sign)
            return sphere[:3] + (sphere[3] + distance) * normal, normal

        return point

    def arc(self, start, end, t):
        """The circle of contact of an edge at t, from the inner to the outer skin outside."""
        (u, v), step = start + t * (end - start), end - start
        sphere, by_u, by_v = self.sphere(u, v)
        along = step[0] * by_u + step[1] * by_v
        inside = np.array([1 / 3, 1 / 3]) - (u, v)
        inwards = inside[0] * by_u + inside[1] * by_v
        axis = along[:3] / np.linalg.norm(along[:3])
        inner, outer = self.normal(u, v, -1), self.normal(u, v, 1)
        level = (inner @ axis) * axis
        e = (inner - level) / np.linalg.norm(inner - level)
        f = np.cross(axis, e)
        angle = np.arctan2(outer @ f, outer @ e)
        radius = np.linalg.norm(inner - level)

        def normal(part, turn=angle):
            return level + radius * (np.cos(part * turn) * e + np.sin(part * turn) * f)

        if normal(0.5) @ inwards[:3] + inwards[3] > 0:
            angle -= np.copysign(2 * np.pi, angle)
        return sphere, lambda part: normal(part, angle)

    def strip(self, start, end, distance):
        def point(t, s):
            sphere, normal = self.arc(start, end, t)
            return sphere[:3] + (sphere[3] + distance) * normal(s), normal(s)

        return point

    def lune(self, before, corner, after, distance):
        """Between the end circles of two edges: circles through the tips in between."""
        sphere, first = self.arc(before, corner, 1)
        _, second = self.arc(corner, after, 0)
        tips = first(0), first(1)
        middles = [arc(0.5) - (tips[0] + tips[1]) / 2 for arc in (first, second)]

        def point(y, x):
            # On the plane through both tips and a point between the middles of the circles.
            outwards = (1 - y) * middles[0] + y * middles[1]
            normal = np.cross(tips[1] - tips[0], outwards)
            normal /= np.linalg.norm(normal)
            centre = (normal @ tips[0]) * normal
            e = tips[0] - centre
            f = np.cross(normal, e)
            to = tips[1] - centre
            angle = np.arctan2(to @ f, to @ e)
            if (np.cos(angle / 2) * e + np.sin(angle / 2) * f) @ outwards < 0:
                angle -= np.copysign(2 * np.pi, angle)
            n = centre + np.cos(x * angle) * e + np.sin(x * angle) * f
            return sphere[:3] + (sphere[3] + distance) * n, n

        return point


def flux(point, nodes):
    """The integral of x.n / 3 over a part, by Gauss: its share of the volume."""
    places, weights = np.polynomial.legendre.leggauss(nodes)
    total = 0
    for (s, p), (t, q) in itertools.product(zip((places + 1) / 2, weights / 2, strict=True), repeat=2):
        x, n = point(s, t)
        by_s = (point(s + STEP, t)[0] - point(s - STEP, t)[0]) / (2 * STEP)
        by_t = (point(s, t + STEP)[0] - point(s, t - STEP)[0]) / (2 * STEP)
        total += p * q * np.linalg.norm(np.cross(by_s, by_t)) * (x @ n) / 3
    return total


def defined_volume(spheres, distance, nodes=24):
    envelope = Envelope(spheres)
    corners = np.array([[0.0, 0], [1, 0], [0, 1]])
    parts = [envelope.skin(1, distance), envelope.skin(-1, distance)]
    for k in range(3):
        start, end, after = corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]
        parts += [envelope.strip(start, end, distance), envelope.lune(start, end, after, distance)]
    return sum(flux(part, nodes) for part in parts)


@pytest.mark.parametrize("seed", range(4))
def test_the_solid_is_valid_with_one_edge_for_every_seam(seed):
    surface = pn.sphere_family(dome(seed)).solid(0.5)
    faces = surface.bsplines()
    assert len(faces) == 8
    certificate = surface.certificate
    assert certificate.exact
    assert certificate.deviation < 1e-11
    assert certificate.trim_deviation < 1e-9
    brep = pnocct.capped_solid(faces)
    assert pnocct.check(brep, boolean=True) == []
    assert pnocct.trim_deviation(brep) < 3e-9


@pytest.mark.parametrize("seed", range(2))
def test_its_volume_is_that_of_the_definition(seed):
    spheres = dome(seed)
    brep = pnocct.capped_solid(pn.sphere_family(spheres).solid(1).bsplines())
    value, error = pnocct.measured_volume(brep)
    assert abs(value - defined_volume(spheres, 1)) < 1e-8 * value + error


def test_the_volume_is_a_cubic_in_the_distance():
    solid = pn.sphere_family(dome(5)).solid()
    distances = np.array([-1, 0, 1, 2, 3, 4.0])
    volumes = [pnocct.volume(pnocct.capped_solid(solid.offset(d).bsplines())) for d in distances]
    cubic = np.polynomial.Polynomial.fit(distances, volumes, 3).convert()
    assert np.abs(cubic(distances) - volumes).max() < 1e-8 * max(volumes)
    assert abs(cubic.coef[3] - 4 * np.pi / 3) < 1e-6


@pytest.mark.parametrize("seed", range(3))
def test_neighbours_share_points_and_normals(seed):
    """Every edge lies on two faces, with the same normals: the surface is smooth."""
    surface = pn.sphere_family(dome(seed)).solid()
    edges = []
    for i, face in enumerate(surface.bsplines()):
        for curve in face.trims[0]:
            if curve.degree == 1:
                continue  # the tip of a lune
            edges.append(points_and_normals(surface, i, curve))
    assert len(edges) == 24
    for edge in edges:
        others = [other for other in edges if other is not edge]
        assert min(np.abs(edge - other[::-1]).max() for other in others) < 1e-8


def test_offsets_of_the_solid_are_solids_of_thicker_families():
    spheres = dome(3)
    thicker = spheres.copy()
    thicker[:, 3] += 0.5
    a = pnocct.capped_solid(pn.sphere_family(spheres).solid(0.5).bsplines())
    b = pnocct.capped_solid(pn.sphere_family(thicker).solid().bsplines())
    assert pnocct.volume(a) == pytest.approx(pnocct.volume(b), rel=1e-9)


def test_a_solid_needs_positive_radii():
    spheres = dome(1)
    spheres[2, 3] = 0
    refused("negative_radius", lambda: pn.sphere_family(spheres).solid())
    solid = pn.sphere_family(dome(1)).solid()
    lower, upper = solid.regular_range
    assert lower == pytest.approx(-dome(1)[:, 3].min(), rel=1e-12)
    assert upper > 0
