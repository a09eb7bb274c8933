# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving conic sections as features: conics, planes, laws, solids, fits, and refusals."""

import math

import FreeCAD
import Part
from FreeCAD import Vector
from support import DocumentTest, polyline, samples, shape_data, spline, volume

import pnsurfaces
from pnsurfaces import kernel
from pnsurfaces.definition import definition_of
from pnsurfaces.moving_conic_section import suitable_up


class SectionTest(DocumentTest):
    def make(self, *args, **properties):
        obj = pnsurfaces.make_moving_conic_section(*args, **properties)
        self.assert_valid(obj)
        return obj

    def assert_certified(self, obj):
        """All samples lie on the conics that the properties say."""
        (report,) = pnsurfaces.certificate([obj])["objects"]
        (section,) = report["sections"]
        sampled = section["sampling"]
        self.assertLessEqual(sampled["worst"], obj.DeviationBound + sampled["rounding"])

    def assert_on(self, obj, point, tolerance=1e-9):
        distance, _, _ = obj.Shape.distToShape(Part.Vertex(*point))
        self.assertLess(distance, tolerance)

    def bent_duct(self):
        """A straight piece, a quarter turn of radius 30, and a straight piece, in the plane y = 0."""
        arc = Part.Arc(
            Vector(20, 0, 0),
            Vector(20 + 30 * math.sin(math.pi / 4), 0, 30 - 30 * math.cos(math.pi / 4)),
            Vector(50, 0, 30),
        )
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
        obj = self.make(self.line_object(30), ("Table", rows), up=(0, 1, 0), PositionBy="Arc length")
        self.assert_certified(obj)
        for point in ((4, 0, 0), (3, 0, 12), (0, 3, 12), (0, 2, 30)):
            self.assert_on(obj, point)

    def test_expressions_are_fitted_and_say_so(self):
        obj = self.make(
            self.line_object(30),
            ("Expression", ("4 mm + 1 mm * sin(pi*s)", "2 mm")),
            up=(0, 1, 0),
            FitTolerance=1e-4,
        )
        self.assertFalse(obj.Exact)
        self.assertIn("Fitted within", obj.Status)
        self.assertGreater(obj.DeviationBound, 1e-9)
        self.assertLess(obj.DeviationBound, 2e-4)
        self.assert_certified(obj)
        self.assert_on(obj, (4 + math.sin(math.pi / 4), 0, 7.5), 1e-4)

    def test_sections_have_as_many_values_as_they_need(self):
        for name, given in (
            ("half_axes", (1, 2, 3)),
            ("vertex", ((4, -1, 2), (4, -1))),
            ("vertex", ("Table", [(0, 4, -1)])),
            ("vertex", ("Expression", ("4 mm", "-1"))),
        ):
            with self.subTest(given), self.assertRaisesRegex(ValueError, "There are . values for"):
                pnsurfaces.make_moving_conic_section(self.line_object(), **{name: given})
        with self.assertRaisesRegex(ValueError, "Either half_axes or vertex"):
            pnsurfaces.make_moving_conic_section(self.line_object())

    def test_only_the_inputs_of_a_choice_are_shown(self):
        obj = self.make(self.line_object(30), (4, 2), up=(0, 1, 0))
        self.assertIn("Hidden", obj.getEditorMode("EndHalfWidth"))
        self.assertIn("Hidden", obj.getEditorMode("Normal"))
        obj.SectionLaw, obj.Planes = "Linear", "Parallel"
        self.assertNotIn("Hidden", obj.getEditorMode("EndHalfWidth"))
        self.assertNotIn("Hidden", obj.getEditorMode("Normal"))
        self.assertIn("Hidden", obj.getEditorMode("ConicConstant"))
        obj.Section = "From the vertex"
        self.assertIn("Hidden", obj.getEditorMode("HalfWidth"))
        for name in ("EndRadius", "EndConicConstant", "EndDepth"):
            self.assertNotIn("Hidden", obj.getEditorMode(name))


