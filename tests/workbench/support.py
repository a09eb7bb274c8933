# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents, spines and comparisons that the tests share."""

import inspect
import pathlib
import tempfile
import unittest

import FreeCAD
import numpy as np
import Part
from FreeCAD import Vector

import pnsurfaces
from pnsurfaces import kernel
from pnsurfaces.face_grid import face_grid, patches
from pnsurfaces.feature import FeatureBase
from pnsurfaces.shape import own_shape
from pnsurfaces.spline_grid import points_and_normals

# A curved spine with five vertices, in millimetres, and radii that suit it.
POLES = [(0, 0, 0), (10, 3, 1), (22, -4, 5), (30, 6, 9), (41, 12, 4), (50, 10, 0), (61, 15, 3)]
KNOTS = [0.0, 0.2, 0.5, 0.7, 1.0]
MULTIPLICITIES = [4, 1, 1, 1, 4]
RADII = [2.0, 2.5, 1.5, 1.75, 3.0]


def feature_classes():
    """The class of every kind of feature: each is in the module of the function that makes it."""
    makers = [getattr(pnsurfaces, name) for name in pnsurfaces.__all__ if name.startswith("make_")]
    return [
        member
        for module in map(inspect.getmodule, makers)
        for member in vars(module).values()
        if inspect.isclass(member)
        and issubclass(member, FeatureBase)
        and member.__module__ == module.__name__
    ]


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

    def face_object(self, shape, name="Face"):
        """The link to the first face of a shape."""
        return self.shape_object(shape, name), "Face1"

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

    def assert_offset(self, obj, distance):
        """Every point of the offset lies the distance away from its point of the base."""
        for base, offset in base_and_offset(obj):
            self.assertAlmostEqual((offset - base).Length, abs(distance), delta=1e-10)

    def _close_documents(self):
        for name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(name)


def samples(obj, rows=12):
    """Points and normals (n, 3) of all faces, from their edges on."""
    grids = [face_grid(face) for face in own_shape(obj).Faces]
    pairs = [
        points_and_normals(grid.surface, *patch)
        for grid in grids
        for patch in patches(grid, rows, rows)
    ]
    return [np.concatenate(parts) for parts in zip(*pairs)]


def spline():
    curve = Part.BSplineCurve()
    poles = [Vector(*pole) for pole in POLES]
    curve.buildFromPolesMultsKnots(poles, MULTIPLICITIES, KNOTS, False, 3)
    return curve


def polyline(*points):
    return Part.makePolygon([Vector(*point) for point in points])


def volume(obj):
    return kernel.pnocct().volume(obj.Shape.exportBrepToString())


class Recovery:
    """Mixed into a test with a valid feature `obj`: its good shape stays after an error."""

    def remember(self, obj):
        self.obj = obj
        self.assert_valid(obj)
        self.good = shape_data(obj.Shape)
        self.results = _results(obj)

    def assert_fails_and_recovers(self, sentence, repair):
        """The good shape stays with its results, and comes back when the input does."""
        self.document.recompute()
        self.assert_error(self.obj, sentence)
        self.assertEqual(shape_data(self.obj.Shape), self.good)
        self.assertEqual(_results(self.obj), self.results)
        repair()
        self.document.recompute()
        self.assertTrue(self.obj.isValid(), self.obj.getStatusString())
        self.assertEqual(self.obj.Status, "Valid")
        self.assertEqual(shape_data(self.obj.Shape), self.good)


def _results(obj):
    return obj.Degree, obj.Poles, obj.Deviation, obj.MinOffset, obj.MaxOffset


def surface_data(surface):
    """All numbers of a B-spline surface or the plane of a cap, exactly; equal when the surfaces are
    equal bit for bit."""
    if isinstance(surface, Part.Plane):
        return tuple(surface.Position), tuple(surface.Axis)
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


def base_and_offset(obj):
    """Pairs (point of the base, point of the offset) of a feature that shows both."""
    faces = obj.Shape.Faces
    half = len(faces) // 2
    return [
        (base.Surface.value(u, v), offset.Surface.value(u, v))
        for base, offset in zip(faces[:half], faces[half:])
        for u, v in grid(base.Surface)
        if base.isPartOfDomain(u, v)
    ]
