# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quadratic triangles of spheres: their skins, and the boundary of the union of the balls.

The skins at distance d are the envelope of the spheres |x - m(u, v)| = r(u, v) + d: a point of it is
on one sphere and outside all its neighbours, (x - m).m_u + (r + d) r_u = 0 and likewise for v.
"""

from typing import NamedTuple

import numpy as np

from pnsurfaces.definition.newton import NEWTON_STEPS, improved
from pnsurfaces.definition.vectors import cross, dot, length

# Steps along the edges of a triangle of spheres, from the best of which Newton's method starts.
_GRID_OF_NET = 17

# Triangles of spheres from which a point is measured: that over which its centre lies, and those
# across the nearest edges.
_NEAREST_NETS = 3


class SphereNet(NamedTuple):
    """A quadratic triangle of spheres: the control spheres (6, 4) A, B, C, AB, BC, CA."""

    spheres: np.ndarray

    words = "spheres of the family: distance from the centre minus the radius"

    def deviations(self, points, normals, distance):
        u, v = self._start(points, normals, distance)
        for _ in range(NEWTON_STEPS):
            u, v = self._improved(points, distance, u, v)
        rays, radius, *_ = self._at(points, distance, u, v)
        return np.abs(length(rays) - np.abs(radius))

    def _start(self, points, normals, distance):
        """The parameters of a grid whose sphere has the point most nearly at its normal."""
        u, v = (grid.ravel() for grid in np.meshgrid(*[np.linspace(0, 1, _GRID_OF_NET)] * 2))
        u, v = u[u + v <= 1], v[u + v <= 1]
        rays, radius, *_ = self._at(points[:, None], distance, u, v)
        misses = length(rays - radius[..., None] * normals[:, None])
        best = misses.argmin(axis=1)
        return u[best], v[best]

    def _at(self, points, distance, u, v):
        """Rays from the centres, radii, and the derivatives of centre and radius by u and v."""
        a, b, c, ab, bc, ca = self.spheres
        u, v = u[..., None], v[..., None]
        w = 1 - u - v
        sphere = u * u * a + v * v * b + w * w * c + 2 * (u * v * ab + v * w * bc + u * w * ca)
        by_u = 2 * (u * (a - ca) + v * (ab - bc) + w * (ca - c))
        by_v = 2 * (u * (ab - ca) + v * (b - bc) + w * (bc - c))
        return points - sphere[..., :3], sphere[..., 3] + distance, by_u, by_v

    def _improved(self, points, distance, u, v):
        """A Newton step for  (x - m).m_i + (r + d) r_i = 0,  i = u, v."""
        rays, radius, *slopes = self._at(points, distance, u, v)
        values = [dot(rays, s[..., :3]) + radius * s[..., 3] for s in slopes]
        a, b, c, ab, bc, ca = self.spheres
        second = [2 * (a - 2 * ca + c), 2 * (ab - bc - ca + c), 2 * (b - 2 * bc + c)]
        (s_u, s_v) = slopes
        j_uu, j_uv, j_vv = (
            -dot(p[..., :3], q[..., :3]) + p[..., 3] * q[..., 3] + dot(rays, x[:3]) + radius * x[3]
            for p, q, x in zip((s_u, s_u, s_v), (s_u, s_v, s_v), second)
        )
        return improved(u, v, values, (j_uu, j_uv, j_vv))


class SphereNets(NamedTuple):
    """Quadratic triangles of spheres over the plane z = 0, side by side.

    corners (m, 3, 2) are theirs, A, B and C, in x and y; nets are their SphereNets.
    """

    corners: np.ndarray
    nets: list

    words = SphereNet.words

    def deviations(self, points, normals, distance):
        # Samples of a face may lie a little beyond its edge, where it goes on over the neighbour.
        candidates = self._nearest(points, normals, distance)
        return np.min([self._from(owners, points, normals, distance) for owners in candidates], axis=0)

    def _from(self, owners, points, normals, distance):
        found = np.empty(len(points))
        for owner in np.unique(owners):
            here = owners == owner
            found[here] = self.nets[owner].deviations(points[here], normals[here], distance)
        return found

    def _nearest(self, points, normals, distance):
        """The triangles (k, n) over or next to which the centre lies, the point at its normal."""
        radii = np.full(len(points), np.mean([net.spheres[:, 3] for net in self.nets]))
        for _ in range(NEWTON_STEPS):
            centres = points - (radii + distance)[:, None] * normals
            inside = self._barycentric(centres[:, None, :2])
            depths = inside.min(axis=-1)
            owners = depths.argmax(axis=1)
            chosen = inside[np.arange(len(points)), owners]
            for owner in np.unique(owners):
                here = owners == owner
                u, v, w = chosen[here].T
                a, b, c, ab, bc, ca = self.nets[owner].spheres[:, 3]
                radii[here] = (
                    u * u * a + v * v * b + w * w * c + 2 * (u * v * ab + v * w * bc + u * w * ca)
                )
        return np.argsort(-depths, axis=1)[:, :_NEAREST_NETS].T

    def _barycentric(self, places):
        """The coordinates (n, m, 3) of places (n, 1, 2) in all triangles."""
        a, b, c = self.corners.transpose(1, 0, 2)
        area = cross(a - c, b - c)
        u, v = cross(places - c, b - c) / area, cross(a - c, places - c) / area
        return np.stack([u, v, 1 - u - v], axis=-1)


class BallNet(NamedTuple):
    """The union of the balls of a quadratic triangle of spheres, as SphereNet.

    Its boundary touches a sphere inside the triangle, or one of an edge among those of the edge, or a
    corner.
    """

    spheres: np.ndarray

    words = "balls of the family: distance from the boundary of their union"

    def deviations(self, points, normals, distance):
        a, b, c, ab, bc, ca = self.spheres
        edges = ((a, ab, b), (b, bc, c), (c, ca, a))
        parts = [
            SphereNet(self.spheres).deviations(points, normals, distance),
            *(_from_edge(np.array(edge), points, distance) for edge in edges),
            *(_from_sphere(corner, points, distance) for corner in (a, b, c)),
        ]
        return np.min(parts, axis=0)


def _from_edge(spheres, points, distance):
    """How far points are from the envelope of the spheres (3, 4) of a quadratic Bezier curve."""
    a, ab, b = spheres
    t = np.linspace(0, 1, _GRID_OF_NET)[:, None]
    start = (1 - t) ** 2 * a + 2 * t * (1 - t) * ab + t**2 * b
    gaps = length(points[:, None] - start[:, :3]) - start[:, 3]
    t = t[gaps.argmin(axis=1)]
    for _ in range(NEWTON_STEPS):
        sphere = (1 - t) ** 2 * a + 2 * t * (1 - t) * ab + t**2 * b
        slope, bend = 2 * ((1 - t) * (ab - a) + t * (b - ab)), 2 * (a - 2 * ab + b)
        rays, radius = points - sphere[:, :3], sphere[:, 3] + distance
        value = dot(rays, slope[:, :3]) + radius * slope[:, 3]
        change = (
            dot(rays, bend[:3]) + radius * bend[3] - dot(slope[:, :3], slope[:, :3]) + slope[:, 3] ** 2
        )
        t = np.clip(t - (value / change)[:, None], 0, 1)
    sphere = (1 - t) ** 2 * a + 2 * t * (1 - t) * ab + t**2 * b
    return np.abs(length(points - sphere[:, :3]) - np.abs(sphere[:, 3] + distance))


def _from_sphere(sphere, points, distance):
    return np.abs(length(points - sphere[:3]) - np.abs(sphere[3] + distance))
