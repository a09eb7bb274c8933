# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two-parameter families of spheres by their definition at 60 digits: centre, radius, normals.

Nothing here is taken from the kernel: normals come from (u, v) by a square root, where the kernel
finds (u, v) from rational normals.
"""

from dataclasses import dataclass

import mpmath
import numpy as np
from mpmath import mpf
from splines import exactly

EXPONENTS = [(2, 0, 0), (1, 1, 0), (0, 2, 0), (1, 0, 1), (0, 1, 1), (0, 0, 2)]


def unit_normal(by_u, by_v, sign):
    """The unit vector n with n.m_u + r_u = n.m_v + r_v = 0 and the sign of n.(m_u x m_v)."""
    m_u, m_v, r_u, r_v = by_u[:3], by_v[:3], by_u[3], by_v[3]
    across = np.cross(m_u, m_v)
    square = across @ across
    # n = a m_u + b m_v + c across: a and b from the two equations, c from |n| = 1.
    e, f, g = m_u @ m_u, m_u @ m_v, m_v @ m_v
    a, b = (-g * r_u + f * r_v) / square, (-e * r_v + f * r_u) / square
    tangential = a * m_u + b * m_v
    c = sign * mpmath.sqrt((1 - tangential @ tangential) / square)
    return tangential + c * across


def orientations(surface, places, step=1e-5):
    """(S_u x S_v).n at places (n, 2) of a surface, up to a positive factor, by differences."""
    places = np.asarray(places)
    here, normals = surface.evaluate(*places.T)
    by_u, by_v = (surface.evaluate(*(places + aside).T)[0] - here for aside in ([step, 0], [0, step]))
    return (np.cross(by_u, by_v) * normals).sum(axis=1)


@dataclass(frozen=True)
class Family:
    """A quadratic triangular Bezier surface of (m, r)."""

    control: np.ndarray  # (6, 4)

    @staticmethod
    def of(spheres):
        return Family(exactly(spheres))

    def sphere(self, u, v):
        """(m, r), with derivatives by u and by v: three vectors (4,)."""
        w = 1 - u - v
        b200, b110, b020, b101, b011, b002 = self.control
        at_u = u * b200 + v * b110 + w * b101
        at_v = u * b110 + v * b020 + w * b011
        at_w = u * b101 + v * b011 + w * b002
        return u * at_u + v * at_v + w * at_w, 2 * (at_u - at_w), 2 * (at_v - at_w)

    def second_derivatives(self):
        """By u u, u v and v v of (m, r): three vectors (4,)."""
        b200, b110, b020, b101, b011, b002 = self.control
        return (
            2 * (b200 - 2 * b101 + b002),
            2 * (b110 - b101 - b011 + b002),
            2 * (b020 - 2 * b011 + b002),
        )

    def normal(self, u, v, sign):
        """The unit normal n with n.m_u + r_u = n.m_v + r_v = 0 and the sign of n.(m_u x m_v)."""
        _, by_u, by_v = self.sphere(u, v)
        return unit_normal(by_u, by_v, sign)

    def point(self, u, v, sign, distance=0):
        sphere, _, _ = self.sphere(u, v)
        return sphere[:3] + (sphere[3] + mpf(distance)) * self.normal(u, v, sign)

    def parameters(self, point, sign, distance, start):
        """(u, v) of the point of the skin nearest to `point`, by Newton's method."""

        def residues(u, v):
            away = point - self.point(u, v, sign, distance)
            _, by_u, by_v = self.sphere(u, v)
            return away @ by_u[:3], away @ by_v[:3]

        return tuple(mpmath.findroot(residues, start, tol=1e-60, maxsteps=50))


def random_spheres(random, sag=0.05, side=100, dome=False):
    """Control spheres of a bent plate of varying thickness, in any position."""
    angle = random.uniform(0.87, 1.31)
    u = np.array([side, 0, 0])
    v = side * np.array([np.cos(angle), np.sin(angle), 0])
    w = np.zeros(3)
    centres = np.array([u, (u + v) / 2, v, (u + w) / 2, (v + w) / 2, w])
    for middle in (1, 3, 4):
        height = random.uniform(0.5, 1.5) if dome else random.normal()
        centres[middle] += side * np.array([*(0.03 * random.normal(size=2)), sag * height])
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    radii = 0.03 * side * random.uniform(0.75, 1.25, 6)
    return np.column_stack([centres @ turn.T, radii])
