# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spheres c(u) + d(v) of two splines by their definition at 60 digits: centre, radius, normals.

Nothing here is taken from the kernel: normals come from (u, v) by a square root, where the kernel
finds v from rational normals.
"""

from dataclasses import dataclass

import mpmath
import numpy as np
from mpmath import mpf
from sphere_families import unit_normal
from splines import Spline


@dataclass(frozen=True)
class Translation:
    """The spheres of two splines of (x, y, z, r), added."""

    c: Spline
    d: Spline

    def sphere(self, u, v, spans=None):
        """(m, r), with derivatives by u and by v: three vectors (4,)."""
        i, j = spans or (self.c.span_at(u), self.d.span_at(v))
        at_c, by_u, _ = self.c.derivatives(mpf(u), i)
        at_d, by_v, _ = self.d.derivatives(mpf(v), j)
        return at_c + at_d, by_u, by_v

    def normal(self, u, v, sign, spans=None):
        """The unit normal n with n.m_u + r_u = n.m_v + r_v = 0 and the sign of n.(m_u x m_v)."""
        _, by_u, by_v = self.sphere(u, v, spans)
        return unit_normal(by_u, by_v, sign)

    def point(self, u, v, sign, distance=0, spans=None):
        sphere, _, _ = self.sphere(u, v, spans)
        return sphere[:3] + (sphere[3] + mpf(distance)) * self.normal(u, v, sign, spans)

    def places(self, count):
        """So many (u, v) in each span of either curve, away from the joints."""

        def inside(curve):
            parts = (np.arange(count) + 0.5) / count
            return np.concatenate(
                [
                    low + (high - low) * parts
                    for low, high in zip(curve.knots, curve.knots[1:], strict=False)
                ]
            )

        return [(u, v) for u in inside(self.c) for v in inside(self.d)]

    def parameters(self, point, sign, distance):
        """(u, v) of the point of the skin nearest to `point`, by Newton's method."""

        def gap(place):
            return float(sum((self.point(*place, sign, distance) - point) ** 2))

        place = min(self.places(3), key=gap)
        spans = self._spans_at(place)
        for _ in range(3):  # the nearest point may lie beyond a joint
            place = self._nearest(point, sign, distance, place, spans)
            if spans == self._spans_at(place):
                return place
            spans = self._spans_at(place)
        raise AssertionError("between two spans, in neither")

    def _spans_at(self, place):
        return self.c.span_at(place[0]), self.d.span_at(place[1])

    def _nearest(self, point, sign, distance, start, spans):
        def residues(u, v):
            away = point - self.point(u, v, sign, distance, spans)
            _, by_u, by_v = self.sphere(u, v, spans)
            return away @ by_u[:3], away @ by_v[:3]

        return tuple(mpmath.findroot(residues, start, tol=1e-60, maxsteps=50))


def arch(random, direction, spans=1, sag=0.05, side=100):
    """A curve of spheres of varying radius, bent upwards, in the direction of a unit vector."""
    parts = np.array([0, *((np.arange(spans) + 0.5) / spans), 1])
    parts = parts + random.normal(scale=0.03 / spans, size=parts.shape)
    centres = np.outer(side * parts, direction)
    centres[:, 2] += side * sag * 4 * parts * (1 - parts) * random.uniform(0.9, 1.1, parts.shape)
    radii = 0.015 * side * random.uniform(0.75, 1.25, parts.shape)
    spheres = np.column_stack([centres, radii])
    return Spline(
        2, tuple(range(spans + 1)), (3, *[1] * (spans - 1), 3), spheres, np.ones(len(spheres))
    )


def random_translation(random, spans=(1, 1), sag=0.05):
    """A bent plate of varying thickness."""
    angle = random.uniform(0.87, 1.31)
    directions = np.array([1, 0, 0]), np.array([np.cos(angle), np.sin(angle), 0])
    signs = random.choice([-1, 1], 2)
    return Translation(
        *(
            arch(random, direction, count, sag * sign)
            for direction, count, sign in zip(directions, spans, signs, strict=True)
        )
    )
