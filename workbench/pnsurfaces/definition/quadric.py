# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quadrics at a distance d: the points x with a foot p, q(p) = 0 and x - p along grad q(p)."""

from typing import NamedTuple

import numpy as np

from pnsurfaces.definition.newton import NEWTON_STEPS
from pnsurfaces.definition.vectors import dot, length


class Quadric(NamedTuple):
    """A quadric squares.x^2 + line.x + constant = 0 in its standard position."""

    squares: np.ndarray
    line: np.ndarray
    constant: float

    words = "feet on the quadric: distance from it along its normal"

    def deviations(self, points, normals, distance):
        # Beyond a singular point the normal of the parametrization is on the other side.
        both = [self._by_newton(points, side * normals, distance) for side in (1, -1)]
        return np.minimum(*both)

    def _by_newton(self, points, normals, distance):
        feet = points - distance * normals
        gradient = 2 * self.squares * feet + self.line
        factor = distance * dot(normals, gradient) / dot(gradient, gradient)
        for _ in range(NEWTON_STEPS):
            feet, factor = self._improved(points, feet, factor)
        return np.abs(length(points - feet) - abs(distance))

    def _improved(self, points, feet, factor):
        """A Newton step for the system  foot + factor grad q(foot) = point,  q(foot) = 0."""
        gradient = 2 * self.squares * feet + self.line
        matrix = np.zeros((len(feet), 4, 4))
        matrix[:, range(3), range(3)] = 1 + 2 * factor[:, None] * self.squares
        matrix[:, :3, 3] = matrix[:, 3, :3] = gradient
        value = feet**2 @ self.squares + feet @ self.line + self.constant
        residual = np.column_stack([feet + factor[:, None] * gradient - points, value])
        step = np.matmul(np.linalg.pinv(matrix), residual[..., None])[..., 0]
        return feet - step[:, :3], factor - step[:, 3]
