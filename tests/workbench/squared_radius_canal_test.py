# SPDX-License-Identifier: LGPL-2.1-or-later
"""Canal surfaces from r^2 as features: laws, offsets where there are some, solids, and refusals.

Along the z axis r^2 = a + b z + c z^2 makes a quadric of revolution: the circle of the sphere at z
lies at height z - (r^2)' / 2 and has the squared radius r^2 - (r^2)'^2 / 4.
"""

import math

import FreeCAD
import numpy as np
import Part
from support import DocumentTest, polyline, shape_data, volume

import pnsurfaces
from pnsurfaces.definition import definition_of
from pnsurfaces.shape import own_shape

LENGTH = 30.0


class SquaredRadiusTest(DocumentTest):
    def make(self, *args, **properties):
        obj = pnsurfaces.make_squared_radius_canal(*args, **properties)
        self.assert_valid(obj)
        return obj

    def assert_certified(self, obj):
        """All samples lie on the envelope of the spheres that the properties say."""
        (report,) = pnsurfaces.certificate([obj])["objects"]
        for section in report["sections"]:
            sampled = section["sampling"]
            self.assertLessEqual(sampled["worst"], obj.DeviationBound + sampled["rounding"])
        return report

    def assert_on(self, obj, point, tolerance=1e-9):
        distance, _, _ = obj.Shape.distToShape(Part.Vertex(*point))
        self.assertLess(distance, tolerance)


class Laws(SquaredRadiusTest):
    def square_at(self, obj, parameter):
        """The squared radius at a parameter of the spine, by the law that the kernel is given."""
        square = definition_of(obj).squared_radius
        first, last = square.breaks[[0, -1]]
        inside = min(max(parameter, first + 1e-6), last - 1e-6)
        return square.with_derivative(parameter, inside)[0].item()

    def test_a_linear_law_along_a_line_is_a_paraboloid(self):
        obj = self.make(self.line_object(LENGTH), (25, 85), Output="Solid")
        self.assertEqual(obj.Status, "Valid")
        self.assertTrue(obj.Exact)
        self.assert_certified(obj)
        # pi times the integral of 25 + 2 z - 1
        self.assertAlmostEqual(volume(obj), math.pi * (24 * LENGTH + LENGTH**2), delta=1e-8)

    def test_a_quadratic_law_along_a_line_is_an_ellipsoid(self):
        # r^2 = 64 + 2 z - z^2 / 15
        obj = self.make(self.line_object(LENGTH), ("Bezier coefficients", [64, 94, 64]))
        self.assertTrue(obj.Exact)
        self.assert_certified(obj)
        for z in (0, 7.5, 20):
            height, square = z - (1 - z / 15), 64 + 2 * z - z**2 / 15 - (1 - z / 15) ** 2
            self.assert_on(obj, (math.sqrt(square), 0, height))

    def test_a_constant_law_is_a_pipe(self):
        spine = self.spline_object()
        obj = self.make(spine, "2 mm^2", Output="Solid")
        self.assertTrue(obj.Exact)
        self.assert_certified(obj)
        # The centroids of the sections are on the spine.
        self.assertAlmostEqual(volume(obj), 2 * math.pi * spine.Shape.Length, delta=1e-6)

    def test_a_table(self):
        rows = [(0, 25), (12, "0.36 cm^2"), (30, 30)]
        obj = self.make(self.line_object(LENGTH), ("Table", rows), PositionBy="Arc length")
        self.assertEqual(obj.SquaredRadii, [25, 36, 30])
        self.assertTrue(obj.Exact)
        self.assert_certified(obj)
        for z, value in ((0, 25), (12, 36), (30, 30)):
            self.assertAlmostEqual(self.square_at(obj, z), value, delta=1e-12)

    def test_an_expression_is_fitted_and_says_so(self):
        obj = self.make(
            self.line_object(LENGTH), ("Expression", "25 mm^2 + 9 mm^2 * sin(pi*s)"), FitTolerance=1e-4
        )
        self.assertFalse(obj.Exact)
        self.assertIn("Fitted within", obj.Status)
        self.assertIn("the squared radius", obj.Status)
        self.assertGreater(obj.DeviationBound, 1e-9)
        self.assertLess(obj.DeviationBound, 1e-4)
        self.assert_certified(obj)
        # At the middle the law is even: the circle lies in the plane of the centre.
        self.assert_on(obj, (math.sqrt(34), 0, LENGTH / 2), 1e-4)

    def test_a_fit_tells_how_far_the_radius_is_off(self):
        for factor in (1, 100):
            text = f"{factor} * (25 mm^2 + 9 mm^2 * sin(pi*s))"
            obj = self.make(self.line_object(100 * LENGTH), ("Expression", text), FitTolerance=1e-3)
            worst = max(
                abs(
                    math.sqrt(self.square_at(obj, i * LENGTH))
                    - math.sqrt(factor * (25 + 9 * math.sin(math.pi * i / 100)))
                )
                for i in range(101)
            )
            self.assertLess(worst, obj.DeviationBound)
            self.assertGreater(worst, obj.DeviationBound / 20)
            self.assertLess(obj.DeviationBound, 1e-3)

    def test_a_bend_and_a_closed_spine(self):
        circle = self.shape_object(Part.makeCircle(20), "Circle")
        obj = self.make(circle, 7, Output="Solid")
        self.assert_certified(obj)
        # Pappus
        self.assertAlmostEqual(volume(obj), math.pi * 7 * 2 * math.pi * 20, delta=1e-8)
        bent = self.make(self.spline_object(), (4, 7), Output="Solid")
        self.assertEqual(bent.Status, "Valid")
        self.assert_certified(bent)

    def test_only_the_inputs_of_a_law_are_shown(self):
        obj = self.make(self.line_object(), 3)
        self.assertIn("Hidden", obj.getEditorMode("EndSquaredRadius"))
        obj.SquaredRadiusLaw = "Linear"
        self.assertNotIn("Hidden", obj.getEditorMode("EndSquaredRadius"))
        self.assertIn("Hidden", obj.getEditorMode("SquaredRadii"))


