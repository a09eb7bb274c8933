# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splines through a function, their intervals halved until they follow it as closely as asked.

What is fitted is not exact any more: a Fit says by how much, and whether that is proved.
"""

import math
from typing import NamedTuple

import numpy as np

# How far a spline may be from what it follows, in millimetres: what the most widespread CAD kernels
# take for the same point, a hundredth of a micrometre. A tenth of it needs up to twice the spans.
FIT_TOLERANCE = 1e-5

# A function that needs shorter intervals than this share of the whole has a kink or a pole: each
# halving divides the deviation from a smooth function by 16 or 64.
SHORTEST_INTERVAL = 1 / 2048

# Inside each interval the deviation is measured at these shares of it. The middle, where that of
# Hermite interpolation is largest, is one of them; the others are irrational, so that no waves are
# seen at their zeros only.
_SHARES = (1 - np.cos(np.pi * (np.arange(9) + 0.5) / 9)) / 2


class FitError(ValueError):
    """No spline follows the function as closely as asked. The text is a sentence for the user."""


class Fit(NamedTuple):
    """That `what` was replaced by a spline: how far off that is in mm, and whether it is proved."""

    what: str
    deviation: float
    proven: bool

    def note(self):
        """A sentence for the user."""
        return f"Fitted within {deviation_of([self])}: {self.what}."


def deviation_of(fits):
    """How far several fits may be off together, as text: "9.1e-07 mm, measured"."""
    total = sum(fit.deviation for fit in fits)
    how = "proven" if all(fit.proven for fit in fits) else "measured"
    return f"{total:.1e} mm, {how}" if fits else "0 mm"


def halved_until_close(knots, deviations, tolerance, what):
    """The knots (n,), intervals halved where they must be, and the largest deviation that is left.

    `deviations` gives those (n - 1,) of the spline over knots (n,). Raises FitError where no
    halving helps; `what` names the function there.
    """
    knots = np.asarray(knots, dtype=float)
    shortest = SHORTEST_INTERVAL * (knots[-1] - knots[0])
    while True:
        found = deviations(knots)
        far = ~(found <= tolerance)
        if not far.any():
            return knots, found.max()
        steps = np.diff(knots)
        if steps[far].min() <= shortest:
            worst = np.argmax(far & (steps <= shortest))
            raise FitError(
                f"No fit: {what} has a kink or a jump near parameter {knots[worst]:.6g}. There"
                f" {found[worst]:.2g} mm are left, more than the tolerance of {tolerance:.2g} mm."
            )
        knots = np.sort(np.concatenate([knots, (knots[:-1] + knots[1:])[far] / 2]))


def samples(knots):
    """The parameters at which a deviation is measured, a row for each interval."""
    return knots[:-1, None] + np.diff(knots)[:, None] * _SHARES


def measured_deviations(function, knots, segments):
    """The largest distance (n - 1,) of Bezier segments (n - 1, order, dim) from a function of t."""
    basis = bernstein(segments.shape[1] - 1, _SHARES)
    points = np.einsum("sk,nkd->nsd", basis, segments)
    true = np.array([[function(t) for t in row] for row in samples(knots)]).reshape(points.shape)
    return np.linalg.norm(points - true, axis=2).max(axis=1)


def hermite_segments(knots, values, slopes, *bends):
    """Bezier segments (n - 1, order, dim) with these derivatives (n, dim) at both ends.

    They are cubic by values and slopes, quintic with second derivatives as well.
    """
    steps = np.diff(knots)[:, None]
    degree = 5 if bends else 3
    first = _end_poles(degree, steps, values[:-1], slopes[:-1], *(b[:-1] for b in bends))
    last = _end_poles(degree, -steps, values[1:], slopes[1:], *(b[1:] for b in bends))
    return np.stack([*first, *reversed(last)], axis=1)


def quintic_spline(knots, values, slopes, bends):
    """B-spline multiplicities (n,) and coefficients (3 n, dim) of the quintic Hermite spline.

    A coefficient is the blossom at five successive knots, three of which are the same: so the inner
    knots are triple, and the spline is C2 whatever the rounding.
    """
    steps = np.diff(knots)[:, None]
    before = -np.insert(steps, 0, 0.0, axis=0)
    after = np.append(steps, [[0.0]], axis=0)
    blossoms = [
        values + slopes * (one + other) / 5 + bends * one * other / 20
        for one, other in ((before, before), (before, after), (after, after))
    ]
    multiplicities = [6] + [3] * (len(knots) - 2) + [6]
    return multiplicities, np.stack(blossoms, axis=1).reshape(3 * len(knots), -1)


def _end_poles(degree, steps, values, slopes, bends=None):
    poles = [values, values + steps * slopes / degree]
    if bends is not None:
        poles.append(
            values + 2 * steps * slopes / degree + steps**2 * bends / (degree * (degree - 1))
        )
    return poles


def bernstein(degree, shares):
    """The Bernstein polynomials of a degree at shares of their interval, one row for each share."""
    return np.array(
        [
            [math.comb(degree, k) * s**k * (1 - s) ** (degree - k) for k in range(degree + 1)]
            for s in shares
        ]
    )
