# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slopes at the points of a triangulation, from values there alone, with NumPy."""

import numpy as np

# A point looks so many edges far for those that tell how the values change around it: two rings
# determine the five further coefficients of a quadratic polynomial with some to spare.
_RINGS = 2


def estimated_slopes(places, values, triangles):
    """Derivatives (n, 2, k) by both coordinates of values (n, k) at places (n, 2) in the plane.

    triangles (m, 3) tell which points are neighbours. At each point it is the gradient of the
    quadratic polynomial that has its value and is the least-squares fit to its neighbours and theirs,
    the shortest one where these are too few. What is quadratic is met exactly, but for rounding.
    """
    return np.array(
        [
            _slope(places[near] - places[i], values[near] - values[i])
            for i, near in enumerate(_neighbourhoods(len(places), triangles))
        ]
    )


def _neighbourhoods(count, triangles):
    """For each point the numbers of those that are at most so many edges away, without itself."""
    touches = np.zeros((count, count), dtype=bool)
    for a, b, c in triangles:
        touches[np.ix_([a, b, c], [a, b, c])] = True
    reached = np.eye(count, dtype=bool)
    for _ in range(_RINGS):
        reached = reached @ touches
    np.fill_diagonal(reached, False)
    return [np.nonzero(row)[0] for row in reached]


def _slope(steps, changes):
    if not len(steps):
        return np.zeros((2, changes.shape[1]))
    # In parts of their size, so that the shortest solution does not depend on the unit of length.
    size = np.abs(steps).max()
    x, y = (steps / size).T
    terms = np.column_stack([x, y, x * x, x * y, y * y])
    coefficients, *_ = np.linalg.lstsq(terms, changes, rcond=None)
    return coefficients[:2] / size
