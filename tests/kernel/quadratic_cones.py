# SPDX-License-Identifier: LGPL-2.1-or-later
"""Families of quadratic cones and their envelopes by their definition at 60 digits."""

from dataclasses import dataclass

import numpy as np
from mpmath import mpf
from splines import Spline, norm

NEWTON_STEPS = 30
# F is stationary for more than one t: so many places to begin at, and more if none leads near [mm].
STARTS = (5, 60)
NEAR = 1e-9
ROUNDING = 1e-6  # by which points at the ends may be beyond


@dataclass(frozen=True)
class QuadraticCones:
    """The points v + d with d.M d = 0, for the vertices v and the directions M of each t."""

    vertex: Spline
    directions: Spline  # of nine numbers

    def arguments(self):
        """Those of pn.quadratic_cone_envelope. The weights are powers of two, so this is exact."""
        weights = self.vertex.weights[:, None]
        count = len(self.directions.poles)
        return (
            np.hstack([self.vertex.poles * weights, weights]),
            self.directions.poles.reshape(count, 3, 3),
        )

    def distance(self, point):
        """Of a point near the envelope, from the cone whose F = d.M d is stationary in t there.

        The gradient of F on the envelope is that at fixed t; |F| over its length is the distance, but
        for what is of second order in it.
        """
        nearest = np.inf
        for count in STARTS:
            for start in np.linspace(0, 1, count):
                try:
                    nearest = min(nearest, self._distance_from(point, mpf(start)))
                except ArithmeticError:
                    continue
            if nearest < NEAR:
                break
        return nearest

    def _distance_from(self, point, t):
        for _ in range(NEWTON_STEPS):
            arm, m, slope, bend = self._at(point, t)
            step = slope / bend
            t -= step
            if abs(step) < mpf(10) ** -45:
                break
        else:
            raise ArithmeticError("no stationary place")
        if not -ROUNDING < t < 1 + ROUNDING:
            raise ArithmeticError("a cone beyond the ends of the family")
        return abs(arm @ m @ arm) / norm(2 * (m @ arm))

    def _at(self, point, t):
        v, v1, v2 = self.vertex.derivatives(t, 0)
        m, m1, m2 = (np.reshape(x, (3, 3)) for x in self.directions.derivatives(t, 0))
        arm = point - v
        slope = arm @ m1 @ arm - 2 * (v1 @ m @ arm)
        bend = arm @ m2 @ arm - 4 * (v1 @ m1 @ arm) + 2 * (v1 @ m @ v1) - 2 * (v2 @ m @ arm)
        return arm, m, slope, bend


def random_cones(random):
    """Cones that open while they move, so that all of the envelope is finite; in any position."""
    count = int(random.integers(2, 4))
    places = np.linspace(0, 1, count)
    poles = np.outer(places, [0, 0, 10]) + random.uniform(-0.5, 0.5, (count, 3))
    weights = 2.0 ** random.integers(-1, 2, count) if random.random() < 0.3 else np.ones(count)
    growth, (a, b) = random.uniform(1, 4), random.uniform(0.5, 2, 2)
    noise = random.uniform(-0.02, 0.02, (2, 3, 3))
    matrices = [np.diag([a, b, -(1 + growth * end)]) + noise[end] + noise[end].T for end in (0, 1)]
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turned = [turn @ matrix @ turn.T for matrix in matrices]
    exact = [(matrix + matrix.T) / 2 for matrix in turned]  # symmetric, bit for bit
    size = 10 ** random.uniform(-2, 3)
    return QuadraticCones(
        Spline.bezier(size * poles @ turn.T, weights), Spline.bezier(np.reshape(exact, (2, 9)))
    )
