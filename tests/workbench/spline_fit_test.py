# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splines that follow a function: the measured deviation, the smoothness, and kinks."""

import unittest

import FreeCAD
import numpy as np
import Part

from pnsurfaces.curve_fit import fitted_curve
from pnsurfaces.spline_fit import (
    Fit,
    FitError,
    deviation_of,
    halved_until_close,
    hermite_segments,
    measured_deviations,
)


def _deviations(function, slope):
    def of_knots(knots):
        values, slopes = (np.array([[f(t)] for t in knots]) for f in (function, slope))
        segments = hermite_segments(knots, values, slopes)
        return measured_deviations(function, knots, segments)

    return of_knots


class Halving(unittest.TestCase):
    def test_cubics_are_left_alone(self):
        deviations = _deviations(lambda t: 1 + t - t**3, lambda t: 1 - 3 * t**2)
        knots, deviation = halved_until_close([0, 1, 3], deviations, 1e-12, "a cubic")
        self.assertEqual(list(knots), [0, 1, 3])
        self.assertLess(deviation, 1e-13)

    def test_only_bad_intervals_are_halved(self):
        bump = lambda t: np.exp(-((20 * t) ** 2))  # noqa: E731
        slope = lambda t: -800 * t * bump(t)  # noqa: E731
        knots, deviation = halved_until_close([-1, 0, 1], _deviations(bump, slope), 1e-6, "a bump")
        self.assertLessEqual(deviation, 1e-6)
        steps = np.diff(knots)
        self.assertGreater(steps[0], 20 * steps[len(steps) // 2])

    def test_a_kink_is_named(self):
        deviations = _deviations(lambda t: abs(t - 0.3), lambda t: np.sign(t - 0.3))
        sentence = r"No fit: a roof has a kink .* near parameter 0\.(299|300)"
        with self.assertRaisesRegex(FitError, sentence):
            halved_until_close([0, 1], deviations, 1e-6, "a roof")

    def test_waves_are_not_missed(self):
        """Their values and slopes are zero at all simple shares of the interval."""
        wave = lambda t: np.sin(8 * np.pi * t) ** 2  # noqa: E731
        slope = lambda t: 8 * np.pi * np.sin(16 * np.pi * t)  # noqa: E731
        knots, _ = halved_until_close([0, 1], _deviations(wave, slope), 1e-3, "a wave")
        self.assertGreater(len(knots), 30)

    def test_what_is_no_number_is_not_close(self):
        with self.assertRaises(FitError):
            halved_until_close([0, 1], lambda knots: np.full(len(knots) - 1, np.nan), 1, "")


class Curves(unittest.TestCase):
    def test_offset_of_an_ellipse(self):
        ellipse = Part.Ellipse(FreeCAD.Vector(), 50, 30)
        offset = Part.OffsetCurve(ellipse, 5, FreeCAD.Vector(0, 0, 1))
        edge = offset.toShape()
        for tolerance in (1e-2, 1e-5, 1e-8):
            curve, fit = fitted_curve(offset, edge.ParameterRange, tolerance)
            gaps = [
                (curve.value(t) - offset.value(t)).Length
                for t in np.linspace(*edge.ParameterRange, 1997)
            ]
            self.assertFalse(fit.proven)
            self.assertLessEqual(fit.deviation, tolerance)
            self.assertLess(max(gaps), 1.1 * fit.deviation)
            self.assertEqual(curve.Continuity, "C2")


class Texts(unittest.TestCase):
    def test_fits_add_up(self):
        proven, measured = Fit("a helix", 1e-6, True), Fit("the law", 2e-6, False)
        self.assertEqual(deviation_of([]), "0 mm")
        self.assertEqual(deviation_of([proven]), "1.0e-06 mm, proven")
        self.assertEqual(deviation_of([proven, measured]), "3.0e-06 mm, measured")
        self.assertEqual(proven.note(), "Fitted within 1.0e-06 mm, proven: a helix.")
