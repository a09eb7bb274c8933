# SPDX-License-Identifier: LGPL-2.1-or-later
"""The point of a family of spheres, lines or sections along a curve that is nearest to a given one.

A family has breaks(), between which it is smooth, and at(t, inside, points, distance): the value that
is zero at a characteristic point, and the deviation there, at parameters t of the spans that the
parameters `inside` lie in. Then `deviations_along` is its method `deviations`.
"""

import numpy as np

# Parameters between which a root is looked for, on each span: more than the characteristic
# equation of a span has roots in practice. A missed root shows as a deviation, never hides one.
_PARAMETERS_OF_SPAN = 16

# Points that are compared with all parameters at once, which bounds the memory.
_POINTS_AT_ONCE = 64

# Halvings of such a step, to the last place: at distance 0 the deviation is not stationary.
_HALVINGS = 50

# A point at the very end of a span has its root there, give or take the rounding: looked for a
# little beyond, as part of the span.
_BEYOND_END = 1e-7


def deviations_along(family, points, normals, distance):
    """The least deviation at a root of the family's equation; all roots are found without normals."""
    starts = range(0, len(points), _POINTS_AT_ONCE)
    blocks = [points[start : start + _POINTS_AT_ONCE] for start in starts]
    return np.concatenate([_of_block(family, block, distance) for block in blocks])


def _of_block(family, points, distance):
    breaks = family.breaks()
    t, inside = _parameters(breaks)
    slope, _ = family.at(t, inside, points[:, None, None], distance)
    sizes = np.full(len(points), np.inf)
    for owners, roots, spans in (
        _roots(family, points, distance, slope, t, inside),
        _roots_at_corners(slope, breaks, inside),
    ):
        _, found = family.at(roots, spans, points[owners], distance)
        np.minimum.at(sizes, owners, np.abs(found))
    # Nearest to a point beyond the ends is an end.
    ends, spans = breaks[[0, -1]], inside[[0, -1], 0]
    _, found = family.at(ends, spans, points[:, None], distance)
    return np.where(np.isinf(sizes), np.abs(found).min(axis=1), sizes)


def _parameters(breaks):
    """Parameters (s, k) of each span, from before its start to beyond its end, and one inside."""
    first, width = breaks[:-1, None], np.diff(breaks)[:, None]
    inner = (np.arange(_PARAMETERS_OF_SPAN) + 0.5) / _PARAMETERS_OF_SPAN
    parts = np.concatenate([[-_BEYOND_END], inner, [1 + _BEYOND_END]])
    return first + width * parts, first + width / 2


def _roots(family, points, distance, slope, t, inside):
    """The zeros (i,) of the slope on all spans, with the points that they belong to."""
    owners, spans, steps = np.nonzero(np.sign(slope[..., :-1]) != np.sign(slope[..., 1:]))
    low, high, inside = t[spans, steps], t[spans, steps + 1], inside[spans, 0]
    rises = slope[owners, spans, steps] < 0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        value, _ = family.at(middle, inside, points[owners], distance)
        is_before = (value < 0) == rises
        low, high = np.where(is_before, middle, low), np.where(is_before, high, middle)
    return owners, (low + high) / 2, inside


def _roots_at_corners(slope, breaks, inside):
    """Where the slope changes its sign from one span to the next, the corner itself."""
    owners, corners = np.nonzero(np.sign(slope[:, :-1, -1]) != np.sign(slope[:, 1:, 0]))
    return owners, breaks[corners + 1], inside[corners, 0]
