# SPDX-License-Identifier: LGPL-2.1-or-later
"""Helices and circles: recognised, and fitted within the bound that is said to be proved."""

import math

import numpy as np
import Part
from FreeCAD import Placement, Rotation, Vector
from support import DocumentTest

from pnsurfaces.helix import fitted_helix, read_circle, read_helix
from pnsurfaces.spline_fit import FitError

TOLERANCES = (1e-2, 1e-5, 1e-8)


def _true_point(pitch, radius, taper, angle):
    """The point of a helix around z that starts on the x-axis; the pitch is along the cone."""
    way, slant = pitch * angle / (2 * math.pi), math.radians(taper)
    wide, height = radius + way * math.sin(slant), way * math.cos(slant)
    return Vector(wide * math.cos(angle), wide * math.sin(angle), height)


class HelixTest(DocumentTest):
    def assert_fit(self, helix, true_point, turns):
        """The distance at equal parameters is within the bound, and the bound within tolerance."""
        for tolerance in TOLERANCES:
            curve, fit = fitted_helix(helix, "a helix", (2.0, 7.0), tolerance)
            self.assertTrue(fit.proven)
            self.assertLessEqual(fit.deviation, tolerance)
            self.assertEqual((curve.FirstParameter, curve.LastParameter), (2.0, 7.0))
            worst = max(
                (curve.value(2 + 5 * share) - true_point(2 * math.pi * turns * share)).Length
                for share in np.linspace(0, 1, 1501)
            )
            self.assertLessEqual(worst, fit.deviation)
            # The bound is no idle one: it is nearly reached.
            self.assertGreater(worst, 0.5 * fit.deviation - 1e-12)

    def test_cylinder_and_cone(self):
        for taper in (0.0, 15.0):
            edge = Part.makeHelix(10, 30, 20, taper).Edges[0]
            helix = read_helix(edge)
            self.assert_fit(helix, lambda a, taper=taper: _true_point(10, 20, taper, a), 3)

    def test_doubles_are_no_finer_than_they_are(self):
        helix = read_helix(Part.makeHelix(10, 30, 20).Edges[0])
        for tolerance in (0.0, 1e-15):
            with self.assertRaisesRegex(FitError, "its rounding is"):
                fitted_helix(helix, "a helix", (0, 1), tolerance)

    def test_moved(self):
        source = self.shape_object(Part.makeHelix(10, 20, 5))
        place = Placement(Vector(1, 2, 3), Rotation(10, 20, 30))
        source.Placement = place
        helix = read_helix(source.Shape.Edges[0])
        self.assert_fit(helix, lambda a: place.multVec(_true_point(10, 5, 0, a)), 2)

    def test_left_handed(self):
        source = self.document.addObject("Part::Helix", "Helix")
        source.Pitch, source.Height, source.Radius, source.LocalCoord = 10, 20, 5, 1
        self.document.recompute()
        edge = source.Shape.Edges[0]
        curve, fit = fitted_helix(read_helix(edge), "a helix", edge.ParameterRange, 1e-9)
        for share in np.linspace(0, 1, 50):
            parameter = edge.FirstParameter + share * (edge.LastParameter - edge.FirstParameter)
            # OpenCASCADE's own curve is within the tolerance of the edge.
            gap = (curve.value(parameter) - edge.valueAt(parameter)).Length
            self.assertLess(gap, edge.Tolerance)

    def test_spiral(self):
        source = self.document.addObject("Part::Spiral", "Spiral")
        source.Growth, source.Radius, source.Rotations = 3, 5, 2
        self.document.recompute()
        for edge in source.Shape.Edges:
            curve, fit = fitted_helix(read_helix(edge), "a helix", edge.ParameterRange, 1e-7)
            for share in np.linspace(0, 1, 20):
                parameter = edge.FirstParameter + share * (edge.LastParameter - edge.FirstParameter)
                point = curve.value(parameter)
                angle = math.atan2(point.y, point.x) / (2 * math.pi)
                turns = (math.hypot(point.x, point.y) - 5) / 3
                self.assertAlmostEqual(math.remainder(turns - angle, 1), 0, delta=1e-7)
                self.assertLess((point - edge.valueAt(parameter)).Length, edge.Tolerance)

    def test_arc(self):
        circle = Part.Circle(Vector(1, 2, 3), Vector(1, 1, 1), 8)
        edge = circle.toShape(0.3, 4.0)
        self.assert_fit(read_circle(edge), lambda a: circle.value(0.3 + a), turns=3.7 / (2 * math.pi))

    def test_other_edges_are_no_helices(self):
        for edge in Part.makeCylinder(5, 10).Edges + Part.makeCone(5, 3, 10).Edges:
            self.assertIsNone(read_helix(edge))
