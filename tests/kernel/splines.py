# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-splines of IEEE doubles at 60 digits: curves over Q, surfaces by their basis functions.

Nothing here is taken from the kernel. Every double is the rational number it is.
"""

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import mpmath
import numpy as np
from mpmath import mpf
from numpy.polynomial.polynomial import polyadd, polyder, polymul, polyval

mpmath.mp.dps = 60


def exactly(values):
    """The doubles as numbers of 60 digits, in an array of the same shape."""
    return np.vectorize(mpf, otypes=[object])(np.asarray(values, dtype=float))


def norm(vector):
    return mpmath.sqrt(vector @ vector)


def flat_knots(knots, multiplicities):
    return [knot for knot, count in zip(knots, multiplicities, strict=True) for _ in range(count)]


@dataclass(frozen=True)
class Spline:
    """A clamped B-spline as the kernel takes it. poles: (n, 3) of a spine or (n,) of a law."""

    degree: int
    knots: tuple
    multiplicities: tuple
    poles: np.ndarray
    weights: np.ndarray

    @staticmethod
    def bezier(poles, weights=None):
        return Spline.joined([poles], None if weights is None else [weights])

    @staticmethod
    def joined(pieces, weights=None):
        """Bezier pieces over [0, 1], [1, 2], ...; neighbours share an end pole and its weight."""
        degree, count = len(pieces[0]) - 1, len(pieces)
        weights = [np.ones(degree + 1)] * count if weights is None else weights

        def shared(parts):
            return np.concatenate([parts[0], *(part[1:] for part in parts[1:])])

        return Spline(
            degree,
            tuple(range(count + 1)),
            (degree + 1, *[degree] * (count - 1), degree + 1),
            shared([np.asarray(piece, dtype=float) for piece in pieces]),
            shared([np.asarray(piece, dtype=float) for piece in weights]),
        )

    @property
    def arguments(self):
        """What pn.Curve.bspline and pn.Law.bspline take."""
        return self.degree, self.knots, self.multiplicities, self.poles, self.weights

    def span_at(self, t):
        """The number of the span that holds t; a knot belongs to the span that it begins."""
        inner = self.knots[1:-1]
        return sum(knot <= t for knot in inner)

    @cached_property
    def span_polynomials(self):
        """For every span the homogeneous components over Q in the parameter, the weight last."""
        knots = flat_knots([Fraction(knot) for knot in self.knots], self.multiplicities)
        coordinates = self.poles.reshape(len(self.poles), -1)
        homogeneous = np.array(
            [
                [*(Fraction(c) * Fraction(w) for c in row), Fraction(w)]
                for row, w in zip(coordinates, self.weights, strict=True)
            ]
        )
        ends = np.cumsum(self.multiplicities[:-1]) - 1
        return [
            [
                _de_boor(component, knots, last)
                for component in homogeneous[last - self.degree : last + 1].T
            ]
            for last in ends
        ]

    @cached_property
    def _span_jets(self):
        return [[_jet(component) for component in span] for span in self.span_polynomials]

    def derivatives(self, t, span):
        """Value, first and second derivative of a span at t, as vectors of 60 digits."""
        components = np.array(
            [[polyval(t, derivative) for derivative in jet] for jet in self._span_jets[span]],
            dtype=object,
        ).T
        (*p, q), (*p1, q1), (*p2, q2) = components
        value = np.array(p) / q
        first = (np.array(p1) - value * q1) / q
        second = (np.array(p2) - 2 * first * q1 - value * q2) / q
        return value, first, second


def _de_boor(controls, knots, last):
    """The polynomial of the span that begins at knots[last]."""
    polynomials = [np.array([control], dtype=object) for control in controls]
    degree = len(controls) - 1
    for level in range(1, degree + 1):
        for j in range(degree, level - 1, -1):
            low, high = knots[last - degree + j], knots[last + 1 + j - level]
            rising = np.array([-low, Fraction(1)]) / (high - low)
            falling = np.array([high, Fraction(-1)]) / (high - low)
            polynomials[j] = polyadd(
                polymul(falling, polynomials[j - 1]), polymul(rising, polynomials[j])
            )
    return polynomials[degree]


def in_digits(polynomial):
    return np.array([mpf(c.numerator) / c.denominator for c in polynomial], dtype=object)


def _jet(polynomial):
    """The polynomial with its first and second derivative."""
    digits = in_digits(polynomial)
    return [polyder(digits, order) for order in range(3)]


def basis(degree, knots, multiplicities, t):
    """The first of the degree + 1 basis functions that may not vanish at t, and their values."""
    flat = [mpf(knot) for knot in flat_knots(knots, multiplicities)]
    span = max(i for i in range(degree, len(flat) - degree - 1) if flat[i] <= t)
    values = [mpf(1)]
    for level in range(1, degree + 1):
        raised = [mpf(0)] * (level + 1)
        for i, value in enumerate(values):
            low, high = flat[span - level + 1 + i], flat[span + 1 + i]
            raised[i] += value * (high - t) / (high - low)
            raised[i + 1] += value * (t - low) / (high - low)
        values = raised
    return span - degree, np.array(values, dtype=object)


def surface_point(face, u, v):
    """The point of the exported doubles at (u, v)."""
    i, along = basis(face.u_degree, face.u_knots, face.u_multiplicities, mpf(u))
    j, around = basis(face.v_degree, face.v_knots, face.v_multiplicities, mpf(v))
    active = np.s_[i : i + len(along), j : j + len(around)]
    weights = np.outer(along, around) * exactly(face.weights[active])
    return np.tensordot(weights, exactly(face.poles[active]), 2) / weights.sum()
