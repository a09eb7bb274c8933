# SPDX-License-Identifier: LGPL-2.1-or-later
"""The canal surface in the tree: every property, every error, undo and recovery."""

import math
import re

import Part
from FreeCAD import Placement, Rotation, Vector
from support import (
    KNOTS,
    MULTIPLICITIES,
    POLES,
    RADII,
    DocumentTest,
    Recovery,
    grid,
    polyline,
    shape_data,
    spline,
    volume,
)

from pnsurfaces import kernel, make_canal_surface

CIRCLE_RADIUS = 20.0


class CanalSurfaceTest(DocumentTest):
    def assert_spheres(self, obj, curve, radius, distance):
        """Each point is radius + distance away, along the normal, from the spine's point."""
        for face in obj.Shape.Faces:
            for u, v in grid(face.Surface):
                foot = face.Surface.value(u, v) - (radius(u) + distance) * face.normalAt(u, v)
                self.assertLess((foot - curve.value(u)).Length, 1e-11)

    def circle_object(self):
        circle = Part.Circle(Vector(), Vector(0, 0, 1), CIRCLE_RADIUS)
        return self.shape_object(circle.toShape(), "Circle")


class RadiusLaws(CanalSurfaceTest):
    def test_constant(self):
        obj = make_canal_surface(self.spline_object(), 2)
        self.assert_valid(obj)
        self.assert_spheres(obj, spline(), lambda u: 2.0, 0.0)

    def test_linear(self):
        obj = make_canal_surface(self.spline_object(), (2, 3.5), 0.25)
        self.assert_valid(obj)
        self.assert_spheres(obj, spline(), lambda u: 2 + 1.5 * u, 0.25)

    def test_values_at_vertices(self):
        obj = make_canal_surface(self.spline_object(), ("Values at vertices", RADII), -0.25)
        self.assert_valid(obj)
        surface = obj.Shape.Faces[0].Surface
        for knot, radius in zip(KNOTS, RADII):
            reach = (surface.value(knot, 0.7) - spline().value(knot)).Length
            self.assertAlmostEqual(reach, radius - 0.25, delta=1e-11)

    def test_bezier_coefficients(self):
        a, b, c = 2.0, 1.0, 3.0
        obj = make_canal_surface(self.spline_object(), ("Bezier coefficients", [a, b, c]), 0.5)
        self.assert_valid(obj)
        self.assert_spheres(
            obj, spline(), lambda u: a * (1 - u) ** 2 + 2 * b * u * (1 - u) + c * u**2, 0.5
        )

    def test_one_coefficient_is_constant(self):
        obj = make_canal_surface(self.spline_object(), ("Bezier coefficients", [2.0]))
        constant = make_canal_surface(obj.Spine[0], 2.0)
        self.assertEqual(shape_data(obj.Shape), shape_data(constant.Shape))

    def test_only_the_properties_of_the_law_are_shown(self):
        obj = make_canal_surface(self.line_object(), 2)
        for law, shown in (
            (obj.RadiusLaw, {"Radius"}),
            ("Linear", {"Radius", "EndRadius"}),
            ("Values at vertices", {"Radii"}),
            ("Bezier coefficients", {"Radii"}),
            ("Constant", {"Radius"}),
        ):
            if obj.RadiusLaw != law:
                obj.RadiusLaw = law
            visible = {
                name
                for name in ("Radius", "EndRadius", "Radii")
                if "Hidden" not in obj.getEditorMode(name)
            }
            self.assertEqual(visible, shown)


