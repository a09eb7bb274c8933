# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a B-spline surface of doubles is part of a quadric identically, decided over Q.

Theorem: on each piece of bidegree (p, q), rational or not, a quadratic form in the homogeneous
coordinates of the point has bidegree (2p, 2q). So it vanishes on the piece when it does at the
(2p + 1)(2q + 1) points of a grid, and some form vanishes on the surface if and only if the matrix
of the ten quadratic monomials at all these points has a rank below ten.
"""

import itertools
from fractions import Fraction

from pnsurfaces.quadric_form import PAIRS


def satisfies_quadric(surface):
    """Whether a clamped Part.BSplineSurface, as a surface of rationals, lies on a quadric."""
    return _has_null_vector(_monomials(point) for point in _points(surface))


def _monomials(point):
    return [point[i] * point[j] for i, j in PAIRS]


def _points(surface):
    """Homogeneous points (w x, w y, w z, w) over Q of a surface, on a grid of every piece."""
    net = [
        [
            (*(Fraction(weight) * Fraction(x) for x in pole), Fraction(weight))
            for pole, weight in zip(*row)
        ]
        for row in zip(surface.getPoles(), surface.getWeights())
    ]
    in_u = _basis_rows(surface.UDegree, surface.getUKnots(), surface.getUMultiplicities())
    in_v = _basis_rows(surface.VDegree, surface.getVKnots(), surface.getVMultiplicities())
    for (i, u_values), (j, v_values) in itertools.product(in_u, in_v):
        yield [
            sum(
                a * b * net[i + k][j + m][c]
                for k, a in enumerate(u_values)
                for m, b in enumerate(v_values)
            )
            for c in range(4)
        ]


def _basis_rows(degree, knots, multiplicities):
    """First index and values of the degree + 1 B-splines at 2 degree + 1 places of each span."""
    flat = [Fraction(knot) for knot, m in zip(knots, multiplicities) for _ in range(m)]
    spans = [i for i in range(len(flat) - 1) if flat[i] < flat[i + 1]]
    shares = [Fraction(k, 2 * degree) for k in range(2 * degree + 1)]
    return [
        (i - degree, _basis(flat, i, degree, (1 - share) * flat[i] + share * flat[i + 1]))
        for i in spans
        for share in shares
    ]


def _basis(knots, span, degree, t):
    """The B-splines of a degree that live on the span, at t (Cox and de Boor)."""
    values = [Fraction(1)]
    for p in range(1, degree + 1):
        shares = [values[r] / (knots[span + r + 1] - knots[span + 1 - p + r]) for r in range(p)]
        values = [
            (shares[r - 1] * (t - knots[span - p + r]) if r else 0)
            + (shares[r] * (knots[span + r + 1] - t) if r < p else 0)
            for r in range(p + 1)
        ]
    return values


def _has_null_vector(rows):
    """Whether a matrix of rationals has a rank below its number of columns."""
    pivots = []
    for row in rows:
        row = list(row)
        for column, pivot in pivots:
            if row[column]:
                factor = row[column] / pivot[column]
                row = [x - factor * y for x, y in zip(row, pivot)]
        column = next((i for i, x in enumerate(row) if x), None)
        if column is not None:
            pivots.append((column, row))
        if len(pivots) == len(row):
            return False
    return True
