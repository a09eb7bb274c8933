# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ruled surfaces and their offsets against the definition: the distance from the lines."""

from math import ceil

import numpy as np
import pnkernel as pn
import pnocct
import pytest
from canal import face_parameters
from mpmath import mpf, sqrt
from numpy.polynomial import Polynomial
from quadrics import Quadric
from rulings import Cones, random_pair
from splines import Spline, norm, surface_point
from test_closed_forms import EXACT_WEIGHTS, quarters
from test_errors import refused

TIGHTNESS = 1e-6  # of the size: the limits stay behind the true ones by no more


def deviations(cones, surface, random, count=6):
    """How far exported points are from the surface at this distance, in mm."""
    for face in surface.bsplines():
        for u, v in face_parameters(face, random, count):
            point = surface_point(face, u, v)
            span = cones.centres[0].span_at(u)
            yield abs(cones.contact(point, surface.distance, u, span)[2] - surface.distance)


def assert_certified(cones, surface, seed=0):
    certificate = surface.certificate
    assert certificate.exact
    assert max(deviations(cones, surface, np.random.default_rng(seed))) <= certificate.deviation
    assert certificate.deviation <= 1e-12 * (cones.size + abs(surface.distance))


@pytest.mark.parametrize("rational", [False, True])
@pytest.mark.parametrize("degree", [1, 2, 3])
@pytest.mark.parametrize("seed", range(4))
def test_random_spans(seed, degree, rational):
    cones = Cones(random_pair(seed, degree, rational=rational, noise=0.5))
    surface = cones.surface()
    for offset in (0.0, 0.75, -0.5):
        assert_certified(cones, surface.offset(offset), seed)


@pytest.mark.parametrize("degree", [2, 3])
@pytest.mark.parametrize("seed", range(3))
def test_random_chains_of_spans(seed, degree):
    cones = Cones(random_pair(seed, degree, spans=4, noise=0.5))
    assert_certified(cones, cones.surface().offset(0.25), seed)


def test_smooth_spans_are_one_face():
    cones = Cones(random_pair(0, 3, spans=4, noise=0.1))
    assert torsal_places(*cones.centres) == []
    (face,) = cones.surface().bsplines()
    assert all(m == face.u_degree - 1 for m in face.u_multiplicities[1:-1])


@pytest.mark.parametrize("size", [1e-6, 1e-3, 1e3, 1e6])
def test_sizes(size):
    first, second = random_pair(3, 3, noise=0.5)
    scaled = Cones(
        tuple(
            Spline(s.degree, s.knots, s.multiplicities, size * s.poles, s.weights)
            for s in (first, second)
        )
    )
    assert_certified(scaled, scaled.surface())


def test_normals_and_offsets():
    surface = Cones(random_pair(1, 3)).surface()
    random = np.random.default_rng(0)
    t, u = random.uniform(0, surface.bsplines()[-1].u_knots[-1], 50), random.uniform(0, 1, 50)
    points, normals = surface.evaluate(t, u)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, rtol=0, atol=1e-14)
    moved, same = surface.offset(0.5).evaluate(t, u)
    np.testing.assert_allclose(moved, points + 0.5 * normals, rtol=0, atol=1e-13)
    np.testing.assert_allclose(same, normals, rtol=0, atol=1e-14)


def test_orientation():
    # The x-axis and a line to the left that rises: c_t x c_v points upwards.
    surface = pn.ruled_surface(
        pn.Curve.bezier([[0, 0, 0], [1, 0, 0]]), pn.Curve.bezier([[0, 1, 0], [1, 1, 0.5]])
    )
    _, normals = surface.evaluate([0, 0.5, 1], [0.5, 0.5, 0.5])
    assert (normals[:, 2] > 0.8).all()
    turned = pn.ruled_surface(
        pn.Curve.bezier([[0, 1, 0], [1, 1, 0.5]]), pn.Curve.bezier([[0, 0, 0], [1, 0, 0]])
    )
    assert (turned.evaluate([0, 1], [0.5, 0.5])[1][:, 2] < -0.8).all()