class Offsets(CanalSurfaceTest):
    def test_offset_lies_along_the_normals_of_the_base(self):
        obj = make_canal_surface(
            self.spline_object(), ("Values at vertices", RADII), 0.5, Sides="Base and offset"
        )
        self.assert_valid(obj)
        base, offset = obj.Shape.Faces
        for u, v in grid(base.Surface):
            expected = base.Surface.value(u, v) + 0.5 * base.normalAt(u, v)
            self.assertLess((offset.Surface.value(u, v) - expected).Length, 1e-11)

    def test_both_sides(self):
        source = self.spline_object()
        inner = make_canal_surface(source, 2, -0.5)
        outer = make_canal_surface(source, 2, 0.5)
        both = make_canal_surface(source, 2, 0.5, Sides="Both sides")
        self.assertEqual(shape_data(both.Shape), shape_data(inner.Shape) + shape_data(outer.Shape))
        self.assertEqual(both.Poles, inner.Poles + outer.Poles)

    def test_distance_zero_makes_no_copy(self):
        source = self.spline_object()
        base = make_canal_surface(source, 2)
        for sides in ("Base and offset", "Both sides"):
            same = make_canal_surface(source, 2, Sides=sides)
            self.assertEqual(shape_data(same.Shape), shape_data(base.Shape))

    def test_lowest_degree(self):
        source = self.spline_object()
        even = make_canal_surface(source, (2, 3))
        lowest = make_canal_surface(source, (2, 3), ParameterLines="Lowest degree")
        self.assert_valid(lowest)
        self.assert_spheres(lowest, spline(), lambda u: 2 + u, 0.0)
        for low, high in zip(lowest.Degree.split(" x "), even.Degree.split(" x ")):
            self.assertLess(int(low), int(high))

    def test_warning_names_the_limit(self):
        obj = make_canal_surface(self.circle_object(), 2, -1)
        self.assertEqual(obj.Status, "Valid")
        self.assertLessEqual(obj.MinOffset.Value, -1)
        self.assertAlmostEqual(obj.MaxOffset.Value, CIRCLE_RADIUS - 2, delta=1e-5)
        for distance, sentence in (
            (20, "^Warning: At 20 mm, beyond the limit of 1[78]"),
            (-3, "^Warning: At -3 mm, beyond the limit of -(2|1.9)"),
        ):
            obj.Distance = distance
            self.document.recompute()
            self.assertTrue(obj.isValid(), obj.getStatusString())
            self.assertRegex(obj.Status, sentence)

    def test_a_pipe_that_meets_itself_is_told(self):
        loop = Part.BezierCurve()
        loop.setPoles([Vector(*p) for p in ((0, 0, 0), (70, 60, 0), (-30, 60, 6), (40, 0, 6))])
        obj = make_canal_surface(self.shape_object(loop.toShape(), "Loop"), 2)
        self.assert_valid(obj)
        # Its two legs pass each other 5.4 mm apart.
        self.assertEqual(obj.Status, "Valid")
        obj.Distance = 1
        self.document.recompute()
        self.assert_valid(obj)
        self.assertGreater(obj.MaxOffset.Value, 1)
        sentence = re.fullmatch(
            r"Warning: At 1 mm the surface crosses itself, at \((.*), (.*), (.*)\) mm\.", obj.Status
        )
        self.assertIsNotNone(sentence, obj.Status)
        # The point is as far from both legs as the pipe is thick.
        point = Vector(*map(float, sentence.groups()))
        distances = [(loop.value(i / 1000) - point).Length for i in range(1001)]
        for leg in (distances[:500], distances[500:]):
            self.assertAlmostEqual(min(leg), 3, delta=0.01)

    def test_a_spine_that_starts_at_rest_has_no_regular_distance(self):
        curve = Part.BezierCurve()
        curve.setPoles([Vector(), Vector(), Vector(5, 5, 0), Vector(10, 0, 3)])
        obj = make_canal_surface(self.shape_object(curve.toShape()), 0.5)
        self.assert_valid(obj)
        self.assertGreaterEqual(obj.MinOffset, obj.MaxOffset)
        self.assertIn("No distance is proved", obj.Status)

    def test_results_are_those_of_the_kernel(self):
        pn = kernel.pnkernel()
        obj = make_canal_surface(self.spline_object(), 2, 0.5)
        base = pn.canal_surface(
            pn.Curve.bspline(3, KNOTS, MULTIPLICITIES, POLES), pn.Law.constant(2.0)
        )
        surface = base.offset(0.5)
        (face,) = surface.bsplines()
        poles = [[tuple(pole) for pole in row] for row in obj.Shape.Faces[0].Surface.getPoles()]
        self.assertEqual(poles, [[tuple(pole) for pole in row] for row in face.poles.tolist()])
        self.assertEqual(obj.Degree, f"{face.u_degree} x {face.v_degree}")
        self.assertEqual(obj.Poles, face.weights.size)
        self.assertEqual(obj.Exact, surface.certificate.exact)
        self.assertEqual((obj.MinOffset.Value, obj.MaxOffset.Value), base.regular_range)
        self.assertGreaterEqual(obj.DeviationBound, surface.certificate.deviation)
        self.assertLess(obj.DeviationBound, 1.1 * surface.certificate.deviation)
        self.assertEqual(obj.Deviation, f"{obj.DeviationBound:.1e} mm")

    def test_exact_joints_need_no_note(self):
        for source in (self.spline_object(), self.circle_object()):
            obj = make_canal_surface(source, 2, 0.5, Sides="Both sides")
            self.assertEqual((obj.Notes, obj.Exact, obj.Status), ([], True, "Valid"))

    def test_a_corner_warns_once_of_its_overlap(self):
        corner = Part.makePolygon([Vector(), Vector(10, 0, 0), Vector(10, 10, 0)])
        obj = make_canal_surface(self.shape_object(corner), 2, 0.5, Sides="Both sides")
        self.assertEqual(len(obj.Notes), 1)
        self.assertIn("(10, 0, 0)", obj.Notes[0])
        self.assertEqual(obj.Status, f"Warning: {obj.Notes[0]}")
        self.assertTrue(obj.Exact)

    def test_a_closed_gap_is_told(self):
        bend = [Vector(), Vector(10, 0, 0), Vector(20, 2e-7, 0)]
        obj = make_canal_surface(self.shape_object(Part.makePolygon(bend)), 2)
        self.assertFalse(obj.Exact)
        self.assertEqual(len(obj.Notes), 1)
        # The gap is the turn times the radius; the bound covers it.
        self.assertGreater(obj.DeviationBound, 2e-8 * 2 / 2)

    def test_limits_do_not_depend_on_the_distance(self):
        source = self.spline_object()
        base, offset = make_canal_surface(source, 2), make_canal_surface(source, 2, 0.5)
        self.assertEqual(base.MinOffset, offset.MinOffset)
        self.assertEqual(base.MaxOffset, offset.MaxOffset)

    def test_unlimited(self):
        self.assertEqual(make_canal_surface(self.line_object(), 2).MaxOffset.Value, math.inf)

    def test_expression(self):
        obj = make_canal_surface(self.line_object(), 2)
        obj.setExpression("Distance", "Radius / 4")
        self.document.recompute()
        self.assertEqual(obj.Distance.Value, 0.5)
        same = make_canal_surface(obj.Spine[0], 2, 0.5)
        self.assertEqual(shape_data(obj.Shape), shape_data(same.Shape))


