# SPDX-License-Identifier: LGPL-2.1-or-later
"""The C2 cubic spline through radii, looked at with Part's own B-spline."""

import random
import unittest

import numpy as np
import Part
from FreeCAD import Vector

from pnsurfaces.cubic_spline import (
    clamped_ends,
    cubic_spline,
    natural_ends,
    periodic_ends,
    spline_slopes,
    values_at_ends,
)

SEED = 20


def _random_problem(generator):
    parameters = [0.0]
    for _ in range(generator.randint(2, 12)):
        parameters.append(parameters[-1] + generator.uniform(0.1, 3.0))
    return parameters, [generator.uniform(1.0, 4.0) for _ in parameters]


def _curve(parameters, coefficients):
    """The law as the first coordinate of a curve."""
    curve = Part.BSplineCurve()
    poles = [Vector(coefficient, 0, 0) for coefficient in coefficients]
    multiplicities = [4] + [1] * (len(parameters) - 2) + [4]
    curve.buildFromPolesMultsKnots(poles, multiplicities, parameters, False, 3)
    return curve


class CubicSpline(unittest.TestCase):
    def problems(self, ends):
        generator = random.Random(SEED)
        for number in range(50):
            parameters, values = _random_problem(generator)
            if ends is periodic_ends:
                values[-1] = values[0]
            with self.subTest(seed=SEED, problem=number):
                curve = _curve(parameters, cubic_spline(parameters, values, ends))
                yield parameters, values, curve

    def test_runs_through_the_values(self):
        for ends in (natural_ends, periodic_ends, clamped_ends(-1.0, 2.0)):
            for parameters, values, curve in self.problems(ends):
                self.assertEqual(curve.getPole(1).x, values[0])
                self.assertEqual(curve.getPole(curve.NbPoles).x, values[-1])
                for parameter, value in zip(parameters, values):
                    self.assertAlmostEqual(curve.value(parameter).x, value, delta=1e-12)

    def test_natural_ends(self):
        for parameters, _, curve in self.problems(natural_ends):
            for parameter in (parameters[0], parameters[-1]):
                self.assertAlmostEqual(curve.getDN(parameter, 2).x, 0, delta=1e-10)

    def test_periodic_ends(self):
        for parameters, _, curve in self.problems(periodic_ends):
            for order in (1, 2):
                start = curve.getDN(parameters[0], order).x
                end = curve.getDN(parameters[-1], order).x
                self.assertAlmostEqual(start, end, delta=1e-10)

    def test_clamped_ends(self):
        for parameters, _, curve in self.problems(clamped_ends(-1.0, 2.0)):
            self.assertAlmostEqual(curve.getDN(parameters[0], 1).x, -1, delta=1e-10)
            self.assertAlmostEqual(curve.getDN(parameters[-1], 1).x, 2, delta=1e-10)

    def test_natural_splines_may_end_beyond_their_values(self):
        for parameters, values, _ in self.problems(natural_ends):
            first, last = parameters[0] - 0.7, parameters[-1] + 0.2
            ends = values_at_ends(np.array(parameters), np.array(values), first, last)
            knots = np.array([first, *parameters[1:-1], last])
            through = np.array([ends[0], *values[1:-1], ends[1]])
            curve = _curve(list(knots), cubic_spline(knots, through, natural_ends))
            for parameter, value in zip(parameters, values):
                self.assertAlmostEqual(curve.value(parameter).x, value, delta=1e-10)

    def test_slopes(self):
        for parameters, values, curve in self.problems(natural_ends):
            slopes = spline_slopes(parameters, values, natural_ends)
            for parameter, slope in zip(parameters, slopes):
                self.assertAlmostEqual(curve.getDN(parameter, 1).x, slope, delta=1e-10)