class Offsets(SquaredRadiusTest):
    def test_a_rational_radius_has_the_offsets_of_the_canal_surface(self):
        spine = self.spline_object()
        # (2 + t)^2
        obj = self.make(spine, ("Bezier coefficients", [4, 6, 9]), 0.5)
        same = pnsurfaces.make_canal_surface(spine, (2, 3), 0.5)
        self.assertEqual(shape_data(own_shape(obj)), shape_data(own_shape(same)))
        self.assertEqual(obj.MinOffset, same.MinOffset)
        self.assertTrue(obj.RationalRadius)
        self.assert_certified(obj)

    def test_a_wall_where_the_radius_is_rational(self):
        obj = self.make(self.line_object(LENGTH), 9, 1, Sides="Base and offset", Output="Solid")
        self.assertAlmostEqual(volume(obj), math.pi * (16 - 9) * LENGTH, delta=1e-8)

    def test_without_a_rational_radius_there_is_none(self):
        obj = self.make(self.line_object(LENGTH), (25, 85))
        good = shape_data(obj.Shape)
        self.assertEqual((obj.MinOffset.Value, obj.MaxOffset.Value), (0, 0))
        self.assertFalse(obj.RationalRadius)
        report = self.assert_certified(obj)
        self.assertIsNone(report["regular_range"])
        obj.Distance = 1
        self.document.recompute()
        self.assert_error(obj, "The offsets of this surface are not rational")
        self.assertEqual(shape_data(obj.Shape), good)
        obj.Distance = 0
        self.document.recompute()
        self.assert_valid(obj)
        self.assertEqual(shape_data(obj.Shape), good)