def torsal_places(first, second):
    """The zeros of det(c0', g, g') inside the spans of polynomial curves, g = c1 - c0."""
    places = []
    for span, (low, high) in enumerate(zip(first.knots, first.knots[1:])):
        a, b = (
            [Polynomial([float(c) for c in p]) for p in s.span_polynomials[span][:3]]
            for s in (first, second)
        )
        g = [q - p for p, q in zip(a, b)]
        slope, turn = [p.deriv() for p in a], [p.deriv() for p in g]
        torsion = sum(
            (
                slope[i] * (g[(i + 1) % 3] * turn[(i + 2) % 3] - g[(i + 2) % 3] * turn[(i + 1) % 3])
                for i in range(3)
            ),
            Polynomial([0.0]),
        )
        places += [r.real for r in torsion.roots() if abs(r.imag) < 1e-9 and low < r.real < high]
    return places


@pytest.mark.parametrize(("degree", "along"), [(1, 5), (2, 7), (3, 13), (4, 15), (5, 21), (6, 23)])
def test_degrees_of_polynomial_curves(degree, along):
    # k + 4 ceil(k/2) + k - 1; each torsal ruling in a span adds 3.
    assert along == degree + 4 * ceil(degree / 2) + degree - 1
    first, second = random_pair(0, degree, noise=0.02)
    assert torsal_places(first, second) == []
    assert list(Cones((first, second)).surface().degree) == [along, 4]


@pytest.mark.parametrize("seed", range(8))
def test_a_torsal_ruling_adds_three_to_the_degree(seed):
    first, second = random_pair(seed, 2, noise=2.0)
    places = torsal_places(first, second)
    surface = Cones((first, second)).surface()
    assert surface.degree[0] == 7 + 3 * bool(places)
    if places:
        assert_certified(Cones((first, second)), surface.offset(0.25))


def test_torsal_rulings_in_the_middle_of_a_sheet():
    # g = (0, 1, z(t)) over a straight line: the tangent plane does not turn where z' = 0.
    first = Spline.bezier([[0, 0, 0], [1, 0, 0], [2, 0, 0]])
    second = Spline.bezier([[0, 1, 1], [1, 1, -1], [2, 1, 1]])
    cones = Cones((first, second))
    np.testing.assert_allclose(torsal_places(first, second), [0.5], rtol=0, atol=1e-12)
    surface = cones.surface()
    assert list(surface.degree) == [9, 4]
    for offset in (0.0, 0.25):
        assert_certified(cones, surface.offset(offset))


# Ruled quadrics ------------------------------------------------------------------------------------


def saddle_between(low, high):
    """z = x^2/16 - y^2/4 between the lines x/4 + y/2 = low and high, for x/4 - y/2 in [-1, 2]."""

    def line(along):
        return Spline.bezier([[2 * (along + t), along - t, along * t] for t in (-1.0, 2.0)])

    return Cones((line(low), line(high)))


@pytest.mark.parametrize("offset", [0.0, 1.25, -0.75])
def test_saddle_as_a_ruled_surface_and_as_a_quadric(offset):
    definition = Quadric.of("hyperbolic_paraboloid", 4, 2, 1)
    ruled = saddle_between(-0.5, 1.0).surface()
    whole = pn.quadric("hyperbolic_paraboloid", 4, 2, 1, {"x": (-3, 6), "y": (-2, 1.5)})
    assert list(ruled.degree) == list(whole.degree) == [5, 4]
    # Along the first directrix, then to the second: the ruled surface looks the other way.
    up = np.sign(ruled.evaluate([0.5], [0.5])[1][0, 2])
    for surface, distance in ((ruled, up * offset), (whole, offset)):
        moved = surface.offset(distance)
        for face in moved.bsplines():
            for u, v in face_parameters(face, np.random.default_rng(0), 20):
                point = surface_point(face, u, v)
                found = definition.contact(point, mpf(offset))[1]
                assert abs(found - offset) <= moved.certificate.deviation