class FromTheVertex(SectionTest):
    """The line is upright and up is y: sections have x to the side, and z along."""

    def trough(self, vertex, **properties):
        return self.make(self.line_object(30), vertex=vertex, up=(0, 1, 0), **properties)

    def half_width(self, radius, constant, height):
        return math.sqrt(2 * radius * height - (1 + constant) * height**2)

    def assert_section(self, obj, radius, constant, depth, z):
        """The arc at z goes from the vertex up to the depth, and no arc further than its edge."""
        for height in (0, 0.3 * depth, depth):
            side = self.half_width(radius, constant, height)
            for x in (side, -side):
                self.assert_on(obj, (x, height, z))
        points, _ = samples(obj)
        self.assertLess(points[:, 1].max(), depth + 1e-5)

    def test_each_type(self):
        for name, constant in (
            ("hyperbola", -2.5),
            ("parabola", -1),
            ("ellipse", 0.5),
            ("circle", 0),
            ("tall", -0.5),
        ):
            with self.subTest(name):
                obj = self.trough((10, constant, 5))
                self.assertEqual(obj.Status, "Valid")
                self.assertTrue(obj.Exact)
                self.assert_section(obj, 10, constant, 5, 12)
                self.assert_certified(obj)

    def test_the_area_of_a_parabolic_trough(self):
        obj = self.trough((10, -1, 5))
        # Both arms of x = p t, y = p t^2 / 2 with p = 10, up to t = 1
        arm = 10 * (math.sqrt(2) + math.asinh(1)) / 2
        self.assertAlmostEqual(obj.Area.Value, 30 * 2 * arm, delta=1e-8)

    def test_the_type_changes_along_the_spine(self):
        obj = self.trough(((10, -2.5, 5), (14, 0.5, 5)))
        self.assertEqual(obj.Status, "Valid")
        for share in (0, 0.5, 1):
            self.assert_section(obj, 10 + 4 * share, -2.5 + 3 * share, 5, 30 * share)
        self.assert_certified(obj)
        self.assertEqual(len(obj.Shape.Faces), 1)

    def test_a_table(self):
        rows = [(0, 10, -2, 5), (12, "1.2 cm", -1, 5), (30, 14, 0.5, 5)]
        obj = self.trough(("Table", rows), PositionBy="Arc length")
        for z, radius, constant in ((0, 10, -2), (12, 12, -1), (30, 14, 0.5)):
            self.assert_section(obj, radius, constant, 5, z)
        self.assert_certified(obj)

    def test_expressions_are_fitted_and_say_so(self):
        texts = ("10 mm * exp(s / 10)", "-1 + 0.5 * sin(pi*s)", "5 mm")
        obj = self.trough(("Expression", texts), FitTolerance=1e-4)
        self.assertFalse(obj.Exact)
        for words in ("the radius of curvature at the vertex", "the conic constant"):
            self.assertIn(words, obj.Status)
        self.assertGreater(obj.DeviationBound, 1e-7)
        self.assertLess(obj.DeviationBound, 1e-3)
        self.assert_certified(obj)
        radius, constant = 10 * math.exp(1 / 40), -1 + 0.5 * math.sin(math.pi / 4)
        for height in (1, 5):
            side = self.half_width(radius, constant, height)
            self.assert_on(obj, (side, height, 7.5), obj.DeviationBound)

    def test_fits_move_points_by_no_more_than_is_said(self):
        """Deep and narrow, where an error of the conic constant counts most."""
        texts = ("5 mm", "-2 + 0.5 * sin(2*pi*s)", "20 mm")
        obj = self.trough(("Expression", texts), FitTolerance=1e-3)
        worst = 0
        for k in range(1, 64):
            constant = -2 + 0.5 * math.sin(2 * math.pi * k / 64)
            side = self.half_width(5, constant, 20)
            distance, *_ = obj.Shape.distToShape(Part.Vertex(side, 20, 30 * k / 64))
            worst = max(worst, distance)
        self.assertGreater(worst, 1e-4)
        self.assertLess(worst, obj.DeviationBound)

    def test_along_a_bend_and_around_a_circle(self):
        obj = self.make(self.bent_duct(), vertex=((8, -1.25, 4), (8, -2, 3)), up=(0, 1, 0))
        self.assertEqual(obj.Status, "Valid")
        self.assert_certified(obj)
        self.assertEqual(len(obj.Shape.Faces), 3)
        self.assertEqual(len(obj.Shape.Shells), 1)
        parabolas = self.make(self.bent_duct(), vertex=(8, -1, 4), up=(0, 1, 0))
        self.assert_certified(parabolas)
        self.assertEqual(len(parabolas.Shape.Shells), 1)
        ring = self.make(self.shape_object(Part.makeCircle(20)), vertex=(3, -1, 2))
        self.assert_certified(ring)
        self.assert_on(ring, (20 + math.sqrt(12), 0, 2))
        self.assertEqual(len(ring.Shape.Shells), 1)

    def test_parallel_sections_of_a_spine_in_space(self):
        obj = self.make(self.spline_object(), vertex=(6, -1.5, 4), normal=(1, 0, 0))
        self.assertEqual(obj.Status, "Valid")
        self.assert_certified(obj)

    def test_upright_sections_of_a_spine_in_space_and_of_a_tilted_circle(self):
        for source, up in (
            (self.spline_object(), (0, 0, 1)),
            (self.shape_object(Part.makeCircle(20, Vector(1, 2, 3), Vector(1, 2, 3))), (1, 2, 3)),
        ):
            obj = self.make(source, vertex=(6, -1.5, 4), up=up, Planes="Upright")
            self.assertEqual(obj.Status, "Valid")
            self.assertTrue(obj.Exact)
            self.assert_certified(obj)
            # The edge is the depth above the spine, and the half-width beside it as seen from above.
            edge = source.Shape.Edges[0]
            parameter = edge.FirstParameter + 0.3 * (edge.LastParameter - edge.FirstParameter)
            upwards = Vector(*up).normalize()
            side = edge.tangentAt(parameter).cross(upwards).normalize()
            for sign in (1, -1):
                place = edge.valueAt(parameter) + 4 * upwards
                self.assert_on(obj, place + sign * self.half_width(6, -1.5, 4) * side, 1e-5)

    def test_a_change_of_the_section_and_back(self):
        obj = self.make(self.line_object(30), (4, 2), up=(0, 1, 0))
        data = shape_data(obj.Shape)
        obj.Section, obj.Radius, obj.ConicConstant, obj.Depth = "From the vertex", 10, -1.5, 5
        self.document.recompute()
        self.assert_valid(obj)
        self.assert_section(obj, 10, -1.5, 5, 20)
        obj.Section = "Ellipse"
        self.document.recompute()
        self.assertEqual(shape_data(obj.Shape), data)

    def test_the_definition_sees_another_conic(self):
        obj, other = self.trough((10, -1, 5)), self.trough((10, -1.001, 5))
        points, normals = samples(other)
        found = definition_of(obj).deviations(points, normals, 0)
        # In the section the distance is the change of the square of x by that of its gradient.
        self.assertAlmostEqual(found.max(), 0.001 * 25 / (2 * math.hypot(10, 10)), delta=1e-6)


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