class Solids(CanalSurfaceTest):
    def test_cylinder(self):
        obj = make_canal_surface(self.line_object(10), 2, 0.5, Output="Solid")
        self.assert_valid(obj)
        self.assertAlmostEqual(volume(obj) / (math.pi * 2.5**2 * 10), 1, delta=1e-12)

    def test_frustum_of_a_cone(self):
        """Radius 3 to 2 over 10 mm; the end circles lie on the end spheres."""
        obj = make_canal_surface(self.line_object(10), (3, 2), Output="Solid")
        self.assert_valid(obj)
        slope = -0.1
        shrink = math.sqrt(1 - slope**2)
        first, last = 3 * shrink, 2 * shrink
        height = 10 - slope * 2 + slope * 3
        expected = math.pi * height * (first**2 + first * last + last**2) / 3
        self.assertAlmostEqual(volume(obj) / expected, 1, delta=1e-12)

    def test_wall_of_a_cylinder(self):
        obj = make_canal_surface(self.line_object(10), 2, 0.5, Sides="Both sides", Output="Solid")
        self.assert_valid(obj)
        self.assertEqual(obj.Shape.ShapeType, "Solid")
        self.assertAlmostEqual(volume(obj) / (math.pi * (2.5**2 - 1.5**2) * 10), 1, delta=1e-12)

    def test_wall_of_a_flaring_pipe_agrees_with_steiner(self):
        """V(d) of the wall between 0 and d is a cubic in d without constant term."""
        source = self.spline_object()
        law = ("Values at vertices", RADII)
        volumes = []
        for i in range(1, 5):
            wall = make_canal_surface(source, law, 0.1 * i, Sides="Base and offset", Output="Solid")
            self.assert_valid(wall)
            volumes.append(volume(wall))
        v1, v2, v3, v4 = volumes
        self.assertGreater(v1, 0)
        self.assertAlmostEqual((4 * v1 - 6 * v2 + 4 * v3 - v4) / v4, 0, delta=1e-9)

    def test_wall_of_many_faces(self):
        source = self.spline_object()
        options = {"Sides": "Both sides", "Output": "Solid"}
        even = make_canal_surface(source, (2, 3), 0.5, **options)
        lowest = make_canal_surface(source, (2, 3), 0.5, ParameterLines="Lowest degree", **options)
        self.assert_valid(lowest)
        self.assertGreater(len(lowest.Shape.Faces), len(even.Shape.Faces))
        self.assertAlmostEqual(volume(lowest) / volume(even), 1, delta=1e-9)

    def test_torus(self):
        obj = make_canal_surface(self.circle_object(), 2, 0.5, Output="Solid")
        self.assert_valid(obj)
        expected = 2 * math.pi**2 * CIRCLE_RADIUS * 2.5**2
        self.assertAlmostEqual(volume(obj) / expected, 1, delta=1e-9)

    def test_wall_of_a_torus(self):
        obj = make_canal_surface(self.circle_object(), 2, 0.5, Sides="Both sides", Output="Solid")
        self.assert_valid(obj)
        self.assertEqual(len(obj.Shape.Shells), 2)
        expected = 2 * math.pi**2 * CIRCLE_RADIUS * (2.5**2 - 1.5**2)
        self.assertAlmostEqual(volume(obj) / expected, 1, delta=1e-9)


