# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quadrics by their equation: points, normals and the distance of a point, at 60 digits."""

from dataclasses import dataclass

import mpmath
import numpy as np
import pnkernel as pn
from mpmath import mpf
from numpy.polynomial import polynomial
from splines import norm


@dataclass(frozen=True)
class Quadric:
    """x.(S x) + 2 b.x + k = 0 with diagonal S; the unit normal is along S x + b."""

    diagonal: np.ndarray
    linear: np.ndarray
    constant: int
    size: mpf

    @staticmethod
    def of(kind, a, b, c):
        """The kinds of pnkernel.quadric; half-axes may be of 60 digits."""
        a, b, c = mpf(a), mpf(b), mpf(c)
        level, height = np.array([mpf(0)] * 3), np.array([mpf(0), mpf(0), mpf(1) / 2])
        x, y, z = 1 / a**2, 1 / b**2, 1 / c**2
        diagonal, linear, constant = {
            "ellipsoid": ([x, y, z], level, -1),
            "one_sheet_hyperboloid": ([x, y, -z], level, -1),
            "two_sheet_hyperboloid": ([x, y, -z], level, 1),
            "elliptic_paraboloid": ([c * x, c * y, mpf(0)], -height, 0),
            "hyperbolic_paraboloid": ([-c * x, c * y, mpf(0)], height, 0),
            "parabolic_cylinder": ([c * x, mpf(0), mpf(0)], -height, 0),
            "elliptic_cylinder": ([x, y, mpf(0)], level, -1),
            "elliptic_cone": ([x, y, -z], level, 0),
        }[kind]
        return Quadric(np.array(diagonal), linear, constant, max(a, b, c))

    def value(self, x):
        return x @ (self.diagonal * x) + 2 * self.linear @ x + self.constant

    def normal(self, x):
        gradient = self.diagonal * x + self.linear
        return gradient / norm(gradient)

    def feet(self, point):
        """The points y of the quadric with point - y along the normal at y.

        y = (x - m b) / (1 + m S) with a real zero m of the equation; Newton's method begins at the
        zeros of its numerator in doubles, in units of the size.
        """
        unit = self.size**2
        s = np.array(self.diagonal * unit, dtype=float)
        b = np.array(self.linear * self.size, dtype=float)
        x = np.array(point / self.size, dtype=float)
        factors = [[1.0, si] for si in s]
        everything = _product([*factors, *factors])
        numerator = self.constant * np.array(everything)
        for i in range(3):
            others = _product([f for j, f in enumerate(factors) if j != i] * 2)
            own = [x[i], -b[i]]
            numerator = polynomial.polyadd(
                numerator, polynomial.polymul(others, s[i] * np.array(polynomial.polymul(own, own)))
            )
            numerator = polynomial.polyadd(
                numerator, polynomial.polymul(_product([others, factors[i]]), 2 * b[i] * np.array(own))
            )
        for root in polynomial.polyroots(polynomial.polytrim(numerator, 1e-300)):
            if abs(root.imag) < 1e-3 * (1 + abs(root.real)):
                multiplier = self._zero(point, mpf(root.real) * unit)
                if multiplier is not None:
                    yield (point - multiplier * self.linear) / (1 + multiplier * self.diagonal)

    def _zero(self, point, multiplier):
        for _ in range(60):
            scale = 1 + multiplier * self.diagonal
            if min(abs(f) for f in scale) < mpf(10) ** -20:
                return None
            y = (point - multiplier * self.linear) / scale
            gradient = self.diagonal * y + self.linear
            step = self.value(y) / (-2 * gradient @ (gradient / scale))
            multiplier -= step
            if abs(step) < self.size**2 * mpf(10) ** -40:
                return multiplier
        return None

    def contact(self, point, distance):
        """The foot of a point at nearly this distance, and the distance itself [mm]."""
        found = [(foot, (point - foot) @ self.normal(foot)) for foot in self.feet(point)]
        return min(found, key=lambda pair: abs(pair[1] - distance))


def _product(factors):
    result = [1.0]
    for factor in factors:
        result = polynomial.polymul(result, factor)
    return result


def support(half_axes, normal):
    """Of an ellipsoid about the origin: the tangent plane is n.x = h."""
    return mpmath.sqrt(sum((mpf(a) * n) ** 2 for a, n in zip(half_axes, normal, strict=True)))


def bounded_kinds():
    """One region of every kind, with unequal half-axes wherever that is possible."""
    return [
        ("ellipsoid", 3, 2, 1, None),
        ("one_sheet_hyperboloid", 3, 2, 4, {"z": (-1, 2)}),
        ("two_sheet_hyperboloid", 3, 2, 2.5, {"x": (0.25, 1), "y": (-0.5, 1)}),
        ("elliptic_paraboloid", 3, 2, 1, {"x": (-1, 1.5), "y": (-1, 1)}),
        ("hyperbolic_paraboloid", 3, 2, 1, {"x": (-1, 1.5), "y": (-1, 1)}),
        ("parabolic_cylinder", 3, 1, 2, {"x": (-1, 1.5), "y": (-1, 1)}),
        ("elliptic_cylinder", 2, 2, 1, {"z": (-1, 2)}),
        ("elliptic_cone", 2, 2, 3, {"z": (1, 2)}),
    ]


def quadric(kind, a, b, c, bounds=None):
    """The surface of the kernel and its definition."""
    return pn.quadric(kind, a, b, c, bounds), Quadric.of(kind, a, b, c)