def ellipse(a, b, z, turn=0):
    """Four quarters at a height, from this quarter on."""
    pieces = [quarter * [a, b, 1] + [0, 0, z] for quarter in quarters(4)]
    order = [(i + turn) % 4 for i in range(4)]
    return Spline.joined([pieces[i] for i in order], [EXACT_WEIGHTS[i % 2] for i in range(4)])


def test_hyperboloid_between_two_ellipses():
    # Rulings over a quarter turn from z = -2 to 2: the waist is 1 / sqrt(2) as wide as the ends.
    a, b, height = 4.0, 3.0, 2.0
    ruled = pn.ruled_surface(
        *(pn.Curve.bspline(*s.arguments) for s in (ellipse(a, b, -height), ellipse(a, b, height, 1)))
    )
    waist = [mpf(a) / sqrt(2), mpf(b) / sqrt(2)]
    definition = Quadric.of("one_sheet_hyperboloid", *waist, height)
    whole = pn.quadric(
        "one_sheet_hyperboloid", float(waist[0]), float(waist[1]), height, {"z": (-height, height)}
    )
    for offset in (0.0, 0.5, -0.5):
        moved = ruled.offset(offset)
        for face in moved.bsplines():
            for u, v in face_parameters(face, np.random.default_rng(0), 6):
                found = definition.contact(surface_point(face, u, v), mpf(offset))[1]
                assert abs(found - offset) <= moved.certificate.deviation
        areas = [pnocct.area(pnocct.shell(s.offset(offset).bsplines())) for s in (ruled, whole)]
        assert areas[0] == pytest.approx(areas[1], rel=1e-9)
        assert pnocct.check(pnocct.shell(moved.bsplines()), boolean=True) == []


# Developable surfaces -------------------------------------------------------------------------------


def parabola(y):
    return Spline.bezier([[-1, y, 1], [0, y, -1], [1, y, 1]])  # z = x^2


@pytest.mark.parametrize(
    ("first", "second", "degree"),
    [
        # A plane; cylinder and cone of revolution over rational circles; a parabolic cylinder.
        (Spline.bezier([[0, 0, 0], [4, 0, 0]]), Spline.bezier([[0, 3, 0], [4, 5, 0]]), (1, 1)),
        (ellipse(4, 4, 0), ellipse(4, 4, 3), (5, 1)),
        (ellipse(4, 4, 0), ellipse(2, 2, 3), (5, 1)),
        (parabola(1), parabola(-1), (7, 1)),
    ],
)
def test_developable_strips_with_rational_normals(first, second, degree):
    cones = Cones((first, second))
    surface = cones.surface()
    assert list(surface.degree) == list(degree)
    for offset in (0.0, 0.25, -0.25):
        moved = surface.offset(offset)
        for face in moved.bsplines():
            assert face.trims == []
            for u, v in face_parameters(face, np.random.default_rng(0), 6):
                point = surface_point(face, u, v)
                # Inside a span of a parabolic cylinder the parameter is not that of the curves.
                start = min(
                    np.linspace(face.u_knots[0], face.u_knots[-1], 33),
                    key=lambda t: abs_distance(cones, point, t, face),
                )
                span = cones.centres[0].span_at(face.u_knots[0])
                found = cones.contact(point, offset, start, span)[2]
                assert abs(found - offset) <= moved.certificate.deviation
        assert pnocct.check(pnocct.shell(moved.bsplines()), boolean=True) == []


def abs_distance(cones, point, t, face):
    """From the ruling of t."""
    c, _, g, _, _ = cones.spheres(mpf(t), mpf(0), cones.centres[0].span_at(face.u_knots[0]))[0]
    arm = point - c
    return norm(arm - (arm @ g) / (g @ g) * g)