class Spines(CanalSurfaceTest):
    def test_corner(self):
        """Two cylinders around the edges, and between them a zone of the sphere at the corner."""
        corner = Vector(20, 0, 0)
        wire = polyline((0, 0, 0), corner, (20, 20, 0))
        obj = make_canal_surface(self.shape_object(wire), 2)
        self.assert_valid(obj)
        first, zone, last = (face.Surface for face in obj.Shape.Faces)
        for u, v in grid(first):
            point = first.value(u, v)
            self.assertAlmostEqual(math.hypot(point.y, point.z), 2, delta=1e-12)
        for u, v in grid(zone):
            self.assertAlmostEqual((zone.value(u, v) - corner).Length, 2, delta=1e-12)
        for u, v in grid(last):
            point = last.value(u, v) - corner
            self.assertAlmostEqual(math.hypot(point.x, point.z), 2, delta=1e-12)

    def test_tangent_line_and_arc_make_no_corner(self):
        arc = Part.Arc(Vector(10, 0, 0), Vector(20, 10, 0), Vector(10, 20, 0)).toShape()
        line = polyline((0, 0, 0), (10, 0, 0))
        source = self.shape_object(Part.Wire([line.Edges[0], arc]))
        obj = make_canal_surface(source, 2, Output="Solid")
        self.assert_valid(obj)
        expected = math.pi * 2**2 * (10 + math.pi * 10)
        self.assertAlmostEqual(volume(obj) / expected, 1, delta=1e-9)

    def test_closed_wire_with_corners(self):
        source = self.shape_object(polyline((0, 0, 0), (20, 0, 0), (20, 30, 0), (0, 0, 0)))
        obj = make_canal_surface(source, 2)
        self.assert_valid(obj)
        self.assertEqual(obj.Shape.isClosed(), True)

    def test_closed_spline_with_radii_at_its_vertices(self):
        """The radius law is periodic, so that no crease needs a face of its own."""
        curve = Part.BSplineCurve()
        points = [Vector(30, 0, 0), Vector(0, 30, 3), Vector(-30, 0, 0), Vector(0, -30, -3)]
        curve.interpolate(points, PeriodicFlag=True)
        source = self.shape_object(curve.toShape())
        obj = make_canal_surface(source, ("Values at vertices", [2, 3, 2.5, 3, 2]), Output="Solid")
        self.assert_valid(obj)
        self.assertEqual(obj.Shape.ShapeType, "Solid")
        self.assertEqual(len(obj.Shape.Faces), 1)
        obj.Radii = [2, 3, 2.5, 3, 2.25]
        self.document.recompute()
        self.assert_error(obj, "its first and last radius must be equal")

    def test_spine_edited(self):
        source = self.line_object(10)
        obj = make_canal_surface(source, 2, Output="Solid")
        source.Shape = Part.makeLine(Vector(), Vector(0, 0, 20))
        self.document.recompute()
        self.assertAlmostEqual(volume(obj) / (math.pi * 2**2 * 20), 1, delta=1e-12)

    def test_chosen_edges(self):
        source = self.shape_object(polyline((0, 0, 0), (10, 0, 0), (10, 20, 0)))
        for names in ("Edge2", ["Edge2"]):
            obj = make_canal_surface((source, names), 2, Output="Solid")
            self.assertAlmostEqual(volume(obj) / (math.pi * 2**2 * 20), 1, delta=1e-12)

    def test_own_placement_survives(self):
        obj = make_canal_surface(self.line_object(), 2)
        placement = Placement(Vector(1, 2, 3), Rotation(10, 20, 30))
        obj.Placement = placement
        obj.Distance = 1
        self.document.recompute()
        self.assertEqual(obj.Placement, placement)
        foot = obj.Shape.Faces[0].valueAt(0, 0) - placement.Base
        self.assertAlmostEqual(foot.Length, 3, delta=1e-12)

    def test_in_a_part(self):
        part = self.document.addObject("App::Part", "Part")
        part.Placement = Placement(Vector(100, 0, 0), Rotation(Vector(0, 0, 1), 90))
        source = self.spline_object()
        expected = shape_data(make_canal_surface(source, 2).Shape)
        part.addObject(source)
        inside = make_canal_surface(source, 2)
        part.addObject(inside)
        inside.touch()
        self.document.recompute()
        self.assertEqual(shape_data(inside.Shape), expected)


