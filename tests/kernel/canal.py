# SPDX-License-Identifier: LGPL-2.1-or-later
"""Canal surfaces by their definition: spheres of radius r(t) about m(t), and what they envelop."""

from dataclasses import dataclass

import numpy as np
import pnkernel as pn
from mpmath import mpf
from splines import Spline, norm


@dataclass(frozen=True)
class Canal:
    """The input of a canal surface: spine and radius over the same knots."""

    spine: Spline
    radius: Spline

    def surface(self):
        return pn.canal_surface(
            pn.Curve.bspline(*self.spine.arguments), pn.Law.bspline(*self.radius.arguments)
        )

    @property
    def size(self):
        """The largest coordinate or radius."""
        return float(max(np.abs(self.spine.poles).max(), np.abs(self.radius.poles).max()))

    def spheres(self, t, span):
        """(m, m', m'') and (r, r', r'') of a span at t."""
        centre = self.spine.derivatives(t, span)
        radius = self.radius.derivatives(t, span)
        return centre, tuple(value[0] for value in radius)

    def foot(self, point, near, span):
        """The parameter whose characteristic circle lies nearest to the point.

        It is the zero of (x - m).m' + r' |x - m|, found by Newton's method from `near`.
        """
        t = mpf(near)
        for _ in range(40):
            (m, m1, m2), (_, r1, r2) = self.spheres(t, span)
            arm = point - m
            length = norm(arm)
            value = arm @ m1 + r1 * length
            slope = arm @ m2 - m1 @ m1 + r2 * length - r1 * (arm @ m1) / length
            step = value / slope
            t -= step
            if abs(step) < mpf(10) ** -45:
                return t
        raise ArithmeticError(f"no foot near parameter {near}")

    def distance(self, point, offset, near, span):
        """How far the point is from the envelope at this offset, along the normal, in mm."""
        (m, _, _), (r, _, _) = self.spheres(self.foot(point, near, span), span)
        return abs(norm(point - m) - (r + mpf(offset)))

    def nearest_parameter(self, point, offset):
        """A rough foot: the best of many parameters, in doubles, with its span."""
        candidates = [
            (span, a + (b - a) * share)
            for span, (a, b) in enumerate(zip(self.spine.knots, self.spine.knots[1:]))
            for share in np.linspace(0, 1, 33)
        ]

        def defect(candidate):
            span, t = candidate
            (m, m1, _), (r, r1, _) = self.spheres(mpf(t), span)
            arm = point - m
            along = (arm @ m1 + r1 * norm(arm)) / norm(m1)
            return along**2 + (norm(arm) - r - mpf(offset)) ** 2

        span, t = min(candidates, key=defect)
        return t, span


def random_canal(seed, degree, spans=1, rational=False):
    """A spine that advances faster than its radius changes, so that an envelope exists.

    Spans are joined as a B-spline with simple knots, C^(degree - 1).
    """
    random = np.random.default_rng(seed)
    count = degree + spans
    multiplicities = (degree + 1, *[1] * (spans - 1), degree + 1)
    knots = tuple(np.cumsum([0, *random.integers(3, 6, spans)]) / 4)
    poles = 10 * np.arange(count)[:, None] * [0.0, 0.0, 1.0] + random.uniform(-6, 6, (count, 3))
    weights = random.uniform(0.8, 1.25, count) if rational else np.ones(count)
    radii = random.uniform(1.5, 3.0, count)
    return Canal(
        Spline(degree, knots, multiplicities, poles, weights),
        Spline(degree, knots, multiplicities, radii, weights),
    )


def face_parameters(face, random, count):
    """Random (u, v) on a face, its corners among them."""
    ends = [(face.u_knots[i], face.v_knots[j]) for i in (0, -1) for j in (0, -1)]
    inner = zip(
        random.uniform(face.u_knots[0], face.u_knots[-1], count),
        random.uniform(face.v_knots[0], face.v_knots[-1], count),
    )
    return [*ends, *inner]
