# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate against the definition of the envelope, at 60 digits.

A point x of the exported doubles lies at distance ||x - m(t)| - r(t) - d| from the envelope,
where t is the zero of (x - m).m' + r' |x - m|. Nothing of the kernel's construction is used.
"""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pnkernel as pn
import pytest
from canal import Canal, face_parameters, random_canal
from splines import Spline, surface_point

FACE_ATTRIBUTES = (
    "u_degree",
    "v_degree",
    "u_knots",
    "u_multiplicities",
    "v_knots",
    "v_multiplicities",
    "poles",
    "weights",
)
LOOSEST = 1e-12  # of the size: a few hundred ulps, as much as poles of a spine far off may cost


def deviations(canal, surface, faces, random, count, locate):
    """The distance of points of the faces to the true envelope, in mm."""
    for face in faces:
        for u, v in face_parameters(face, random, count):
            point = surface_point(face, u, v)
            t, span = locate(face, point, u)
            yield float(canal.distance(point, surface.distance, t, span))


def measured(canal, surface, random, count=6, lines="even"):
    """The largest distance, where the faces run with the spine's own parameter."""

    def locate(_, __, u):
        return u, canal.spine.span_at(u)

    return max(deviations(canal, surface, surface.bsplines(lines), random, count, locate))


def assert_certified(canal, surface, deviation):
    bound = surface.certificate.deviation
    assert deviation <= bound
    assert bound <= LOOSEST * (canal.size + abs(surface.distance))


@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("degree", [1, 2, 3, 4, 5, 6])
@pytest.mark.parametrize("seed", range(4))
def test_random_spans(seed, degree, rational):
    canal = random_canal(seed, degree, spans=1, rational=rational)
    surface = canal.surface()
    random = np.random.default_rng(seed)
    for offset in (0.0, random.uniform(-1, 1)):
        moved = surface.offset(offset)
        assert_certified(canal, moved, measured(canal, moved, random))


@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("degree", [2, 3, 4])
@pytest.mark.parametrize("seed", range(3))
def test_random_chains_of_spans(seed, degree, rational):
    canal = random_canal(seed, degree, spans=4, rational=rational)
    surface = canal.surface().offset(0.25)
    assert_certified(canal, surface, measured(canal, surface, np.random.default_rng(seed)))


@pytest.mark.parametrize(
    "spine",
    [
        [[0, 0, 0], [0, 0, 4]],
        [[0, 0, 0], [1, 0, 2], [0, 0, 4]],
        [[0, 0, 0], [1, 0, 2], [0, 3, 4], [2, 0, 6]],
    ],
)
def test_taper_with_odd_real_roots(spine):
    # |m'|^2 - r'^2 has real zeros outside [0, 1]: the faces have a parameter of their own.
    radius = [2, 1.5, 3] if len(spine) < 4 else [2, 1.5, 3, 4]
    canal = Canal(Spline.bezier(spine), Spline.bezier(radius))
    surface = canal.surface().offset(0.5)
    random = np.random.default_rng(0)

    def locate(_, point, __):
        return canal.nearest_parameter(point, 0.5)

    worst = max(deviations(canal, surface, surface.bsplines(), random, 4, locate))
    assert_certified(canal, surface, worst)


@pytest.mark.parametrize("size", [1e-6, 1e-3, 1e3, 1e6])
def test_sizes(size):
    canal = random_canal(7, 3)
    scaled = Canal(
        replace(canal.spine, poles=size * canal.spine.poles),
        replace(canal.radius, poles=size * canal.radius.poles),
    )
    surface = scaled.surface()
    assert_certified(scaled, surface, measured(scaled, surface, np.random.default_rng(0)))


@pytest.mark.parametrize("factor", [1e-90, 1e-9, 1e9, 1e90])
def test_weights_of_any_magnitude(factor):
    canal = random_canal(8, 3, rational=True)
    heavy = Canal(
        replace(canal.spine, weights=factor * canal.spine.weights),
        replace(canal.radius, weights=factor * canal.radius.weights),
    )
    surface = heavy.surface()
    assert surface.degree == canal.surface().degree
    assert_certified(heavy, surface, measured(heavy, surface, np.random.default_rng(0)))


@pytest.mark.parametrize("factor", [1e-9, 1e-3, 1e3, 1e9])
def test_one_weight_out_of_proportion(factor):
    # The curve nearly has a corner: the surface is certified, or refused with a reason.
    canal = random_canal(8, 3, rational=True)
    weights = canal.spine.weights * [1, factor, 1, 1]
    uneven = Canal(replace(canal.spine, weights=weights), replace(canal.radius, weights=weights))
    try:
        surface = uneven.surface()
        surface.bsplines()
    except pn.GeometryError as error:
        assert error.code in ("weights_not_positive", "precision_exhausted")
    else:
        assert_certified(uneven, surface, measured(uneven, surface, np.random.default_rng(0)))


@pytest.mark.parametrize("lines", ["even", "lowest_degree"])
def test_the_measure_sees_what_the_bound_excludes(lines):
    canal = random_canal(3, 3)
    surface = canal.surface()
    bound = surface.certificate.deviation
    face = surface.bsplines(lines)[0]
    u, v = face.u_knots[0], face.v_knots[0]
    bent = SimpleNamespace(**{name: getattr(face, name) for name in FACE_ATTRIBUTES})
    _, normal = surface.evaluate([u], [v])
    bent.poles = face.poles.copy()
    bent.poles[0, 0] += 10 * bound * normal[0]
    before = canal.distance(surface_point(face, u, v), 0, u, 0)
    after = canal.distance(surface_point(bent, u, v), 0, u, 0)
    assert before <= bound < after


def test_lowest_degree_faces_lie_on_the_envelope():
    for seed in range(4):
        canal = random_canal(seed, 4, spans=2)
        surface = canal.surface().offset(-0.5)
        worst = measured(canal, surface, np.random.default_rng(seed), lines="lowest_degree")
        assert worst <= LOOSEST * canal.size