class Errors(Recovery, CanalSurfaceTest):
    def setUp(self):
        super().setUp()
        self.source = self.spline_object()
        self.remember(make_canal_surface(self.source, ("Values at vertices", RADII), 0.5))

    def test_no_radii(self):
        def repair():
            self.obj.Radii = RADII
            self.obj.RadiusLaw = "Values at vertices"

        self.obj.RadiusLaw = "Bezier coefficients"
        self.obj.Radii = []
        self.assert_fails_and_recovers("at least one radius", repair)

    def test_impossible_radii(self):
        for radii, sentence in (
            (RADII[:3], "The spine has 5 vertices, but 3 radii are given."),
            ([2.0, 2.0, -3.0, 2.0, 2.0], "The radius is negative"),
            ([20.0, 50.0, 80.0, 110.0, 140.0], "The radius changes faster"),
            ([2.0, math.nan, 2.0, 2.0, 2.0], "not a finite number"),
        ):
            with self.subTest(sentence):
                self.obj.Radii = radii
                self.assert_fails_and_recovers(sentence, lambda: setattr(self.obj, "Radii", RADII))

    def test_spine_deleted(self):
        self.document.removeObject(self.source.Name)

        def repair():
            self.obj.Spine = (self.spline_object(), [])

        self.assert_fails_and_recovers("The spine is missing.", repair)

    def test_spine_without_edge(self):
        self.source.Shape = Part.Vertex(0, 0, 0)
        self.assert_fails_and_recovers(
            "has no edge", lambda: setattr(self.source, "Shape", spline().toShape())
        )

    def test_spine_edited_into_nonsense(self):
        standing = Part.BSplineCurve()
        poles = [Vector(), Vector(), Vector(10, 0, 0)]
        standing.buildFromPolesMultsKnots(poles, [2, 1, 2], [0, 1, 2], False, 1)
        there_and_back = polyline((0, 0, 0), (10, 0, 0), (0, 0, 0))

        def repair():
            self.source.Shape = spline().toShape()
            self.obj.Radii = RADII

        for shape, sentence in (
            (standing.toShape(), "this span has no length"),
            (there_and_back, "turns too sharply"),
        ):
            with self.subTest(sentence):
                self.source.Shape = shape
                self.obj.Radii = [2.0, 2.0, 2.0]
                self.assert_fails_and_recovers(sentence, repair)

    def test_vanished_edge(self):
        self.obj.Spine = (self.source, ["Edge9"])
        self.assert_fails_and_recovers(
            "Spline has no Edge9 any more.", lambda: setattr(self.obj, "Spine", (self.source, []))
        )

    def test_gap(self):
        self.source.Shape = Part.Compound(
            [polyline((0, 0, 0), (10, 0, 0)), polyline((10, 0.5, 0), (20, 5, 0))]
        )
        self.assert_fails_and_recovers(
            "a gap of 0.5 mm", lambda: setattr(self.source, "Shape", spline().toShape())
        )

    def test_unknown_property_leaves_nothing_behind(self):
        before = [obj.Name for obj in self.document.Objects]
        with self.assertRaises(AttributeError):
            make_canal_surface(self.source, 2, Colour="red")
        with self.assertRaises(ValueError):
            make_canal_surface(self.source, 2, Output="Mesh")
        self.assertEqual([obj.Name for obj in self.document.Objects], before)


