# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mirrors and the light they reflect, by the law of reflection at 60 digits.

Nothing here is taken from the kernel, which finds the wavefronts from planes.
"""

from dataclasses import dataclass
from math import comb
from types import SimpleNamespace

import numpy as np
from splines import exactly, norm


def bezier(poles, weights=None):
    """A Bezier patch over [0, 1]^2 as the kernel takes it."""
    m, n = (count - 1 for count in np.shape(poles)[:2])
    return SimpleNamespace(
        u_degree=m,
        v_degree=n,
        u_knots=[0, 1],
        v_knots=[0, 1],
        u_multiplicities=[m + 1, m + 1],
        v_multiplicities=[n + 1, n + 1],
        poles=np.asarray(poles),
        weights=weights,
    )


def random_mirror(random, m, n, is_rational):
    x, y = np.meshgrid(np.linspace(0, 10, m + 1), np.linspace(0, 8, n + 1), indexing="ij")
    poles = np.stack([x, y, random.uniform(0, 1, x.shape)], axis=-1)
    return bezier(poles, random.uniform(0.8, 1.3, x.shape) if is_rational else None)


def _bernstein(degree, t):
    """The basis functions and their derivatives, two vectors (degree + 1,)."""

    def values(n):
        return np.array([comb(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)], dtype=object)

    lower = values(degree - 1)
    return values(degree), degree * (np.append(0, lower) - np.append(lower, 0))


@dataclass(frozen=True)
class Mirror:
    """A Bezier patch in homogeneous coordinates (m + 1, n + 1, 4)."""

    homogeneous: np.ndarray

    @staticmethod
    def of(patch):
        poles = exactly(patch.poles)
        weights = exactly(np.ones(poles.shape[:2]) if patch.weights is None else patch.weights)
        return Mirror(np.concatenate([poles * weights[..., None], weights[..., None]], axis=-1))

    def point_and_normal(self, u, v):
        """The normal of any length."""
        m, n = (count - 1 for count in self.homogeneous.shape[:2])
        (a, a1), (b, b1) = _bernstein(m, u), _bernstein(n, v)
        at, by_u, by_v = (
            np.tensordot(x, np.tensordot(y, self.homogeneous, (0, 1)), (0, 0))
            for x, y in ((a, b), (a1, b), (a, b1))
        )
        x = at[:3] / at[3]
        return x, np.cross(by_u[:3] - by_u[3] * x, by_v[:3] - by_v[3] * x)


@dataclass(frozen=True)
class ParallelLight:
    """Rays of one direction; their way is counted from the plane through `start`."""

    direction: np.ndarray
    start: np.ndarray

    def arguments(self):
        """Those of pn.mirror."""
        return {"direction": self.direction, "start": self.start}

    def way(self, point):
        return (point - exactly(self.start)) @ self.ray(point)

    def ray(self, point):
        return exactly(self.direction) / norm(exactly(self.direction))


@dataclass(frozen=True)
class PointLight:
    source: np.ndarray

    def arguments(self):
        """Those of pn.mirror."""
        return {"source": self.source}

    def way(self, point):
        return norm(point - exactly(self.source))

    def ray(self, point):
        arm = point - exactly(self.source)
        return arm / norm(arm)


def reflected(mirror, light, u, v, distance):
    """The point of the wavefront from the point of the mirror at (u, v), so far on its way."""
    x, normal = mirror.point_and_normal(u, v)
    ray = light.ray(x)
    ray = ray - 2 * (ray @ normal) / (normal @ normal) * normal
    return x + (distance - light.way(x)) * ray
