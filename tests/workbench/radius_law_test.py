# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables, expressions and profiles, looked at on the surface that they make."""

import math

import numpy as np
import Part
from FreeCAD import Vector
from support import DocumentTest, grid, polyline, shape_data, spline

from pnsurfaces import make_canal_surface
from pnsurfaces.spine import read_spine

BEND = 10.0


class LawTest(DocumentTest):
    def bend_object(self):
        """A line and the quarter of a circle that it touches."""
        arc = Part.Circle(Vector(10, BEND, 0), Vector(0, 0, 1), BEND).toShape(-math.pi / 2, 0)
        return self.shape_object(Part.Wire([polyline((0, 0, 0), (10, 0, 0)).Edges[0], arc]), "Bend")

    def circle_object(self):
        return self.shape_object(Part.Circle(Vector(), Vector(0, 0, 1), 20).toShape(), "Circle")

    def assert_made(self, obj):
        self.assert_valid(obj)
        self.assertNotIn("corner", obj.Status)

    def radius_at(self, obj, t):
        """The radius of the envelope's sphere at a parameter of the spine, from the surface.

        The normal of a circle's points meets the spine's point in that distance.
        """
        spine = read_spine(*obj.Spine)
        (stretch,) = [s for s in spine.stretches if s.begin <= t < s.end] or [spine.stretches[-1]]
        centre = stretch.point(t)
        return obj.Shape.distToShape(Part.Vertex(centre))[0]


class Tables(LawTest):
    def test_positions_are_places_on_the_spine(self):
        """The spheres at the rows touch the surface from inside."""
        source = self.spline_object()
        spine = read_spine(source, [])
        for measure, positions, parameters in (
            ("Parameter", [0, 0.3, 0.8, 1], [0, 0.3, 0.8, 1]),
            ("Vertex", [1, 3, 4, 5], [0, 0.5, 0.7, 1]),
            ("Arc length", [0, 20, 40, spine.length], None),
            ("Relative length", [0, 0.25, 0.5, 1], None),
        ):
            rows = list(zip(positions, [2, 2.5, 2.25, 3]))
            obj = make_canal_surface(source, ("Table", rows), PositionBy=measure)
            self.assert_made(obj)
            self.assertTrue(obj.Exact)
            self.assertEqual(obj.FitDeviation, "0 mm")
            scale = spine.length if measure == "Relative length" else 1.0
            for i, (position, radius) in enumerate(rows):
                t = parameters[i] if parameters else self.at_length(position * scale)
                with self.subTest(measure, position=position):
                    self.assertAlmostEqual(self.radius_at(obj, t), radius, delta=1e-7)

    def at_length(self, length):
        """The parameter of the spline at a length, by bisection of Part's own lengths."""
        low, high = 0.0, 1.0
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if spline().length(0, middle) < length else (low, middle)
        return low

    def test_the_vertices_may_be_named_by_a_table(self):
        source = self.spline_object()
        radii = [2.0, 2.5, 1.5, 1.75, 3.0]
        rows = list(zip(range(1, 6), radii))
        table = make_canal_surface(source, ("Table", rows), PositionBy="Vertex")
        vertices = make_canal_surface(source, ("Values at vertices", radii))
        self.assertEqual(shape_data(table.Shape), shape_data(vertices.Shape))

    def test_rows_in_any_order_and_with_units(self):
        line = self.line_object(100)
        rows = [("10 cm", 3), (0, "2 mm"), ("1 in", "0.1 in")]
        obj = make_canal_surface(line, ("Table", rows), PositionBy="Arc length")
        self.assert_made(obj)
        for height, radius in ((0, 2), (25.4, 2.54), (100, 3)):
            self.assertAlmostEqual(self.radius_at(obj, height), radius, delta=1e-7)
        self.assertEqual(obj.Radii, [3, 2, 2.54])

    def test_rows_need_not_reach_the_ends(self):
        rows = [(0.2, 2), (0.5, 3), (0.7, 2.5)]
        obj = make_canal_surface(self.spline_object(), ("Table", rows), PositionBy="Parameter")
        self.assert_made(obj)
        for t, radius in rows:
            self.assertAlmostEqual(self.radius_at(obj, t), radius, delta=1e-7)

    def test_rows_on_a_line_are_linear(self):
        curve = Part.BezierCurve()
        curve.setPoles([Vector(), Vector(30, 10, 0), Vector(50, 40, 10)])
        source = self.shape_object(curve.toShape())
        rows = [(0.1, 2.1), (0.3, 2.3), (0.9, 2.9)]
        obj = make_canal_surface(source, ("Table", rows), PositionBy="Parameter")
        self.assert_made(obj)
        self.assertEqual(obj.Degree, make_canal_surface(source, (2, 3)).Degree)

    def test_two_rows_are_linear(self):
        obj = make_canal_surface(self.line_object(100), ("Table", [(0.25, 2), (0.75, 3)]))
        linear = make_canal_surface(obj.Spine[0], (1.5, 3.5))
        self.assertAlmostEqual(obj.Shape.Area, linear.Shape.Area, delta=1e-6)

    def test_one_row_is_constant(self):
        obj = make_canal_surface(self.line_object(), ("Table", [(0.5, 2)]))
        constant = make_canal_surface(obj.Spine[0], 2)
        self.assertEqual(shape_data(obj.Shape), shape_data(constant.Shape))

    def test_a_closed_spine_closes_its_table(self):
        source = self.circle_object()
        rows = [(0, 3), (0.3, 4), (0.7, 3.5)]
        obj = make_canal_surface(source, ("Table", rows), Output="Solid")
        self.assert_made(obj)
        again = make_canal_surface(source, ("Table", [*rows, (1, 3)]), Output="Solid")
        self.assertEqual(shape_data(obj.Shape), shape_data(again.Shape))

    def test_a_smooth_law_stays_smooth_through_a_tangent_joint(self):
        obj = make_canal_surface(self.bend_object(), ("Table", [(0, 2), (0.4, 2.5), (1, 2)]))
        self.assert_made(obj)
        self.assertEqual((obj.Status, obj.Exact), ("Valid", True))

    def test_what_is_refused(self):
        line = self.line_object(100)
        for rows, measure, sentence in (
            ([], "Parameter", "0 positions and 0 values"),
            ([(0, 2), (0, 3)], "Parameter", "Two rows of the table have the position 0"),
            ([(0, 2), (1.5, 3)], "Parameter", "Position 1.5 .* runs from 0 to 1"),
            ([(0, 2), (120, 3)], "Arc length", "Position 120 .* runs from 0 to 100"),
            ([(0, 2), (-3, 3)], "Relative length", "Position -3 "),
            ([(1, 2), (1.5, 3)], "Vertex", "1.5 is not the number of a vertex"),
            ([(1, 2), (3, 3)], "Vertex", "Position 3 .* runs from 1 to 2"),
        ):
            obj = make_canal_surface(line, ("Table", rows), PositionBy=measure)
            with self.subTest(sentence):
                self.assertRegex(obj.getStatusString(), sentence)
        obj = make_canal_surface(self.circle_object(), ("Table", [(0.2, 2), (0.7, 3)]))
        self.assert_error(obj, "give the table a row at its start")
        obj.Positions = [0.0, 1.0]
        obj.recompute()
        self.assert_error(obj, "first and last radius must be equal")
        obj.Positions = [0.0]
        obj.recompute()
        self.assert_error(obj, "1 positions and 2 values")