class RefusalTest(SectionTest):
    def setUp(self):
        super().setUp()
        self.spine = self.line_object(30)

    def keep(self, obj):
        self.obj = obj
        self.good = shape_data(obj.Shape)

    def assert_fails_and_recovers(self, sentence, repair):
        self.document.recompute()
        self.assert_error(self.obj, sentence)
        self.assertEqual(shape_data(self.obj.Shape), self.good)
        repair()
        self.document.recompute()
        self.assert_valid(self.obj)
        self.assertEqual(shape_data(self.obj.Shape), self.good)


class Refusals(RefusalTest):
    def setUp(self):
        super().setUp()
        self.keep(self.make(self.spine, ((4, 2), (2, 3)), up=(0, 1, 0)))

    def test_no_half_axis(self):
        self.obj.EndHalfWidth = 0
        self.assert_fails_and_recovers(
            "The half-axis to the side is zero at parameter 30, point (0, 0, 30).",
            lambda: setattr(self.obj, "EndHalfWidth", 2),
        )

    def test_up_along_the_spine(self):
        self.obj.Up = Vector(0, 0, 1)
        self.assert_fails_and_recovers(
            "The direction upwards is that of the spine",
            lambda: setattr(self.obj, "Up", Vector(0, 1, 0)),
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
            "The half-axis upwards: The table has 2 positions and 1 values.",
            lambda: setattr(self.obj, "SectionLaw", "Linear"),
        )

    def test_no_spine(self):
        self.obj.Spine = None
        self.assert_fails_and_recovers(
            "The spine is missing.", lambda: setattr(self.obj, "Spine", (self.spine, []))
        )