class Definition(SquaredRadiusTest):
    def test_it_sees_what_is_off(self):
        obj = self.make(self.line_object(LENGTH), (25, 85))
        definition = definition_of(obj)
        # The circle of the centre (0, 0, 10): height 9, squared radius 45 - 1.
        on = math.sqrt(44)
        for error in (0, 1e-6, -1e-3):
            # Along the normal, which is the ray from the centre.
            point = [part * (1 + error / math.sqrt(45)) for part in (on, 0, -1)]
            points = np.array([[point[0], point[1], 10 + point[2]]])
            (found,) = definition.deviations(points, None, 0)
            self.assertAlmostEqual(found, abs(error), delta=1e-13 + error**2)


class Refusals(SquaredRadiusTest):
    def setUp(self):
        super().setUp()
        self.spine = self.line_object(LENGTH)
        self.obj = self.make(self.spine, (25, 85))
        self.good = shape_data(self.obj.Shape)

    def assert_fails_and_recovers(self, sentence, repair):
        self.document.recompute()
        self.assert_error(self.obj, sentence)
        self.assertEqual(shape_data(self.obj.Shape), self.good)
        repair()
        self.document.recompute()
        self.assert_valid(self.obj)
        self.assertEqual(shape_data(self.obj.Shape), self.good)

    def choose(self, law):
        self.obj.SquaredRadiusLaw = law

    def test_no_radius(self):
        self.obj.EndSquaredRadius = 0
        self.assert_fails_and_recovers(
            "The squared radius is not positive at parameter 30",
            lambda: setattr(self.obj, "EndSquaredRadius", 85),
        )

    def test_a_law_that_is_too_steep(self):
        self.obj.EndSquaredRadius = 1e4
        self.assert_fails_and_recovers("radius", lambda: setattr(self.obj, "EndSquaredRadius", 85))

    def test_a_wrong_table(self):
        self.obj.Positions, self.obj.SquaredRadii = [0, 1], [20]
        self.choose("Table")
        self.assert_fails_and_recovers(
            "The squared radius: The table has 2 positions and 1 values.",
            lambda: self.choose("Linear"),
        )

    def test_expressions_that_are_no_area(self):
        self.choose("Expression")
        for text, sentence in (
            ("", "The squared radius: The expression is empty. Type one, such as 4 mm^2"),
            (
                "2 mm",
                "The squared radius: The expression gives millimetres to the power 1, not an" " area.",
            ),
            ("4 mm^2 - 5 mm^2 * s", "The squared radius is -0.96"),
        ):
            with self.subTest(text):
                self.choose("Expression")
                self.obj.SquaredRadiusExpression = text
                self.assert_fails_and_recovers(sentence, lambda: self.choose("Linear"))

    def test_a_corner(self):
        self.spine.Shape = polyline((0, 0, 0), (0, 0, LENGTH), (20, 0, 50))
        self.document.recompute()
        self.assert_error(self.obj, "The spine or the squared radius turns at parameter 30")
        # Where the radius is rational, a zone of a sphere closes it.
        self.choose("Constant")
        self.document.recompute()
        self.assert_valid(self.obj)

    def test_no_spine(self):
        self.obj.Spine = None
        self.assert_fails_and_recovers(
            "The spine is missing.", lambda: setattr(self.obj, "Spine", (self.spine, []))
        )

    def test_values_that_are_none(self):
        before = self.document.Objects
        with self.assertRaises(Exception):
            pnsurfaces.make_squared_radius_canal(self.spine, "2 kg")
        with self.assertRaises(AttributeError):
            pnsurfaces.make_squared_radius_canal(self.spine, 4, Bore=2)
        self.assertEqual(self.document.Objects, before)


class Storage(SquaredRadiusTest):
    def test_it_comes_back_bit_for_bit(self):
        obj = self.make(self.spline_object(), (4, 7), name="Bubble")
        data = shape_data(obj.Shape)
        file = str(self.folder / "bubble.FCStd")
        self.document.saveAs(file)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(file)
        self.assertEqual(shape_data(self.document.Bubble.Shape), data)
        self.document.Bubble.EndSquaredRadius = "6 mm^2"
        self.document.recompute()
        self.assert_valid(self.document.Bubble)
