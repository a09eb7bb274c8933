# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad input: a GeometryError with a code of the closed list and a sentence that names the place."""

import re
import threading

import numpy as np
import pnkernel as pn
import pytest
from canal import random_canal

NAN = float("nan")
LINE = [[0, 0, 0], [0, 0, 5]]
ONE = pn.Law.constant(1)


def polyline(*points):
    count = len(points)
    return pn.Curve.bspline(1, np.arange(count), [2, *[1] * (count - 2), 2], points)


def polyline_law(*values):
    count = len(values)
    return pn.Law.bspline(1, np.arange(count), [2, *[1] * (count - 2), 2], values)


def noisy_spine(degree, rational=False):
    random = np.random.default_rng(0)
    poles = random.normal(size=(degree + 1, 3)) + 10 * np.arange(degree + 1)[:, None] * [0, 0, 1]
    return pn.Curve.bezier(poles, random.uniform(0.9, 1.1, degree + 1) if rational else None)


def refused(code, make):
    with pytest.raises(pn.GeometryError) as caught:
        make()
    assert isinstance(caught.value, ValueError)
    sentence = str(caught.value)
    assert caught.value.code == code, sentence
    assert sentence.endswith(".")
    return sentence


@pytest.mark.parametrize(
    "make",
    [
        lambda: pn.Curve.bezier([[0, 0, 0]]),
        lambda: pn.Curve.bezier(np.zeros((0, 3))),
        lambda: pn.Curve.bezier([[0, 0], [1, 1]]),
        lambda: pn.Curve.bezier([0, 1, 2]),
        lambda: pn.Curve.bezier(LINE, [1]),
        lambda: pn.Curve.bezier(LINE, [[1, 1]]),
        lambda: pn.Curve.bspline(0, [0, 1], [1, 1], LINE),
        lambda: pn.Curve.chain([]),
        lambda: pn.Law.bezier([1]),
        lambda: pn.Law.bezier([[1, 2]]),
        lambda: pn.canal_surface(pn.Curve.bezier(LINE), ONE).evaluate([0, 1], [0]),
    ],
)
def test_wrong_shape(make):
    refused("wrong_shape", make)


@pytest.mark.parametrize(
    "arguments",
    [
        (1, [0, 0], [2, 2], LINE),
        (1, [1, 0], [2, 2], LINE),
        (1, [0], [4], LINE),
        (1, [0, 1], [1, 2], LINE),
        (1, [0, 1], [2, 2, 2], LINE),
        (1, [0, 1, 2], [2, 1, 2], LINE),
        (1, [0, 1, 2], [2, 0, 2], LINE),
        (1, [0, 1, 2], [2, -1, 2], LINE),
        (1, [0, 1, 2], [2, 3, 2], [*LINE, *LINE, [0, 0, 0]]),
        (1_000_000, [0, 1], [2, 2], LINE),
    ],
)
def test_bad_knots(arguments):
    refused("bad_knots", lambda: pn.Curve.bspline(*arguments))
    degree, knots, multiplicities, poles = arguments
    values = np.array(poles)[:, 0]
    refused("bad_knots", lambda: pn.Law.bspline(degree, knots, multiplicities, values))


@pytest.mark.parametrize("weight", [0.0, -1.0, -1e-99])
def test_non_positive_weight(weight):
    sentence = refused("non_positive_weight", lambda: pn.Curve.bezier(LINE, [1, weight]))
    assert "number 2" in sentence
    refused("non_positive_weight", lambda: pn.Law.bezier([1, 2], [weight, 1]))


def test_gap():
    knots = (1, [0, 1, 2], [2, 2, 2])
    sentence = refused("gap", lambda: pn.Curve.bspline(*knots, [*LINE, [0, 0, 6], [0, 0, 7]]))
    assert "parameter 1" in sentence
    refused("gap", lambda: pn.Law.bspline(*knots, [1, 2, 2.5, 3]))
    line = pn.Curve.bezier(LINE)
    refused("gap", lambda: pn.Curve.chain([line, line]))


def test_zero_length():
    still = pn.Curve.bezier([[1, 2, 3], [1, 2, 3]])
    assert "(1, 2, 3)" in refused("zero_length", lambda: pn.canal_surface(still, ONE))
    stop = polyline([0, 0, 0], [0, 0, 5], [0, 0, 5], [0, 3, 5])
    sentence = refused("zero_length", lambda: pn.canal_surface(stop, ONE))
    assert "1 to 2" in sentence and "(0, 0, 5)" in sentence


def test_domain_mismatch():
    spine = pn.Curve.bspline(1, [0, 2], [2, 2], LINE)
    sentence = refused("domain_mismatch", lambda: pn.canal_surface(spine, pn.Law.bezier([1, 2])))
    assert re.search(r"0\S* to 1\S*, .* 0\S* to 2", sentence)
    pn.canal_surface(spine, ONE)  # a constant fits every spine


