# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving conic sections as features: planes, laws, solids, fits, and refusals."""

import math

import FreeCAD
import Part
from FreeCAD import Vector
from support import DocumentTest, polyline, shape_data, spline, volume

import pnsurfaces
from pnsurfaces import kernel
from pnsurfaces.moving_conic_section import suitable_up


class SectionTest(DocumentTest):
    def make(self, *args, **properties):
        obj = pnsurfaces.make_moving_conic_section(*args, **properties)
        self.assert_valid(obj)
        return obj

    def assert_certified(self, obj):
        """All samples lie on the ellipses that the properties say."""
        (report,) = pnsurfaces.certificate([obj])["objects"]
        (section,) = report["sections"]
        sampled = section["sampling"]
        self.assertLessEqual(sampled["worst"], obj.DeviationBound + sampled["rounding"])

    def assert_on(self, obj, point, tolerance=1e-9):
        distance, _, _ = obj.Shape.distToShape(Part.Vertex(*point))
        self.assertLess(distance, tolerance)

    def bent_duct(self):
        """A straight piece, a quarter turn of radius 30, and a straight piece, in the plane y = 0."""
        arc = Part.Arc(Vector(20, 0, 0), Vector(20 + 30 * math.sin(math.pi / 4), 0,
                                                30 - 30 * math.cos(math.pi / 4)), Vector(50, 0, 30))
        edges = [
            Part.makeLine(Vector(0, 0, 0), Vector(20, 0, 0)),
            arc.toShape(),
            Part.makeLine(Vector(50, 0, 30), Vector(50, 0, 45)),
        ]
        return self.shape_object(Part.Wire(edges), "Spine")


class Sections(SectionTest):
    def test_a_straight_duct_from_an_ellipse_to_a_circle(self):
        obj = self.make(self.line_object(30), ((6, 3), (4, 4)), up=(0, 1, 0), Output="Solid")
        self.assertEqual(obj.Status, "Valid")
        self.assertTrue(obj.Exact)
        self.assert_certified(obj)
        # pi times the integral of (6 - 2 t) (3 + t) over the height
        self.assertAlmostEqual(volume(obj), math.pi * 30 * (18 - 2 / 3), delta=1e-8)
        ends = sorted(
            (face for face in obj.Shape.Faces if isinstance(face.Surface, Part.Plane)),
            key=lambda face: face.CenterOfMass.z,
        )
        for face, area in zip(ends, (18, 16)):
            measured, _ = kernel.pnocct().measured_area(face.exportBrepToString())
            self.assertAlmostEqual(measured / math.pi, area, delta=1e-8)

    def test_it_has_no_offsets(self):
        obj = self.make(self.line_object(), (2, 1), up=(0, 1, 0))
        for name in ("Distance", "Sides", "SecondDistance", "MinOffset", "MaxOffset"):
            self.assertNotIn(name, obj.PropertiesList)
        (report,) = pnsurfaces.certificate([obj])["objects"]
        self.assertIsNone(report["regular_range"])

    def test_a_bent_duct(self):
        obj = self.make(self.bent_duct(), ((8, 4), (5, 5)), up=(0, 1, 0))
        self.assertEqual(obj.Status, "Valid")
        self.assert_certified(obj)
        self.assertTrue(obj.Exact)
        (shell,) = obj.Shape.Shells
        self.assertEqual(len(shell.Faces), 3)

    def test_a_spine_in_space(self):
        obj = self.make(self.spline_object(), ((3, 1.5), (2, 2)), Output="Solid")
        self.assertEqual(obj.Status, "Valid")
        self.assert_certified(obj)
        self.assertEqual(obj.Shape.ShapeType, "Solid")

    def test_parallel_sections_have_the_volume_of_cavalieri(self):
        spine = self.spline_object()
        obj = self.make(spine, (3, 2), normal=(1, 0, 0), Output="Solid")
        self.assert_certified(obj)
        length = spine.Shape.BoundBox.XLength
        self.assertAlmostEqual(volume(obj), math.pi * 6 * length, delta=1e-6)

    def test_a_closed_spine_closes(self):
        spine = self.shape_object(Part.makeCircle(20), "Circle")
        obj = self.make(spine, (4, 2), Output="Solid")
        self.assert_certified(obj)
        # Pappus
        self.assertAlmostEqual(volume(obj), math.pi * 8 * 2 * math.pi * 20, delta=1e-8)
        self.assertFalse(any(isinstance(face.Surface, Part.Plane) for face in obj.Shape.Faces))

    def test_an_ellipse_with_equal_half_axes_is_the_canal_surface(self):
        spine = self.spline_object()
        duct = self.make(spine, (2, 2), Output="Solid")
        pipe = pnsurfaces.make_canal_surface(spine, 2, Output="Solid")
        self.assertAlmostEqual(volume(duct), volume(pipe), delta=1e-6)

    def test_the_spine_is_followed(self):
        spine = self.line_object(10)
        obj = self.make(spine, (2, 1), up=(0, 1, 0))
        spine.Shape = Part.makeLine(Vector(), Vector(0, 0, 12))
        self.document.recompute()
        self.assertAlmostEqual(obj.Shape.BoundBox.ZMax, 12, delta=1e-9)

    def test_a_surface_that_crosses_itself_says_so(self):
        loop = Part.BezierCurve()
        loop.setPoles([Vector(0, 0, 0), Vector(90, 60, 0), Vector(-50, 60, 0), Vector(40, 0, 0)])
        obj = self.make(self.shape_object(loop.toShape()), (2, 1))
        self.assertIn("crosses itself", obj.Status)


