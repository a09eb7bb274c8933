# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users do to the sources of a canal surface: a sentence, and the last good shape stays."""

import pathlib

import Draft
import FreeCAD
import Part
from FreeCAD import Placement, Rotation, Vector
from support import RADII, DocumentTest, Recovery, polyline, shape_data, volume

from pnsurfaces import make_canal_surface

DOCUMENTS = pathlib.Path(__file__).parent / "documents"


class Sources(DocumentTest):
    def test_sources_of_every_kind(self):
        """Wires of Draft, sketches, links to them and bodies, where they stand."""
        wire = Draft.make_wire([Vector(), Vector(10, 0, 0), Vector(10, 10, 5)])
        smooth = Draft.make_bspline([Vector(), Vector(10, 0, 0), Vector(10, 10, 5)], closed=True)
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(Part.LineSegment(Vector(0, 0, 0), Vector(10, 0, 0)))
        body = self.document.addObject("PartDesign::Body", "Body")
        body.Placement.Base = Vector(0, 0, 50)
        inside = body.newObject("Sketcher::SketchObject", "Inside")
        inside.addGeometry(Part.LineSegment(Vector(0, 0, 0), Vector(10, 0, 0)))
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = sketch
        link.Placement = Placement(Vector(0, 0, 20), Rotation())
        self.document.recompute()
        for source, height in ((wire, 2.5), (smooth, None), (sketch, 0), (inside, 50), (link, 20)):
            obj = make_canal_surface(source, 0.5)
            with self.subTest(source.Name):
                self.assert_valid(obj)
                if height is not None:
                    self.assertAlmostEqual(obj.Shape.BoundBox.Center.z, height, delta=0.5)

    def test_a_link_moves_with_its_source(self):
        line = self.line_object(10)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = line
        obj = make_canal_surface((link, "Edge1"), 2, Output="Solid")
        before = volume(obj)
        line.Shape = Part.makeLine(Vector(), Vector(0, 0, 20))
        self.document.recompute()
        self.assertAlmostEqual(volume(obj) / before, 2, delta=1e-9)

    def test_a_renamed_source_is_still_the_source(self):
        line = self.line_object(10)
        obj = make_canal_surface(line, 2, Output="Solid")
        line.Label = "Something else"
        line.Shape = Part.makeLine(Vector(), Vector(0, 0, 20))
        self.document.recompute()
        self.assert_valid(obj)
        line.Shape = Part.Vertex(0, 0, 0)
        self.document.recompute()
        self.assert_error(obj, "Something else has no edge.")

    def test_inches(self):
        obj = make_canal_surface(self.line_object(100), ("0.25 in", "0.5 in"), '0.125"')
        self.assert_valid(obj)
        self.assertAlmostEqual(obj.EndRadius.Value, 12.7, delta=1e-12)
        self.assertAlmostEqual(obj.Distance.Value, 3.175, delta=1e-12)

    def test_a_length_is_no_angle(self):
        with self.assertRaises(ArithmeticError):
            make_canal_surface(self.line_object(), "3 deg")
        self.assertEqual(len(self.document.Objects), 1)


class LastGoodShape(Recovery, DocumentTest):
    def setUp(self):
        super().setUp()
        self.source = self.line_object(10)
        self.remember(make_canal_surface(self.source, 2))

    def test_null_shape(self):
        self.source.Shape = Part.Shape()
        self.assert_fails_and_recovers("has no edge", self.repair)

    def test_zero_length(self):
        standing = Part.BSplineCurve()
        standing.buildFromPolesMultsKnots([Vector(1, 1, 1)] * 4, [4, 4], [0, 1], False, 3)
        self.source.Shape = standing.toShape()
        self.assert_fails_and_recovers("near (1, 1, 1) has no length", self.repair)

    def test_branch(self):
        self.source.Shape = Part.Compound(
            [
                polyline((0, 0, 0), (10, 0, 0)),
                polyline((10, 0, 0), (20, 5, 0)),
                polyline((10, 0, 0), (20, -5, 0)),
            ]
        )
        self.assert_fails_and_recovers("3 edges meet at (10, 0, 0)", self.repair)

    def test_division_by_zero(self):
        self.obj.setExpression("Radius", "1 mm / (Distance / 1 mm)")

        def repair():
            self.obj.setExpression("Radius", None)
            self.obj.Radius = 2

        self.assert_fails_and_recovers("The radius is not a finite number.", repair)

    def test_a_deleted_profile(self):
        profile = self.shape_object(polyline((2, 0, 0), (2, 0, 10)), "Profile")
        self.obj.Profile = (profile, ["Edge1"])
        self.obj.RadiusLaw = "Profile"
        self.document.recompute()
        self.assertEqual(self.obj.Status, "Valid")
        self.document.removeObject("Profile")

        def repair():
            self.obj.RadiusLaw = "Constant"

        self.assert_fails_and_recovers("The profile is missing.", repair)

    def repair(self):
        self.source.Shape = Part.makeLine(Vector(), Vector(0, 0, 10))


class Circles(DocumentTest):
    def test_two_features_in_a_circle(self):
        line = self.line_object(10)
        first = make_canal_surface(line, 2, name="First")
        second = make_canal_surface((first, "Edge1"), 0.5, name="Second")
        good = shape_data(first.Shape)
        first.Spine = (second, ["Edge1"])
        sentence = "Error: First from Second from First: these objects are made from one another"
        self.assertIn(sentence, first.Status)
        self.assertEqual(shape_data(first.Shape), good)
        first.Spine = (line, [])
        self.document.recompute()
        self.assertEqual((first.Status, second.Status), ("Valid", "Valid"))
        self.assertEqual(shape_data(first.Shape), good)


def numbers(data):
    """All numbers of nested sequences, in their order."""
    if isinstance(data, (int, float)):
        return [data]
    return [number for part in data for number in numbers(part)]


class OldDocuments(DocumentTest):
    def test_schema_1(self):
        """It keeps its shape, gets the new choices, and computes as before, up to the rounding with
        which lines around are chosen."""
        document = FreeCAD.openDocument(str(DOCUMENTS / "canal_surface_schema_1.FCStd"))
        pipe = document.Pipe
        self.assertEqual((pipe.SchemaVersion, pipe.RadiusLaw), (2, "Values at vertices"))
        self.assertEqual((pipe.Radii, pipe.Hollow, pipe.FitTolerance.Value), (RADII, "No", 1e-5))
        self.assertIn("Table", pipe.getEnumerationsOfProperty("RadiusLaw"))
        stored = shape_data(pipe.Shape)
        pipe.touch()
        document.recompute()
        self.assert_valid(pipe)
        for number, before in zip(numbers(shape_data(pipe.Shape)), numbers(stored), strict=True):
            self.assertLessEqual(abs(number - before), 1e-14 * max(1, abs(before)))
        pipe.RadiusLaw = "Expression"
        pipe.RadiusExpression = "2 mm + 1 mm * s"
        document.recompute()
        self.assert_valid(pipe)