class UndoAndRedo(CanalSurfaceTest):
    def setUp(self):
        super().setUp()
        self.document.UndoMode = 1
        self.source = self.spline_object()

    def step(self, action):
        self.document.openTransaction("step")
        result = action()
        self.document.commitTransaction()
        return result

    def test_creation(self):
        obj = self.step(lambda: make_canal_surface(self.source, 2, name="Pipe"))
        data = shape_data(obj.Shape)
        self.document.undo()
        self.assertIsNone(self.document.getObject("Pipe"))
        self.document.redo()
        obj = self.document.getObject("Pipe")
        self.assertEqual(shape_data(obj.Shape), data)
        obj.Distance = 1
        self.document.recompute()
        self.assertTrue(obj.isValid())
        self.assertNotEqual(shape_data(obj.Shape), data)

    def test_edit(self):
        obj = make_canal_surface(self.source, 2)
        states = [self.state(obj)]

        def edit():
            obj.RadiusLaw = "Linear"
            obj.EndRadius = 3
            obj.Distance = -0.5
            obj.Output = "Solid"
            self.document.recompute()

        self.step(edit)
        states.append(self.state(obj))
        self.assertNotEqual(*states)
        self.document.undo()
        self.assertEqual(self.state(obj), states[0])
        self.document.redo()
        self.assertEqual(self.state(obj), states[1])

    def state(self, obj):
        values = obj.RadiusLaw, obj.EndRadius, obj.Distance, obj.Output, obj.Degree, obj.Poles
        return values, obj.Status, obj.getEditorMode("EndRadius"), _poles(obj.Shape)


def _poles(shape):
    return [
        face.Surface.getPoles()
        for face in shape.Faces
        if isinstance(face.Surface, Part.BSplineSurface)
    ]