def test_negative_radius_names_interval_and_place():
    spine = pn.Curve.bezier([[0, 0, 0], [0, 0, 5], [0, 0, 10]])
    dip = pn.Law.bezier([1, -1.5, 1])
    sentence = refused("negative_radius", lambda: pn.canal_surface(spine, dip))
    # 1 - 5 t + 5 t^2 is negative between 1/2 -+ sqrt(5)/10.
    assert numbers(sentence)[:2] == pytest.approx([0.5 - 0.05**0.5, 0.5 + 0.05**0.5], abs=1e-5)
    assert numbers(sentence)[2:5] == pytest.approx([0, 0, 5], abs=1e-5)
    refused("negative_radius", lambda: pn.canal_surface(pn.Curve.bezier(LINE), pn.Law.constant(-1)))
    two = polyline([0, 0, 0], [0, 0, 5], [0, 0, 10])
    sentence = refused("negative_radius", lambda: pn.canal_surface(two, polyline_law(1, 1, -1)))
    assert numbers(sentence) == pytest.approx([1.5, 2, 0, 0, 8.75])


def numbers(sentence):
    return [float(x) for x in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", sentence)]


def test_radius_too_steep_names_interval_and_place():
    spine, radius = pn.Curve.bezier(LINE), pn.Law.bezier([1, 1, 9])
    # r' = 16 t exceeds |m'| = 5 from 5/16 on.
    sentence = refused("radius_too_steep", lambda: pn.canal_surface(spine, radius))
    assert numbers(sentence) == pytest.approx([5 / 16, 1, 0, 0, 5 * 21 / 32], abs=1e-5)
    refused("radius_too_steep", lambda: pn.canal_surface(spine, pn.Law.bezier([9, 1])))
    two = polyline([0, 0, 0], [0, 0, 5], [0, 0, 10])
    sentence = refused("radius_too_steep", lambda: pn.canal_surface(two, polyline_law(1, 2, 9)))
    assert numbers(sentence)[:2] == [1, 2]


def test_radius_as_steep_as_the_spine():
    spine = pn.Curve.bezier(LINE)
    sentence = refused("developable", lambda: pn.canal_surface(spine, pn.Law.bezier([1, 6])))
    assert "0 to 1" in sentence
    # m' = 15; r' = 15 - 12 (t - 1/2)^2 reaches it at 1/2, r' = 5 + 10 t at 1.
    spine = pn.Curve.bezier([[0, 0, 0], [0, 0, 15]])
    inside, end = pn.Law.bezier([1, 5, 11, 15]), pn.Law.bezier([1, 3.5, 11])
    assert numbers(refused("pinched", lambda: pn.canal_surface(spine, inside))) == [0.5, 0, 0, 7.5]
    assert numbers(refused("pinched", lambda: pn.canal_surface(spine, end))) == [1, 0, 0, 15]


def test_nearly_pinched_is_exact_or_refused_but_never_wrong():
    spine = pn.Curve.bezier([[0, 0, 0], [0, 0, 15]])
    for slack in (1e-3, 1e-6, 1e-9):
        refused(
            "radius_too_steep",
            lambda: pn.canal_surface(spine, pn.Law.bezier([1, 5 - slack, 11 + slack, 15])),
        )
        surface = pn.canal_surface(spine, pn.Law.bezier([1, 5 + slack, 11 - slack, 15]))
        assert surface.certificate.deviation < 1e-12


def test_corner_too_sharp():
    back = polyline([0, 0, 0], [0, 0, 5], [0, 0, 1])
    sentence = refused("corner_too_sharp", lambda: pn.canal_surface(back, ONE))
    assert "parameter 1" in sentence and "(0, 0, 5)" in sentence


def test_degree_too_high():
    for spine, degree in ((noisy_spine(14), 28), (noisy_spine(10, rational=True), 28)):
        sentence = refused("degree_too_high", lambda: pn.canal_surface(spine, ONE))
        assert str(degree) in sentence and "25" in sentence and "cubic B-spline" in sentence


@pytest.mark.parametrize(("degree", "rational"), [(12, False), (13, False), (9, True)])
def test_highest_degrees(degree, rational):
    surface = pn.canal_surface(noisy_spine(degree, rational), ONE)
    expected = 3 * degree - 2 if rational else degree + 2 * (degree // 2)
    assert list(surface.degree) == [expected, 2]
    certificate = surface.certificate
    assert certificate.bidegree[0] <= 25
    assert certificate.deviation < 1e-12


def test_lines_must_be_named():
    surface = pn.canal_surface(pn.Curve.bezier(LINE), ONE)
    with pytest.raises(ValueError, match="even"):
        surface.bsplines("best")


def test_an_error_leaves_surfaces_untouched():
    surface = random_canal(0, 3).surface()
    before = surface.bsplines()[0].poles
    refused("not_finite", lambda: surface.offset(NAN))
    assert np.array_equal(surface.bsplines()[0].poles, before)


def test_errors_in_threads_keep_their_codes():
    codes = []

    def work():
        try:
            pn.canal_surface(pn.Curve.bezier(LINE), pn.Law.bezier([1, 9]))
        except pn.GeometryError as error:
            codes.append(error.code)

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert codes == ["radius_too_steep"] * 8


def test_extreme_sizes_are_refused_or_certified():
    for size in (1e-99, 1e-30, 1e30, 1e99):
        spine = pn.Curve.bezier(np.multiply(size, [[0, 0, 0], [0, 1, 1], [1, 0, 2]]))
        try:
            deviation = pn.canal_surface(spine, pn.Law.constant(size / 8)).certificate.deviation
        except pn.GeometryError as error:
            assert error.code == "precision_exhausted"
        else:
            assert deviation <= 1e-14 * size
