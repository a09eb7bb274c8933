# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wavefronts of a mirror by Huygens' principle.

That of path length d is the envelope of the spheres |x - m(u, v)| = d - s(u, v) around the points of
the mirror, where s is the path of the light to m.
"""

from typing import Any, NamedTuple

import numpy as np

from pnsurfaces.definition.newton import NEWTON_STEPS, improved
from pnsurfaces.definition.vectors import dot, length
from pnsurfaces.spline_grid import Jet, jet_at, spread

# Parameters along each side of a mirror, from the best of which Newton's method starts.
_GRID_OF_MIRROR = 33

# Of so many of them.
_STARTS = 3


class Huygens(NamedTuple):
    """The spheres around the points of a mirror, as the light that reaches them makes them grow.

    `mirror` is a spline_grid.SplineSurface, `light` what mirror_wavefront.light_of gives.
    """

    mirror: Any
    light: dict

    words = (
        "spheres around the points of the mirror: distance from the centre minus the rest of the path"
    )

    def deviations(self, points, normals, distance):
        # Beyond a focal point the normal of the parametrization is on the other side.
        starts = [
            start for side in (1, -1) for start in self._starts(points, side * normals, distance)
        ]
        return np.min([self._by_newton(points, distance, *start) for start in starts], axis=0)

    def _by_newton(self, points, distance, u, v):
        for _ in range(NEWTON_STEPS):
            u, v = self._improved(points, distance, u, v)
        rays, radius, _, _ = self._at(points, distance, u, v)
        return np.abs(length(rays) - np.abs(radius))

    def _starts(self, points, normals, distance):
        """Parameters of a grid whose spheres have the points nearly at their normals.

        There are several pairs (u, v) of arrays (n,): near focal points some places of the mirror
        have rays that are close together.
        """
        u, v = (spread(knots, _GRID_OF_MIRROR) for knots in (self.mirror.u_knots, self.mirror.v_knots))
        centres = jet_at(self.mirror, u, v).point.reshape(-1, 3)
        radii = distance - self._path(centres)[0]
        shape = (len(u), len(v))
        best = np.array(
            [
                _lowest_valleys(length(point - centres - radii[:, None] * normal).reshape(shape))
                for point, normal in zip(points, normals)
            ]
        )
        rows, columns = np.unravel_index(best.T, shape)
        return list(zip(u[rows], v[columns]))

    def _path(self, centres):
        """Of the light to points (n, 3): length, gradient and second derivatives (n, 3, 3)."""
        if "source" in self.light:
            rays = centres - np.array(self.light["source"])
            distance = length(rays)
            gradient = rays / distance[:, None]
            across = np.eye(3) - gradient[:, :, None] * gradient[:, None, :]
            return distance, gradient, across / distance[:, None, None]
        direction = np.array(self.light["direction"]) / np.linalg.norm(self.light["direction"])
        distance = (centres - np.array(self.light["start"])) @ direction
        return distance, np.broadcast_to(direction, centres.shape), np.zeros((len(centres), 3, 3))

    def _at(self, points, distance, u, v):
        """Rays from the mirror, radii, the Jet (n, 3) of the mirror and the path."""
        jet = Jet(*(values[:, 0] for values in jet_at(self.mirror, u, v[:, None])))
        path = self._path(jet.point)
        return points - jet.point, distance - path[0], jet, path

    def _improved(self, points, distance, u, v):
        """A Newton step for  (x - m).m_i + (d - s) (d - s)_i = 0,  i = u, v."""
        rays, radius, jet, (_, gradient, second) = self._at(points, distance, u, v)
        slopes = (jet.u, jet.v)
        falls = [dot(gradient, slope) for slope in slopes]
        values = [dot(rays, slope) - radius * fall for slope, fall in zip(slopes, falls)]
        j_uu, j_uv, j_vv = (
            -dot(slopes[i], slopes[k])
            + falls[i] * falls[k]
            + dot(rays, bend)
            - radius * (dot(gradient, bend) + np.einsum("ni,nij,nj->n", slopes[i], second, slopes[k]))
            for i, k, bend in ((0, 0, jet.uu), (0, 1, jet.uv), (1, 1, jet.vv))
        )
        u, v = improved(u, v, values, (j_uu, j_uv, j_vv))
        return _within(self.mirror.u_knots, u), _within(self.mirror.v_knots, v)


def _lowest_valleys(heights):
    """The places (_STARTS,) of the lowest values of a grid that no neighbour is below, lowest first.

    Where there are fewer, other low places fill up.
    """
    m, n = heights.shape
    padded = np.pad(heights, 1, constant_values=np.inf)
    shifts = [(i, j) for i in range(3) for j in range(3) if (i, j) != (1, 1)]
    is_valley = np.all([heights <= padded[i : i + m, j : j + n] for i, j in shifts], axis=0)
    order = np.lexsort((heights.ravel(), ~is_valley.ravel()))
    return order[:_STARTS]


def _within(knots, parameters):
    return np.clip(parameters, knots[0], knots[-1])
