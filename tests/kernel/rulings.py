# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ruled surfaces and envelopes of cones by their definition, at 60 digits.

The spheres about c(t, v) = (1 - v) c0(t) + v c1(t) of radius r(t, v), linear in v too, envelop the
surface; points, r = 0, sweep the ruled surface itself.
"""

from dataclasses import dataclass

import mpmath
import numpy as np
import pnkernel as pn
from mpmath import mpf
from splines import Spline, norm


@dataclass(frozen=True)
class Cones:
    """Two families of spheres over the same knots. radii: two laws, or none for lines."""

    centres: tuple
    radii: tuple = ()

    def surface(self):
        curves = [pn.Curve.bspline(*spline.arguments) for spline in self.centres]
        if not self.radii:
            return pn.ruled_surface(*curves)
        laws = [pn.Law.bspline(*spline.arguments) for spline in self.radii]
        return pn.cone_envelope(curves[0], laws[0], curves[1], laws[1])

    @property
    def size(self):
        return float(max(np.abs(spline.poles).max() for spline in self.centres))

    def spheres(self, t, v, span):
        """(c, c_t, c_v, c_tt, c_tv) and the same of r."""
        centre = _between([s.derivatives(t, span) for s in self.centres], v)
        if not self.radii:
            return centre, [mpf(0)] * 5
        return centre, [x[0] for x in _between([s.derivatives(t, span) for s in self.radii], v)]

    def foot(self, point, t, v, span):
        """(t, v) of the sphere that touches at the point: the zero, by Newton's method, of
        (x - c).c_t + r_t |x - c| and of the same by v."""
        t, v = mpf(t), mpf(v)
        for _ in range(40):
            (c, c1, c2, c11, c12), (_, r1, r2, r11, r12) = self.spheres(t, v, span)
            arm = point - c
            length = norm(arm) if self.radii else mpf(1)
            first, second = arm @ c1 + r1 * length, arm @ c2 + r2 * length
            shrink1, shrink2 = (arm @ c1) / length, (arm @ c2) / length
            matrix = [
                [
                    arm @ c11 - c1 @ c1 + r11 * length - r1 * shrink1,
                    arm @ c12 - c1 @ c2 + r12 * length - r1 * shrink2,
                ],
                [arm @ c12 - c1 @ c2 + r12 * length - r2 * shrink1, -c2 @ c2 - r2 * shrink2],
            ]
            determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0]
            step_t = (first * matrix[1][1] - second * matrix[0][1]) / determinant
            step_v = (second * matrix[0][0] - first * matrix[1][0]) / determinant
            t, v = t - step_t, v - step_v
            if abs(step_t) + abs(step_v) < mpf(10) ** -45:
                return t, v
        raise ArithmeticError(f"no foot near ({t}, {v})")

    def start(self, point, t, span):
        """Roughly v of the sphere on the ruling of t."""
        c, _, g, _, _ = self.spheres(t, mpf(0), span)[0]
        return (point - c) @ g / (g @ g)

    def contact(self, point, distance, t, span):
        """(t, v, signed distance) of the point; its spheres have the radius r + distance."""
        t, v = self.foot(point, t, self.start(point, mpf(t), span), span)
        (c, c1, c2, _, _), (r, *_) = self.spheres(t, v, span)
        arm, across = point - c, np.cross(c1, c2)
        if not self.radii:
            return t, v, arm @ across / norm(across)
        if mpf(distance) + r > 0:
            assert arm @ across > 0
        return t, v, mpmath.sign(arm @ across) * norm(arm) - r


def _between(pair, v):
    (p, p1, p2), (q, q1, q2) = pair
    return [(1 - v) * p + v * q, (1 - v) * p1 + v * q1, q - p, (1 - v) * p2 + v * q2, q1 - p1]


def random_pair(seed, degree, spans=1, rational=False, noise=1.0):
    """Two curves side by side, C^(degree - 1), over the same knots."""
    random = np.random.default_rng(seed)
    count = degree + spans
    multiplicities = (degree + 1, *[1] * (spans - 1), degree + 1)
    knots = tuple(np.cumsum([0, *random.integers(3, 6, spans)]) / 4)
    along = 10 / degree * np.arange(count)[:, None] * [1.0, 0.0, 0.0]
    turn = np.linspace(0, 4 * spans, count)[:, None] * [0.0, 0.0, 1.0]

    def curve(shift):
        poles = along + shift + random.uniform(-noise, noise, (count, 3))
        weights = random.uniform(0.8, 1.25, count) if rational else np.ones(count)
        return Spline(degree, knots, multiplicities, poles, weights)

    return curve(np.zeros(3)), curve([0.0, 8.0, 0.0] + turn)
