# SPDX-License-Identifier: LGPL-2.1-or-later
"""Skins over a triangulation against the spline that solves the conditions, and their definition."""

import numpy as np
import pnkernel as pn
import pnocct
import pytest
from powell_sabin import dome, pieces, sphere_at
from sphere_families import Family
from splines import norm, surface_point
from test_errors import refused
from trims import is_on_face, points, polygon

SIGNS = (1, -1)  # the outer skin, then the inner one
TIGHT = 1e-9  # mm


def oracle(data, family):
    """The coefficients (6 m, 6, 4) of all pieces, by the conditions."""
    centres, radii, derivatives, triangles = data
    spheres = np.column_stack([centres, radii])
    _, parts = pieces(centres[:, :2], spheres, derivatives, triangles, family.pieces[0])
    return parts.astype(float)


@pytest.mark.parametrize("seed", range(3))
def test_the_pieces_solve_the_conditions(seed):
    data = dome(2, seed=seed)
    family = pn.sphere_family_powell_sabin(*data)
    expected = oracle(data, family)
    corners, spheres = family.pieces
    assert corners.shape == (48, 3, 2) and spheres.shape == (48, 6, 4)
    random = np.random.default_rng(seed)
    for i, control in enumerate(spheres):
        u, v, w = random.dirichlet([1, 1, 1])
        s, t = np.array([u, v, w]) @ corners[i]
        found, _, _ = Family(control).sphere(u, v)
        value, _, _ = sphere_at(expected[i], s, t)
        assert np.allclose(found, value, rtol=0, atol=1e-9)


@pytest.mark.parametrize("sign", SIGNS)
def test_every_face_is_on_the_envelope_of_its_piece(sign):
    data = dome(2, seed=1)
    family = pn.sphere_family_powell_sabin(*data)
    expected = oracle(data, family)
    surface = family.skins[SIGNS.index(sign)].offset(0.75)
    certificate = surface.certificate
    assert certificate.exact
    assert certificate.deviation < 1e-11
    assert certificate.trim_deviation < TIGHT
    faces = surface.bsplines()
    assert len(faces) == 48  # one for every piece, so faces and pieces are in one order
    random = np.random.default_rng(2)
    for i, face in enumerate(faces):
        corners = polygon(face.trims[0])
        place = random.uniform(corners.min(axis=0), corners.max(axis=0))
        while not is_on_face(face, place):
            place = random.uniform(corners.min(axis=0), corners.max(axis=0))
        (point,), (normal,) = surface.evaluate([place[0]], [place[1]])
        assert norm(np.array(surface_point(face, *place), dtype=float) - point) < TIGHT
        # The sphere that touches here has its centre at m = x - (r + d) n: (s, t) are its x and y.
        s, t = point[:2] - 3.75 * normal[:2]
        for _ in range(20):
            sphere, _, _ = sphere_at(expected[i], s, t)
            s, t = point[:2] - (sphere[3] + 0.75) * normal[:2]
        sphere, by_s, by_t = sphere_at(expected[i], s, t)
        assert norm(sphere[:3] + (sphere[3] + 0.75) * normal - point) < TIGHT
        assert abs(normal @ by_s[:3] + by_s[3]) < TIGHT
        assert abs(normal @ by_t[:3] + by_t[3]) < TIGHT
        assert sign * (normal @ np.cross(by_s[:3], by_t[:3])) > 0


def test_skins_are_valid_shells_without_gaps():
    """One shell each, with every inner edge on two faces; Boolean operations take it."""
    data = dome(2, seed=3)
    for surface in pn.sphere_family_powell_sabin(*data).skins:
        brep = pnocct.shell(surface.bsplines())
        assert pnocct.check(brep, boolean=True) == []
        assert pnocct.trim_deviation(brep) < 3e-9
        assert brep.count("\nSh\n") == 1
        # 8 triangles of six parts: (48 * 3 + 16) / 2 edges, if 16 halves of edges are the border.
        assert brep.count("\nEd\n") == 80


@pytest.mark.parametrize("seed", range(2))
def test_skins_are_smooth_across_edges(seed):
    for surface in pn.sphere_family_powell_sabin(*dome(2, seed=seed)).skins:
        edges = []
        for face in surface.bsplines():
            for curve in face.trims[0]:
                edges.append(np.hstack(surface.evaluate(*points(curve, 9).T)))
        shared = [min(np.abs(edge - other[::-1]).max() for other in edges) for edge in edges]
        assert sum(gap < 1e-8 for gap in shared) == len(edges) - 16


