# SPDX-License-Identifier: LGPL-2.1-or-later
"""Radii from an expression: values, slopes, units, and what is refused."""

import math
import random
import unittest

from pnsurfaces.radius_error import RadiusLawError
from pnsurfaces.radius_expression import RadiusExpression

SEED = 7
LENGTH = 80.0

# As text, and as Python.
SMOOTH = [
    ("2 mm + 0.5 mm * sin(2*pi*s)", lambda s: 2 + 0.5 * math.sin(2 * math.pi * s)),
    ("3 mm * exp(-s^2) + 1 mm", lambda s: 3 * math.exp(-(s**2)) + 1),
    ("L/20 + sqrt(4 mm^2 + 1 mm * 2 mm * s)", lambda s: 4 + math.sqrt(4 + 2 * s)),
    ("1 in - cos(90 deg * s) * 1 cm", lambda s: 25.4 - 10 * math.cos(math.pi / 2 * s)),
    ("(1 mm + s * 2 mm)^3 / (4 mm^2)", lambda s: (1 + 2 * s) ** 3 / 4),
    ("2 + atan(s) * tanh(s)", lambda s: 2 + math.atan(s) * math.tanh(s)),
    ('.25" * log(e + s) / cosh(s)', lambda s: 6.35 * math.log(math.e + s) / math.cosh(s)),
    ("-(-3e0 mm) ** 1", lambda s: 3.0),
]


class Values(unittest.TestCase):
    def test_radii(self):
        generator = random.Random(SEED)
        for text, function in SMOOTH:
            expression = RadiusExpression(text, 0, LENGTH)
            for _ in range(20):
                s = generator.random()
                with self.subTest(text, s=s):
                    self.assertAlmostEqual(expression.radius(s), function(s), delta=1e-13 * 50)

    def test_slopes_are_those_of_difference_quotients(self):
        generator = random.Random(SEED)
        step = 1e-5
        for text, function in SMOOTH:
            expression = RadiusExpression(text, 0, LENGTH)
            for _ in range(20):
                s = generator.uniform(0.1, 0.9)
                quotient = (function(s + step) - function(s - step)) / (2 * step)
                with self.subTest(text, s=s):
                    self.assertAlmostEqual(expression.slope(s), quotient, delta=1e-7)

    def test_a_position_may_be_a_length(self):
        expression = RadiusExpression("2 mm + s / 10 + 1 mm * s / L", 1, LENGTH)
        self.assertAlmostEqual(expression.radius(40.0), 2 + 4 + 0.5, delta=1e-14)


class Refusals(unittest.TestCase):
    def test_what_is_no_radius(self):
        for text, sentence in (
            ("", "empty"),
            ("2 mm +", "cannot be read"),
            ("2 mm + foo", "unknown name foo"),
            ("abs(s)", "unknown function abs"),
            ("sin(s, s)", "takes one argument"),
            ("2 mm + s", "Write units"),
            ("sin(2 mm)", "sin of a length"),
            ("2 mm * 3 mm", "to the power 2"),
            ("2 ^ (3 mm)", "length as an exponent"),
            ("(2 mm) ^ s", "a power that changes"),
            ("2 kg", "no length or angle"),
            ("s % 2", "operators"),
            ("s if s else 1", "only numbers"),
            ("__import__('os').system('true')", "only numbers"),
            ("s.real", "only numbers"),
            ("[s for s in (1, 2)]", "only numbers"),
            ("'2 mm'", "only numbers"),
            ("True", "only numbers"),
            ("1 + " * 400 + "1", "characters"),
            ("(" * 900, "cannot be read"),
        ):
            with self.subTest(text[:40]), self.assertRaisesRegex(RadiusLawError, sentence):
                RadiusExpression(text, 0, LENGTH)

    def test_where_there_is_no_value(self):
        for text, s in (
            ("1 mm / s", 0.0),
            ("1 / 0", 0.5),
            ("1 mm * sqrt(s - 0.5)", 0.25),
            ("1 mm * log(s)", 0.0),
            ("9^9^9^9 * s", 0.5),
        ):
            expression = RadiusExpression(text, 0, LENGTH)
            with self.subTest(text), self.assertRaisesRegex(RadiusLawError, f"position {s:g}"):
                expression.radius(s)