def test_developable_surfaces_without_rational_normals():
    curve = pn.Curve.bspline
    refused(
        "developable",
        lambda: pn.ruled_surface(
            curve(*ellipse(4, 3, 0).arguments), curve(*ellipse(4, 3, 3).arguments)
        ),
    )
    apex = Spline.bezier([[0, 0, 0], [1, 0, 0], [1, 1, 0]])
    opposite = Spline.bezier([[0, 0, 3], [-1, 0, 3], [-1, -1, 3]])
    refused(
        "developable", lambda: pn.ruled_surface(curve(*apex.arguments), curve(*opposite.arguments))
    )


# Refusals -------------------------------------------------------------------------------------------


def line(*ends):
    return pn.Curve.bezier(ends)


def test_refusals_name_their_reason():
    low, high = line([0, 0, 0], [1, 0, 0]), line([0, 1, 0], [1, 1, 1])
    assert "parameter 0.5" in refused(
        "curves_meet",
        lambda: pn.ruled_surface(line([0, 0, 0], [2, 0, 0]), line([1, -1, 0], [1, 1, 0])),
    )
    refused("zero_length", lambda: pn.ruled_surface(line([0, 0, 1], [0, 0, 1]), high))
    assert "parameter 0.5" in refused(
        "pinched",
        lambda: pn.ruled_surface(line([0, 0, 0], [2, 0, 0]), line([2, 1, 0], [1, 1, -1], [0, 1, 0])),
    )
    corner = pn.Curve.bspline(1, [0, 1, 2], [2, 1, 2], [[0, 0, 0], [1, 0, 0], [2, 1, 0]])
    assert "parameter 1" in refused("corner_too_sharp", lambda: pn.ruled_surface(corner, high))
    refused("not_finite", lambda: pn.ruled_surface(low, high).offset(float("nan")))
    noisy = [pn.Curve.bspline(*s.arguments) for s in random_pair(0, 8)]
    assert "25" in refused("degree_too_high", lambda: pn.ruled_surface(*noisy))


def test_identical_curves():
    refused("identical_curves", lambda: pn.ruled_surface(*[line([0, 0, 0], [1, 0, 0])] * 2))


def test_the_second_domain_is_mapped_to_the_first():
    first = pn.Curve.bspline(1, [0, 2], [2, 2], [[0, 0, 0], [1, 0, 0]])
    second = pn.Curve.bspline(1, [5, 6], [2, 2], [[0, 1, 0], [1, 1, 1]])
    surface = pn.ruled_surface(first, second)
    (face,) = surface.bsplines()
    assert (face.u_knots[0], face.u_knots[-1]) == (0, 2)
    (point,), _ = surface.evaluate([1.0], [0.5])
    assert point[0] == pytest.approx(0.5, abs=1e-14)


# Limits ---------------------------------------------------------------------------------------------


def assert_limits(surface, lower, upper):
    first, last = surface.regular_range
    assert lower <= first <= lower + TIGHTNESS
    assert upper - TIGHTNESS <= last <= upper


def test_regular_range_of_a_saddle():
    # (t, v, t v): the curvatures at the saddle point are 1 and -1.
    surface = pn.ruled_surface(
        pn.Curve.bezier([[-1, -1, 1], [1, -1, -1]]), pn.Curve.bezier([[-1, 1, -1], [1, 1, 1]])
    )
    assert_limits(surface, -1, 1)


def test_regular_range_of_a_hyperboloid():
    # At the waist of radius a the curvatures are 1/a inwards, a/c^2 outwards.
    surface = pn.ruled_surface(
        *(pn.Curve.bspline(*s.arguments) for s in (ellipse(4, 4, -2), ellipse(4, 4, 2, 1)))
    )
    waist = 4 / np.sqrt(2)
    assert_limits(surface, -waist, 4 / waist)