class Expressions(LawTest):
    def assert_follows(self, obj, radius):
        """The surface is within its bound of the spheres of the expression."""
        self.assert_made(obj)
        spine = read_spine(*obj.Spine)
        self.assertFalse(obj.Exact)
        for length in np.linspace(0.1, 0.9, 9) * spine.length:
            t = spine.parameter_at(length)
            expected = radius(length / spine.length)
            # The nearest point of the envelope to a centre is on its sphere, or nearer elsewhere.
            self.assertLessEqual(self.radius_at(obj, t), expected + obj.DeviationBound)

    def test_measured_against_spheres(self):
        text = "2 mm + 0.5 mm * sin(2*pi*s)"
        for source in (self.line_object(60), self.bend_object(), self.spline_object()):
            obj = make_canal_surface(source, ("Expression", text))
            self.assert_follows(obj, lambda s: 2 + 0.5 * math.sin(2 * math.pi * s))

    def test_surface_of_revolution(self):
        """Along a line every point of the envelope is known: x = z - r r', y = r sqrt(1 - r'^2)."""
        obj = make_canal_surface(
            self.line_object(100), ("Expression", "4 mm + 1 mm * cos(2*pi*s)"), FitTolerance=1e-7
        )
        omega = 2 * math.pi / 100
        for z in np.linspace(1, 99, 12):
            r, slope = 4 + math.cos(omega * z), -omega * math.sin(omega * z)
            point = Vector(r * math.sqrt(1 - slope**2), 0, z - r * slope)
            gap = obj.Shape.distToShape(Part.Vertex(point))[0]
            self.assertLessEqual(gap, obj.DeviationBound)
        self.assertLess(obj.DeviationBound, 1.1e-7)
        self.assertIn("measured", obj.FitDeviation)

    def test_a_closed_spine(self):
        obj = make_canal_surface(
            self.circle_object(), ("Expression", "3 mm + 1 mm * cos(2*pi*s)"), Output="Solid"
        )
        self.assert_made(obj)
        self.assertEqual(obj.Shape.ShapeType, "Solid")

    def test_an_arc_length_is_a_length(self):
        source = self.line_object(50)
        by_length = make_canal_surface(
            source, ("Expression", "2 mm + s / 25"), PositionBy="Arc length"
        )
        self.assert_made(by_length)
        linear = make_canal_surface(source, (2, 4))
        self.assertAlmostEqual(by_length.Shape.Area, linear.Shape.Area, delta=1e-9)

    def test_a_looser_tolerance_needs_fewer_poles(self):
        source = self.line_object(60)
        text = "2 mm + 0.5 mm * sin(2*pi*s)"
        tight = make_canal_surface(source, ("Expression", text))
        loose = make_canal_surface(source, ("Expression", text), FitTolerance="1 um")
        self.assertLess(loose.Poles, tight.Poles / 2)
        self.assertLessEqual(loose.DeviationBound, 1.1e-3)

    def test_what_is_refused(self):
        obj = make_canal_surface(self.line_object(), ("Expression", "1 mm / s"))
        self.assert_error(obj, "no finite value at position 0")
        obj.RadiusExpression = "1 mm * sqrt((s - 0.3)^2)"
        obj.recompute()
        self.assert_error(obj, "has a kink or a jump near parameter 2.98828")
        obj.PositionBy = "Vertex"
        obj.recompute()
        self.assert_error(obj, "Between vertices there are no positions")


