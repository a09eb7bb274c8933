# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents, spines and comparisons that the tests share."""

import pathlib
import tempfile
import unittest

import FreeCAD
import Part
from FreeCAD import Vector

from pnsurfaces import kernel

# A curved spine with five vertices, in millimetres, and radii that suit it.
POLES = [(0, 0, 0), (10, 3, 1), (22, -4, 5), (30, 6, 9), (41, 12, 4), (50, 10, 0), (61, 15, 3)]
KNOTS = [0.0, 0.2, 0.5, 0.7, 1.0]
MULTIPLICITIES = [4, 1, 1, 1, 4]
RADII = [2.0, 2.5, 1.5, 1.75, 3.0]


class DocumentTest(unittest.TestCase):
    """A test with an empty document and a folder of its own."""

    def setUp(self):
        self.document = FreeCAD.newDocument()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.addCleanup(self._close_documents)

    def shape_object(self, shape, name="Source"):
        source = self.document.addObject("Part::Feature", name)
        source.Shape = shape
        return source

    def spline_object(self):
        return self.shape_object(spline().toShape(), "Spline")

    def line_object(self, length=10.0):
        return self.shape_object(Part.makeLine(Vector(), Vector(0, 0, length)), "Line")

    def assert_valid(self, obj):
        self.assertTrue(obj.isValid(), obj.getStatusString())
        self.assertFalse(obj.Shape.isNull())
        self.assertEqual(kernel.pnocct().check(obj.Shape.exportBrepToString()), [])

    def assert_error(self, obj, sentence):
        """The tree shows exactly one sentence, and it contains `sentence`."""
        self.assertFalse(obj.isValid())
        self.assertIn(sentence, obj.getStatusString())
        self.assertEqual(obj.Status, f"Error: {obj.getStatusString()}")
        self.assertRegex(obj.getStatusString(), r"^[A-Z][^\n]*[.]$")

    def _close_documents(self):
        for name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(name)


def spline():
    curve = Part.BSplineCurve()
    poles = [Vector(*pole) for pole in POLES]
    curve.buildFromPolesMultsKnots(poles, MULTIPLICITIES, KNOTS, False, 3)
    return curve


def polyline(*points):
    return Part.makePolygon([Vector(*point) for point in points])


def volume(obj):
    return kernel.pnocct().volume(obj.Shape.exportBrepToString())


def surface_data(surface):
    """All numbers of a B-spline surface, exactly; equal when the surfaces are equal bit for bit."""
    return (
        surface.UDegree,
        surface.VDegree,
        surface.getUKnots(),
        surface.getVKnots(),
        surface.getUMultiplicities(),
        surface.getVMultiplicities(),
        [[tuple(pole) for pole in row] for row in surface.getPoles()],
        surface.getWeights(),
    )


def shape_data(shape):
    return [surface_data(face.Surface) for face in shape.Faces]


def grid(surface, count=12):
    """Parameters (u, v) all over a surface."""
    u_first, u_last, v_first, v_last = surface.bounds()
    return [
        (
            u_first + (u_last - u_first) * (i + 0.5) / count,
            v_first + (v_last - v_first) * (j + 0.5) / count,
        )
        for i in range(count)
        for j in range(count)
    ]