def test_parameters_may_be_those_of_a_surface_over_no_plane():
    """The outside of a torus, over its two angles: x and y are no parameters of it."""
    grid = [(s, t) for s in (-0.6, 0.0, 0.6) for t in (-0.6, 0.0, 0.6)]
    along, around = np.array(grid).T
    radius = 60 + 25 * np.cos(around)
    change, zero = -25 * np.sin(around), np.zeros(9)
    c, s = np.cos(along), np.sin(along)
    centres = np.stack([radius * c, radius * s, 25 * np.sin(around)], axis=1)
    by_s = np.stack([-radius * s, radius * c, zero, 0.5 + zero], axis=1)
    by_t = np.stack([change * c, change * s, 25 * np.cos(around), zero], axis=1)
    radii = 2 + 0.5 * along
    squares = [(0, 3, 4, 1), (1, 4, 5, 2), (3, 6, 7, 4), (4, 7, 8, 5)]
    triangles = [half for a, b, c, d in squares for half in ((a, b, c), (a, c, d))]
    family = pn.sphere_family_powell_sabin(
        centres, radii, np.stack([by_s, by_t], axis=1), triangles, parameters=grid
    )
    outer, inner = family.skins
    for surface in (outer, inner):
        brep = pnocct.shell(surface.bsplines())
        assert pnocct.check(brep) == []
    # m_s x m_t points away from the axis, so the outer skin is the larger one.
    assert pnocct.area(pnocct.shell(outer.bsplines())) > pnocct.area(pnocct.shell(inner.bsplines()))


def test_refinement_approaches_the_surface_with_third_order():
    """The skin of a finer triangulation is nearer to the true one: eight times for half the width."""

    def true_point(x, y):
        a, b = (x - 50) / 100, (y - 50) / 100
        return 12 * np.cos(a) * np.cos(1.2 * b), 3 + a * a + 0.3 * a * b

    errors = []
    for count in (2, 4, 8):
        corners, spheres = pn.sphere_family_powell_sabin(*dome(count, moved=0)).pieces
        worst = 0
        for corner, control in zip(corners, spheres, strict=True):
            sphere, _, _ = Family(control).sphere(1 / 3, 1 / 3)
            x, y = corner.mean(axis=0)
            worst = max(worst, np.abs(np.array(true_point(x, y)) - sphere[2:]).max())
        errors.append(worst)
    ratios = np.array(errors[:-1]) / errors[1:]
    assert (ratios > 6).all()


def test_bad_input_is_refused_with_its_reason():
    centres, radii, derivatives, triangles = dome(1)
    make = pn.sphere_family_powell_sabin
    refused("wrong_shape", lambda: make(centres[:, :2], radii, derivatives, triangles))
    refused("wrong_shape", lambda: make(centres, radii[:3], derivatives, triangles))
    refused("wrong_shape", lambda: make(centres, radii, derivatives[:, :, :3], triangles))
    refused("wrong_shape", lambda: make(centres, radii, derivatives, triangles[:, :2]))
    refused("wrong_shape", lambda: make(centres, radii, derivatives, triangles, centres))
    refused("wrong_shape", lambda: make(centres, radii, derivatives, triangles - 1))
    refused("wrong_shape", lambda: make(centres, radii, derivatives, triangles + 1))
    refused("wrong_shape", lambda: make(centres, radii, derivatives, triangles[:0]))
    clockwise = triangles[:, ::-1]
    assert "Triangle 0 runs clockwise" in refused(
        "not_a_triangulation", lambda: make(centres, radii, derivatives, clockwise)
    )
    twice = np.vstack([triangles, triangles[:1]])
    refused("not_a_triangulation", lambda: make(centres, radii, derivatives, twice))
    for bad in (np.nan, np.inf):
        broken = radii.copy()
        broken[2] = bad
        refused("not_finite", lambda broken=broken: make(centres, broken, derivatives, triangles))
    line = np.outer(np.arange(4), [1.0, 2, 3])
    refused("zero_length", lambda: make(line, radii, derivatives, triangles))
    steep = derivatives.copy()
    steep[2, 1, 3] = 3
    assert "triangle" in refused("radius_too_steep", lambda: make(centres, radii, steep, triangles))


def test_equal_radii_are_named_as_an_offset():
    centres, radii, derivatives, triangles = dome(1)
    derivatives[:, :, 3] = 0
    family = pn.sphere_family_powell_sabin(centres, 0 * radii + 2, derivatives, triangles)
    assert any("offsets of the mid-surface" in note for note in family.notes)