class Profiles(LawTest):
    def test_the_pipe_runs_through_the_profile(self):
        arc = Part.Arc(Vector(10, 0, -5), Vector(5, 0, 50), Vector(10, 0, 105)).toShape()
        skew = Part.makeLine(Vector(6, -4, -5), Vector(4, 8, 105))
        for shape in (arc, skew):
            profile = self.shape_object(shape, "Profile")
            obj = make_canal_surface(self.line_object(100), ("Profile", (profile, "Edge1")))
            self.assert_made(obj)
            first, last = shape.ParameterRange
            for share in np.linspace(0.15, 0.85, 9):
                point = shape.valueAt(first + share * (last - first))
                gap = obj.Shape.distToShape(Part.Vertex(point))[0]
                self.assertLessEqual(gap, obj.DeviationBound)

    def test_a_straight_profile_in_the_plane_of_a_line_is_exact(self):
        profile = self.shape_object(polyline((3, 0, -50), (9, 0, 150)), "Profile")
        source = self.line_object(100)
        obj = make_canal_surface(source, ("Profile", profile))
        self.assertTrue(obj.Exact)
        # The distance of a line of slope 3 to 100 from (0, 0, z).
        radii = [(4.5 + 3 * z / 100) / math.hypot(1, 0.03) for z in (0, 100)]
        linear = make_canal_surface(source, tuple(radii))
        self.assertAlmostEqual(obj.Shape.Area, linear.Shape.Area, delta=1e-9)

    def test_other_straight_profiles_are_fitted(self):
        for points in (
            ((3, 0, -50), (9, 1e-6, 150)),  # not in the plane of the spine
            ((3, 0, -50), (9, 0, 50)),  # shorter than the spine
        ):
            profile = self.shape_object(polyline(*points), "Profile")
            obj = make_canal_surface(self.line_object(100), ("Profile", profile))
            self.assert_valid(obj)
            self.assertFalse(obj.Exact)

    def test_along_a_curved_spine(self):
        """The offset of a circle is its profile: a torus."""
        ring = Part.Circle(Vector(), Vector(0, 0, 1), 26).toShape()
        obj = make_canal_surface(
            self.circle_object(), ("Profile", self.shape_object(ring)), Output="Solid"
        )
        self.assert_made(obj)
        for face in obj.Shape.Faces:
            for u, v in grid(face.Surface):
                point = face.Surface.value(u, v)
                reach = math.hypot(math.hypot(point.x, point.y) - 20, point.z)
                self.assertAlmostEqual(reach, 6, delta=obj.DeviationBound)

    def test_what_is_refused(self):
        across = self.shape_object(polyline((-5, 0, 5), (5, 0, 5)))
        obj = make_canal_surface(self.line_object(10), ("Profile", across))
        self.assert_error(obj, "The profile meets the spine at (0, 0, 5)")
        obj.Profile = (self.shape_object(Part.Vertex(0, 0, 0), "Point"), [])
        obj.recompute()
        self.assert_error(obj, "Point has no edge")
        obj.Profile = None
        obj.recompute()
        self.assert_error(obj, "The profile is missing")
