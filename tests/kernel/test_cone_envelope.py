# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes of cones of revolution against their definition: the spheres that they touch."""

import json
from pathlib import Path

import numpy as np
import pnkernel as pn
import pytest
from rulings import Cones, random_pair
from splines import Spline
from test_ruled_surface import assert_certified

EXAMPLES = json.loads((Path(__file__).parent / "data" / "cone_examples.json").read_text())


def random_cones(seed, degree, spans=1):
    """Radii that vary by less than the rulings are long."""
    first, second = random_pair(seed, degree, spans, noise=0.3)
    random = np.random.default_rng(seed + 1000)

    def law(mean):
        values = mean + random.uniform(-0.2, 0.2, len(first.poles))
        return Spline(degree, first.knots, first.multiplicities, values, first.weights)

    return Cones((first, second), (law(1.5), law(2.5)))


@pytest.mark.parametrize("degree", [1, 2, 3])
@pytest.mark.parametrize("seed", range(4))
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
    radius = Spline(1, (first.knots[0], first.knots[-1]), (2, 2), np.array([0.75, 0.75]),
                    np.ones(2))
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


# The literature -------------------------------------------------------------------------------------


def test_skew_family_of_peternell():
    """a = (u^2, 0, u; 0), g = (0, 1 + u^2, 0; 2 u): our radius is minus the fourth coordinate."""
    example = EXAMPLES["mos-skew-ruled-surface"]
    low, high = 0.25, 0.75

    def poles(taylor):
        """Of the quadratic over [low, high]."""
        c0, c1, c2 = taylor
        return [c0 + c1 * low + c2 * low**2, c0 + c1 * (low + high) / 2 + c2 * low * high,
                c0 + c1 * high + c2 * high**2]

    def curve(*coordinates):
        return pn.Curve.bezier(np.transpose([poles(c) for c in coordinates]))

    near = curve((0, 0, 1), (0, 0, 0), (0, 1, 0))
    far = curve((0, 0, 1), (-0.5, 0, -0.5), (0, 1, 0))  # v = -1/2: the sphere has radius u
    surface = pn.cone_envelope(near, pn.Law.constant(0), far, pn.Law.bezier(poles((0, 1, 0))))
    random = np.random.default_rng(0)
    local, around = random.uniform(0, 1, 30), random.uniform(0, 1, 30)
    points, normals = surface.evaluate(local, around)
    for s, point, normal in zip(local, points, normals, strict=True):
        u = low + s * (high - low)
        # n = <q, q> n0 - 2 <n0, q> q with q = k + t l: q is the combination of n0 and n in the
        # plane of k and l with the coordinates (0, 2 u) of k.
        n0 = np.array([1 - u**2, 2 * u, 0, 1 + u**2])
        n = np.append(normal, 1.0)
        (alpha, beta) = np.linalg.solve([[n0[0], n[0]], [n0[1], n[1]]], [0, 2 * u])
        t = (alpha * n0 + beta * n)[2] / (2 * (1 - u**2))
        names = {"u": u, "t": t}
        expected = np.array(eval(example["n"], {}, names), dtype=float)
        np.testing.assert_allclose(expected[:3] / expected[3], normal, rtol=0, atol=1e-11)
        expected = np.array(eval(example["P"], {}, names), dtype=float)
        np.testing.assert_allclose(point, expected, rtol=0, atol=1e-11)


def test_tangent_cones_of_a_canal_surface_are_developable():
    # Peternell's example (4.5)-(4.14): the second family lies on the tangents of the first.
    t0 = 5.0  # where all radii are positive; 9 times as large, so that all poles are doubles

    def taylor(coefficients):
        """Of the cubic about t0."""
        p = np.polynomial.Polynomial(coefficients)(np.polynomial.Polynomial([t0, 1.0]))
        return np.pad(p.coef, (0, 4 - len(p.coef)))

    def poles(coefficients):
        c = 9 * taylor(coefficients)
        return [c[0], c[0] + c[1] / 3, c[0] + 2 * c[1] / 3 + c[2] / 3, c.sum()]

    data = EXAMPLES["diss-envelope-of-cones"]
    families = []
    for centre, radius in (("ma", "ra"), ("mb", "rb")):
        scaled = [np.array(c, dtype=float) / 9 for c in data[centre]]
        families += [pn.Curve.bezier(np.transpose([poles(c) for c in scaled])),
                     pn.Law.bezier(poles(np.array(data[radius], dtype=float) / 9))]
    with pytest.raises(pn.GeometryError) as caught:
        pn.cone_envelope(*families)
    assert caught.value.code == "developable"
