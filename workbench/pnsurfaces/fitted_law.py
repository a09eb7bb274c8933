# SPDX-License-Identifier: LGPL-2.1-or-later
"""Radius laws that are no splines, followed by cubic splines over the stretches of a spine.

On each stretch the spline is C2 and has the exact slopes of the law at both ends. Where stretches
meet it turns as the law does: a law that is smooth in the length of a spine stays so across a joint
at which the spine's parameter changes its speed.
"""

import numpy as np

from pnsurfaces.cubic_spline import clamped_ends, cubic_spline, spline_slopes
from pnsurfaces.edge_chain import CONFUSION
from pnsurfaces.spline_fit import (
    Fit,
    halved_until_close,
    hermite_segments,
    measured_deviations,
)


def fitted_law(function, spine, tolerance):
    """Knots, multiplicities and coefficients of the cubic spline that follows `function` along a
    spine within a tolerance in millimetres, and a tuple of the Fit.

    `function` has radius(stretch, t) and slope(stretch, t), and `what` it is called.

    Raises FitError when the function is not smooth on a stretch.
    """
    pieces = [_piece(function, stretch, tolerance) for stretch in spine.stretches]
    knots = np.concatenate([pieces[0][0][:1], *(knots[1:] for knots, _, _ in pieces)])
    multiplicities = [4]
    for piece_knots, _, _ in pieces:
        multiplicities += [1] * (len(piece_knots) - 2) + [3]
    multiplicities[-1] = 4
    coefficients = np.concatenate(
        [pieces[0][1][:1], *(coefficients[1:] for _, coefficients, _ in pieces)]
    )
    deviation = max(deviation for _, _, deviation in pieces)
    if spine.closed:
        # Its last sphere is its first one, which the function gives within its rounding.
        gap = abs(coefficients[-1] - coefficients[0])
        if gap <= CONFUSION:
            coefficients[-1] = coefficients[0]
            deviation += gap
    return knots, multiplicities, coefficients, (Fit(function.what, deviation, proven=False),)


def _piece(function, stretch, tolerance):
    """Knots, coefficients and deviation of the spline over one stretch."""
    ends = clamped_ends(*(function.slope(stretch, t) for t in (stretch.begin, stretch.end)))

    def values_at(knots):
        return np.array([function.radius(stretch, t) for t in knots])

    def deviations(knots):
        values = values_at(knots)
        slopes = spline_slopes(knots, values, ends)
        segments = hermite_segments(knots, values[:, None], slopes[:, None])
        return measured_deviations(lambda t: function.radius(stretch, t), knots, segments)

    knots, deviation = halved_until_close(stretch.breaks, deviations, tolerance, function.what)
    return knots, cubic_spline(knots, values_at(knots), ends), deviation
