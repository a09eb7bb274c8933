# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conics that move along a spine.

The surface has the points x in the plane of a section, (x - m).m' = 0 or with a fixed normal, or m'
less its part along up, for m'. Their coordinates p to the side and q upwards have
(p / a)^2 + (q / b)^2 = 1 or, from the vertex, p^2 = 2 R q - (1 + K) q^2.
"""

from typing import Any, NamedTuple

import numpy as np

from pnsurfaces.definition.along_curve import deviations_along
from pnsurfaces.definition.vectors import dot, length


class Sections(NamedTuple):
    """Conics along a spine: the PiecewiseRational functions of its points (3) and their laws (1).

    `conic` is Ellipse or VertexConic. `up` (3,) and `normal` (3,), or None where the planes are
    perpendicular to the spine or, as `planes` says, upright.
    """

    spine: Any
    laws: Any
    conic: Any
    up: Any
    normal: Any = None
    planes: str = "perpendicular"

    @property
    def words(self):
        return f"{self.conic.words}: distance in the plane of the section, to first order"

    deviations = deviations_along

    def breaks(self):
        return np.unique(np.concatenate([self.spine.breaks, *(law.breaks for law in self.laws)]))

    def at(self, t, inside, points, distance):
        centre, speed = self.spine.with_derivative(t, inside)
        across = speed if self.normal is None else np.broadcast_to(self.normal, speed.shape)
        rays = points - centre
        side = np.cross(across, self.up)
        if self.planes == "upright":
            across = np.cross(self.up, side)
        conic = self.conic(*(law.with_derivative(t, inside)[0][..., 0] for law in self.laws))
        p, q = (dot(rays, axis) / length(axis) for axis in (side, np.cross(side, across)))
        return dot(rays, across), conic.deviation(p, q)


class Ellipse(NamedTuple):
    """Ellipses around the spine with half-axes (...) to the side and upwards."""

    half_width: Any
    half_height: Any

    words = "ellipses along the spine"

    def deviation(self, p, q):
        a, b = self
        return ((p / a) ** 2 + (q / b) ** 2 - 1) / (2 * np.hypot(p / a**2, q / b**2))


class VertexConic(NamedTuple):
    """Conics upwards from their vertex on the spine: radius of curvature, conic constant, depth.

    Which way is up after a place where the spine runs along the direction upwards is not known
    here: the nearer side counts. The depth is where edges are cut, which are not looked at here.
    """

    radius: Any
    constant: Any
    depth: Any

    words = "conics with their vertex on the spine"

    def deviation(self, p, q):
        return np.minimum(self._of_upper(p, q), self._of_upper(p, -q))

    def _of_upper(self, p, q):
        value = p**2 - 2 * self.radius * q + (1 + self.constant) * q**2
        return np.abs(value) / (2 * np.hypot(p, (1 + self.constant) * q - self.radius))