class Laws(SectionTest):
    def test_a_table(self):
        rows = [(0, 4, 2), (12, 3, "3 mm"), (30, 5, 2)]
        obj = self.make(self.line_object(30), ("Table", rows), up=(0, 1, 0),
                        PositionBy="Arc length")
        self.assert_certified(obj)
        for point in ((4, 0, 0), (3, 0, 12), (0, 3, 12), (0, 2, 30)):
            self.assert_on(obj, point)

    def test_expressions_are_fitted_and_say_so(self):
        obj = self.make(self.line_object(30), ("Expression", ("4 mm + 1 mm * sin(pi*s)", "2 mm")),
                        up=(0, 1, 0), FitTolerance=1e-4)
        self.assertFalse(obj.Exact)
        self.assertIn("Fitted within", obj.Status)
        self.assertGreater(obj.DeviationBound, 1e-9)
        self.assertLess(obj.DeviationBound, 2e-4)
        self.assert_certified(obj)
        self.assert_on(obj, (4 + math.sin(math.pi / 4), 0, 7.5), 1e-4)

    def test_only_the_inputs_of_a_choice_are_shown(self):
        obj = self.make(self.line_object(30), (4, 2), up=(0, 1, 0))
        self.assertIn("Hidden", obj.getEditorMode("EndHalfWidth"))
        self.assertIn("Hidden", obj.getEditorMode("Normal"))
        obj.SectionLaw, obj.Planes = "Linear", "Parallel"
        self.assertNotIn("Hidden", obj.getEditorMode("EndHalfWidth"))
        self.assertNotIn("Hidden", obj.getEditorMode("Normal"))


class Up(DocumentTest):
    def test_it_suits_the_spine(self):
        circle = Part.makeCircle(3, Vector(), Vector(0, 1, 0))
        for edges, up in (
            ([Part.makeLine(Vector(), Vector(5, 0, 0))], (0, 0, 1)),
            ([Part.makeLine(Vector(), Vector(0, 0, 5))], (0, 1, 0)),
            ([circle], (0, 1, 0)),
            ([spline().toShape()], (0, 0, 1)),
        ):
            self.assertEqual(suitable_up(edges), up)


class Refusals(SectionTest):
    def setUp(self):
        super().setUp()
        self.spine = self.line_object(30)
        self.obj = self.make(self.spine, ((4, 2), (2, 3)), up=(0, 1, 0))
        self.good = shape_data(self.obj.Shape)

    def assert_fails_and_recovers(self, sentence, repair):
        self.document.recompute()
        self.assert_error(self.obj, sentence)
        self.assertEqual(shape_data(self.obj.Shape), self.good)
        repair()
        self.document.recompute()
        self.assert_valid(self.obj)
        self.assertEqual(shape_data(self.obj.Shape), self.good)

    def test_no_half_axis(self):
        self.obj.EndHalfWidth = 0
        self.assert_fails_and_recovers(
            "The half-axis to the side is zero at parameter 30, point (0, 0, 30).",
            lambda: setattr(self.obj, "EndHalfWidth", 2),
        )

    def test_up_along_the_spine(self):
        self.obj.Up = Vector(0, 0, 1)
        self.assert_fails_and_recovers(
            "The direction upwards is that of the spine", lambda: setattr(self.obj, "Up", Vector(0, 1, 0))
        )

    def test_no_direction(self):
        self.obj.Up = Vector()
        self.assert_fails_and_recovers(
            "The direction upwards has no length.", lambda: setattr(self.obj, "Up", Vector(0, 1, 0))
        )

    def test_a_spine_within_the_planes(self):
        self.obj.Planes = "Parallel"
        self.assert_fails_and_recovers(
            "The spine runs within the plane of a section",
            lambda: setattr(self.obj, "Planes", "Perpendicular"),
        )

    def test_a_corner(self):
        self.spine.Shape = polyline((0, 0, 0), (0, 0, 30), (20, 0, 50))
        self.document.recompute()
        self.assert_error(self.obj, "The sections turn by 45 degrees")
        self.obj.Planes, self.obj.Normal = "Parallel", Vector(0, 0, 1)
        self.document.recompute()
        self.assert_valid(self.obj)

    def test_a_helix_needs_parallel_sections(self):
        self.spine.Shape = Part.makeHelix(20, 10, 15)
        self.document.recompute()
        self.assert_error(self.obj, "The spine has no exact form (a helix).")

    def test_a_wrong_table(self):
        self.obj.SectionLaw = "Table"
        self.obj.Positions, self.obj.HalfWidths, self.obj.HalfHeights = [0, 1], [2, 3], [2]
        self.assert_fails_and_recovers(
            "The half-axis upwards: The table has 2 positions and 1 radii.",
            lambda: setattr(self.obj, "SectionLaw", "Linear"),
        )

    def test_no_spine(self):
        self.obj.Spine = None
        self.assert_fails_and_recovers(
            "The spine is missing.", lambda: setattr(self.obj, "Spine", (self.spine, []))
        )


class Storage(SectionTest):
    def test_it_comes_back_bit_for_bit(self):
        obj = self.make(self.spline_object(), ((3, 1.5), (2, 2)), name="Duct")
        data = shape_data(obj.Shape)
        file = str(self.folder / "duct.FCStd")
        self.document.saveAs(file)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(file)
        self.assertEqual(shape_data(self.document.Duct.Shape), data)
        self.document.Duct.HalfWidth = 4
        self.document.recompute()
        self.assert_valid(self.document.Duct)
