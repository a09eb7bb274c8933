# SPDX-License-Identifier: LGPL-2.1-or-later
"""Radius laws that are no splines, followed by cubic splines over the stretches of a spine.

On each stretch the spline is C2 and has the exact slopes of the law at both ends. Where stretches
meet it turns as the law does: a law that is smooth in the length of a spine stays so across a joint
at which the spine's parameter changes its speed.
"""

import itertools
from typing import Any, NamedTuple

import numpy as np

from pnsurfaces.cubic_spline import clamped_ends, cubic_spline, spline_slopes
from pnsurfaces.edge_chain import CONFUSION
from pnsurfaces.spline_fit import (
    Fit,
    bernstein,
    halved_until_close,
    hermite_segments,
    measured_deviations,
    samples,
)

# Polynomials of these degrees are tried before splines: with their rounding, the knots of a spline
# through a straight line would make a surface of ten times its degree.
_DEGREES = (0, 1, 2)


class _Spline(NamedTuple):
    """B-spline data of a law, and its deviation from the function that it follows."""

    degree: int
    knots: Any
    multiplicities: list
    coefficients: Any
    deviation: float


def fitted_law(function, spine, tolerance):
    """Degree, knots, multiplicities and coefficients of the law that follows `function` along a
    spine within a tolerance in millimetres, and a tuple of the Fit.

    `function` has radius(stretch, t) and slope(stretch, t), and `what` it is called. The law is a
    polynomial if one is close enough, else a cubic spline.

    Raises FitError when the function is not smooth on a stretch.
    """
    radii = sampled(function, spine)
    polynomials = (_polynomial(radii, spine, degree) for degree in _DEGREES)
    close = (law for law in polynomials if law.deviation <= tolerance)
    *law, deviation = _closed_up(next(close, None) or _spline(function, spine, tolerance), spine)
    return *law, (Fit(function.what, deviation, proven=False),)


def sampled(function, spine):
    """Pairs (parameter, radius), those at which a deviation is measured."""
    return np.array(
        [
            (t, function.radius(stretch, t))
            for stretch in spine.stretches
            for t in samples(stretch.breaks).flat
        ]
    )


def _polynomial(places, spine, degree):
    """The polynomial over the whole spine that is nearest to sampled radii by least squares."""
    first, last = spine.curve.domain
    parameters, radii = places.T
    basis = bernstein(degree, (parameters - first) / (last - first))
    coefficients = np.linalg.lstsq(basis, radii, rcond=None)[0]
    deviation = np.abs(basis @ coefficients - radii).max()
    order = degree + 1
    return _Spline(degree, [first, last], [order, order], coefficients, deviation)


def _spline(function, spine, tolerance):
    pieces = [_piece(function, stretch, tolerance) for stretch in spine.stretches]
    knots = [pieces[0].knots[:1], *(piece.knots[1:] for piece in pieces)]
    coefficients = [pieces[0].coefficients[:1], *(piece.coefficients[1:] for piece in pieces)]
    inner = [[1] * (len(piece.knots) - 2) for piece in pieces]
    multiplicities = [4, *itertools.chain(*((*ones, 3) for ones in inner))]
    multiplicities[-1] = 4
    deviation = max(piece.deviation for piece in pieces)
    return _Spline(3, np.concatenate(knots), multiplicities, np.concatenate(coefficients), deviation)


def _piece(function, stretch, tolerance):
    """The C2 cubic spline over one stretch; multiplicities are not asked of it."""
    ends = clamped_ends(*(function.slope(stretch, t) for t in (stretch.begin, stretch.end)))

    def values_at(knots):
        return np.array([function.radius(stretch, t) for t in knots])

    def deviations(knots):
        values = values_at(knots)
        slopes = spline_slopes(knots, values, ends)
        segments = hermite_segments(knots, values[:, None], slopes[:, None])
        return measured_deviations(lambda t: function.radius(stretch, t), knots, segments)

    knots, deviation = halved_until_close(stretch.breaks, deviations, tolerance, function.what)
    return _Spline(3, knots, [], cubic_spline(knots, values_at(knots), ends), deviation)


def _closed_up(law, spine):
    """On a closed spine the last radius is the first one, but for the rounding of the function."""
    gap = abs(law.coefficients[-1] - law.coefficients[0])
    if not spine.closed or gap > CONFUSION:
        return law
    coefficients = np.append(law.coefficients[:-1], law.coefficients[0])
    return law._replace(coefficients=coefficients, deviation=law.deviation + gap)
