# SPDX-License-Identifier: LGPL-2.1-or-later
"""Degrees of families of conics by a second route, and their points by substitution.

PN_TEST_SCALE multiplies the number of random families.
"""

import os
from fractions import Fraction
from math import comb, lcm

import numpy as np
import pnkernel as pn
import pytest
from conic_lattices import NoRealPoints, exact, least_degree_of_points
from numpy.polynomial import polynomial as poly

COUNT = int(30 * float(os.environ.get("PN_TEST_SCALE", "1")))


def bernstein(conic):
    """Integers, exact in doubles: multiples of the Bernstein coefficients of all entries."""
    degree = max(len(entry) for row in conic for entry in row) - 1
    binomials = [comb(degree, i) for i in range(degree + 1)]
    scale = lcm(*binomials)
    result = np.zeros((degree + 1, 3, 3))
    for i, row in enumerate(conic):
        for j, entry in enumerate(row):
            for k in range(degree + 1):
                terms = (
                    Fraction(c) * comb(k, p) / binomials[p] for p, c in enumerate(entry) if p <= k
                )
                value = scale * sum(terms)
                assert Fraction(float(value)) == value
                result[k, i, j] = value
    return result


def diagonal(*entries):
    return [[entries[i] if i == j else [0] for j in range(3)] for i in range(3)]


def solved(conic):
    return pn.rational_conics(bernstein(conic))


def assert_on_conics(conic, points):
    """x^T C x = 0, coefficient by coefficient in t and u, up to the rounding of the doubles."""
    b = points.coefficients
    size = np.abs(b).max() ** 2 * max(abs(float(c)) for row in conic for e in row for c in e)
    for power_of_u in range(5):
        total = np.zeros(1)
        for k in range(3):
            other = power_of_u - k
            if not 0 <= other <= 2:
                continue
            for i in range(3):
                for j in range(3):
                    entry = np.array([float(c) for c in conic[i][j]])
                    term = poly.polymul(poly.polymul(b[:, i, k], entry), b[:, j, other])
                    total = poly.polyadd(total, term)
        assert np.abs(total).max() < 1e-12 * size


# L, M, N of the examples of docs/rational_conic_families.md, and (n, a).
FAMILIES = [
    (([1, 0, 1], [1], [-1, 0, -2]), (2, 0)),
    (([1, 0, 1], [4, 0, 1], [0, 0, -5, 0, -2]), (3, 0)),
    (([1, 0, 1], [4, 0, 1], [-5, 0, -2]), (2, 0)),
    (([1], [-1, 0, -1], [-1, 0, -2, 0, -5]), (4, 1)),
    (([1, 0, 3, 0, 3, 0, 1], [4, 0, 5, 0, 1], [-5, 0, -2]), (6, 1)),
]


@pytest.mark.parametrize("entries, degree_and_splitting", FAMILIES)
def test_families_of_the_page(entries, degree_and_splitting):
    conic = diagonal(*entries)
    degree, splitting = degree_and_splitting
    points = solved(conic)
    assert (points.degree, points.degree - points.bound) == (degree, splitting)
    assert least_degree_of_points(conic) == (degree - splitting, splitting)
    assert_on_conics(conic, points)


def random_polynomial(random, degree):
    return [int(c) for c in random.integers(-9, 10, degree + 1)]


def random_product(random):
    """Few factors, which meet and repeat: real zeros, pairs, and missing ones at infinity."""
    product = exact([int(random.integers(1, 6))])
    for factor in ([1, 0, 1], [4, 0, 1], [-1, 1], [0, 1]):
        if random.integers(0, 2):
            product = poly.polymul(product, exact(factor))
    return list(product)


def random_family(random):
    kind = random.integers(0, 3)
    if kind == 0:
        degree = int(random.integers(1, 4))
        conic = [[None] * 3 for _ in range(3)]
        for i in range(3):
            for j in range(i, 3):
                conic[i][j] = conic[j][i] = random_polynomial(random, degree)
        return conic
    if kind == 1:
        low, middle, high = (random_product(random) for _ in range(3))
        return diagonal(low, middle, [-c for c in high])
    l1, l2, l3 = ([exact(random_polynomial(random, 1)) for _ in range(3)] for _ in range(3))
    q = exact(random_polynomial(random, 2))
    return [
        [
            list(
                poly.polysub(
                    poly.polyadd(poly.polymul(l1[i], l2[j]), poly.polymul(l1[j], l2[i])),
                    poly.polymul(q, poly.polymul(l3[i], l3[j])),
                )
            )
            for j in range(3)
        ]
        for i in range(3)
    ]


@pytest.mark.parametrize("seed", range(COUNT))
def test_degree_by_steps_at_single_zeros(seed):
    conic = random_family(np.random.default_rng(seed))
    try:
        points = solved(conic)
    except pn.GeometryError as error:
        assert error.code in ("no_real_points", "singular_conics")
        return
    bound, splitting = least_degree_of_points(conic)
    assert (points.bound, points.degree - points.bound) == (bound, splitting)
    assert_on_conics(conic, points)


def test_conics_without_real_points_are_refused_by_both():
    conic = diagonal([1], [1], [0, -1])
    with pytest.raises(pn.GeometryError, match="no real points for t < 0"):
        solved(conic)
    with pytest.raises(NoRealPoints):
        least_degree_of_points(conic)


def test_points_are_rational_where_a_constant_conic_has_them():
    assert solved(diagonal([1], [1], [-2])).is_rational
    assert not solved(diagonal([1], [1], [-3])).is_rational