class RefusalsFromTheVertex(RefusalTest):
    def setUp(self):
        super().setUp()
        self.keep(self.make(self.spine, vertex=((10, -1, 5), (10, 0.5, 5)), up=(0, 1, 0)))

    def test_a_depth_beyond_the_ellipse(self):
        self.obj.EndDepth = 20
        self.assert_fails_and_recovers(
            "The height of the ellipse above the depth is negative at parameters",
            lambda: setattr(self.obj, "EndDepth", 5),
        )

    def test_no_radius(self):
        self.obj.Radius = 0
        self.assert_fails_and_recovers(
            "The radius of curvature at the vertex is zero at parameter 0, point (0, 0, 0).",
            lambda: setattr(self.obj, "Radius", 10),
        )

    def test_no_depth(self):
        self.obj.EndDepth = 0
        self.assert_fails_and_recovers(
            "The depth is zero at parameter 30, point (0, 0, 30).",
            lambda: setattr(self.obj, "EndDepth", 5),
        )

    def test_planes_in_which_up_has_no_rational_length(self):
        self.spine.Shape = spline().toShape()
        self.document.recompute()
        self.assert_error(self.obj, "Sections from the vertex are not rational")
        for planes in ("Parallel", "Upright"):
            self.obj.Planes = planes
            self.document.recompute()
            self.assert_valid(self.obj)

    def test_a_solid(self):
        self.obj.Output = "Solid"
        self.assert_fails_and_recovers(
            "Sections from the vertex are open and enclose no solid.",
            lambda: setattr(self.obj, "Output", "Surface"),
        )

    def test_a_conic_constant_with_a_unit(self):
        self.obj.SectionLaw, self.obj.PositionBy = "Expression", "Arc length"
        self.obj.RadiusExpression = self.obj.DepthExpression = "5 mm"
        self.obj.ConicConstantExpression = "0 * s"
        self.assert_fails_and_recovers(
            "The conic constant: The expression gives millimetres to the power 1, not a plain number.",
            lambda: setattr(self.obj, "SectionLaw", "Linear"),
        )

    def test_a_wrong_table(self):
        self.obj.SectionLaw, self.obj.Positions = "Table", [0, 1]
        self.obj.Radii, self.obj.ConicConstants, self.obj.Depths = [10, 10], [-1], [5, 5]
        self.assert_fails_and_recovers(
            "The conic constant: The table has 2 positions and 1 values.",
            lambda: setattr(self.obj, "SectionLaw", "Linear"),
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

    def test_a_document_without_sections_from_the_vertex_has_ellipses(self):
        obj = self.make(self.line_object(30), (4, 2), up=(0, 1, 0), name="Duct")
        data = shape_data(obj.Shape)
        for name in ("Section", "ConicConstant", "Depths"):
            obj.removeProperty(name)
        file = str(self.folder / "duct.FCStd")
        self.document.saveAs(file)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(file)
        duct = self.document.Duct
        self.assertEqual(duct.Section, "Ellipse")
        for name in ("ConicConstant", "Depths"):
            self.assertIn("Hidden", duct.getEditorMode(name))
        self.document.recompute(None, True)
        self.assertEqual(shape_data(duct.Shape), data)
