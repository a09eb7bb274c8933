# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes of cones of revolution against their definition: the spheres that they touch."""

import numpy as np
import pnkernel as pn
import pytest
from rulings import Cones, random_pair
from splines import Spline
from test_errors import refused
from test_ruled_surface import assert_certified


def random_cones(seed, degree, spans=1):
    """Radii that vary by less than the rulings are long."""
    first, second = random_pair(seed, degree, spans, noise=0.3)
    random = np.random.default_rng(seed + 1000)

    def law(mean):
        values = mean + random.uniform(-0.2, 0.2, len(first.poles))
        return Spline(degree, first.knots, first.multiplicities, values, first.weights)

    return Cones((first, second), (law(1.5), law(2.5)))


# The cubic pairs are those whose D has no odd real root: with one the degree would exceed 25.
@pytest.mark.parametrize(
    ("seed", "degree"),
    [*((seed, degree) for seed in range(4) for degree in (1, 2)), (0, 3), (3, 3), (4, 3)],
)
def test_random_spans(seed, degree):
    cones = random_cones(seed, degree)
    surface = cones.surface()
    for offset in (0.0, 0.75, -0.5):
        assert_certified(cones, surface.offset(offset), seed)


@pytest.mark.parametrize("seed", range(3))
def test_random_chains_of_spans(seed):
    cones = random_cones(seed, 2, spans=3)
    assert_certified(cones, cones.surface().offset(0.25), seed)


def test_points_are_the_cones_of_radius_zero():
    first, second = random_pair(2, 3, noise=0.3)
    nothing = pn.Law.constant(0)
    curves = [pn.Curve.bspline(*spline.arguments) for spline in (first, second)]
    lines = pn.ruled_surface(*curves).bsplines()
    cones = pn.cone_envelope(curves[0], nothing, curves[1], nothing).bsplines()
    for face, other in zip(lines, cones, strict=True):
        assert np.array_equal(face.poles, other.poles)
        assert np.array_equal(face.weights, other.weights)


def test_cylinders_of_one_radius_envelop_an_offset():
    first, second = random_pair(5, 3, noise=0.3)
    radius = Spline(1, (first.knots[0], first.knots[-1]), (2, 2), np.array([0.75, 0.75]), np.ones(2))
    curves = [pn.Curve.bspline(*spline.arguments) for spline in (first, second)]
    law = pn.Law.bspline(*radius.arguments)
    cylinders = pn.cone_envelope(curves[0], law, curves[1], law)
    lines = pn.ruled_surface(*curves)
    assert list(cylinders.degree) == list(lines.degree)
    assert_certified(Cones((first, second)), lines.offset(0.75))
    for face, other in zip(cylinders.bsplines(), lines.offset(0.75).bsplines(), strict=True):
        np.testing.assert_allclose(face.poles, other.poles, rtol=0, atol=1e-12)


def test_normals_touch_the_spheres():
    # n.c_t + r_t = 0 and n.c_v + r_v = 0 for c, r linear in v: so at both ends of every ruling.
    cones = random_cones(1, 2)
    surface = cones.surface()
    for t in (0.0, 0.25, 0.5):
        for u in (0.25, 0.5, 0.75):
            (point,), (normal,) = surface.evaluate([t], [u])
            foot_t, v = cones.foot(np.array(point), t, 0.5, 0)
            assert float(foot_t) == pytest.approx(t, abs=1e-12)
            (_, c1, c2, _, _), (_, r1, r2, _, _) = cones.spheres(foot_t, v, 0)
            assert abs(float(c1 @ normal + r1)) < 1e-12
            assert abs(float(c2 @ normal + r2)) < 1e-12


# Refusals -------------------------------------------------------------------------------------------


def test_refusals_name_their_reason():
    low, high = (pn.Curve.bezier(p) for p in ([[0, 0, 0], [4, 0, 0]], [[0, 5, 0], [4, 5, 3]]))
    one, law = pn.Law.constant(1), pn.Law.bezier
    inside = refused("radius_too_steep", lambda: pn.cone_envelope(low, one, high, pn.Law.constant(8)))
    assert "inside the other" in inside
    steep = refused("radius_too_steep", lambda: pn.cone_envelope(low, law([1, 6]), high, law([1, 6])))
    assert "more slowly" in steep
    longer = pn.Curve.bspline(1, [0, 3], [2, 2], [[0, 5, 0], [4, 5, 3]])
    refused("domain_mismatch", lambda: pn.cone_envelope(low, one, longer, law([1, 2])))
    # Between parallel lines the planes touch along whole cylinders.
    flat = pn.Curve.bezier([[0, 5, 0], [4, 5, 0]])
    refused("developable", lambda: pn.cone_envelope(low, one, flat, one))


def test_no_distance_is_claimed_to_be_regular():
    assert random_cones(0, 2).surface().regular_range == (0.0, 0.0)
