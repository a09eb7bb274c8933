# SPDX-License-Identifier: LGPL-2.1-or-later
"""The offset of a ruled surface in the tree: every property, every error, recovery."""

import math

import Part
from FreeCAD import Placement, Rotation, Vector
from support import DocumentTest, Recovery, base_and_offset, grid, polyline, spline, volume

from pnsurfaces import make_ruled_offset

# Two skew lines, between which a hyperbolic paraboloid lies.
SKEW = [((0, 0, 0), (30, 0, 0)), ((0, 20, 0), (30, 20, 15))]


def upper_spline():
    """A curve above support.spline(), with other knots and poles."""
    curve = Part.BezierCurve()
    curve.setPoles([Vector(2, 1, 25), Vector(25, 6, 31), Vector(45, -2, 28), Vector(63, 20, 30)])
    return curve


class RuledOffsetTest(DocumentTest):
    def lines(self):
        return [self.shape_object(polyline(*line), "Line") for line in SKEW]

    def curves(self):
        return [self.shape_object(curve.toShape(), "Curve") for curve in (spline(), upper_spline())]


class Surfaces(RuledOffsetTest):
    def test_base_lies_on_the_lines_between_the_curves(self):
        obj = make_ruled_offset(*self.curves())
        self.assert_valid(obj)
        ruled = Part.makeRuledSurface(*(source.Shape.Edges[0] for source in self.curves()))
        for face in obj.Shape.Faces:
            for u, v in grid(face.Surface, 5):
                if face.isPartOfDomain(u, v):
                    point = Part.Vertex(face.Surface.value(u, v))
                    self.assertLess(ruled.distToShape(point)[0], 1e-6)

    def test_offset_lies_along_the_normals_of_the_base(self):
        for distance in (2, -1.5):
            obj = make_ruled_offset(*self.curves(), distance, Sides="Base and offset")
            self.assert_valid(obj)
            self.assert_offset(obj, distance)
            half = len(obj.Shape.Faces) // 2
            for base, offset in zip(obj.Shape.Faces[:half], obj.Shape.Faces[half:]):
                for u, v in grid(base.Surface, 6):
                    step = offset.Surface.value(u, v) - base.Surface.value(u, v)
                    tangents = base.Surface.tangent(u, v)
                    for tangent in tangents:
                        self.assertLess(abs(step * tangent), 1e-9)

    def test_hyperbolic_paraboloid(self):
        """Between the two lines z = x y / 40."""
        obj = make_ruled_offset(*self.lines(), 1, Sides="Base and offset")
        self.assert_valid(obj)
        for base, offset in base_and_offset(obj):
            self.assertAlmostEqual(base.z, base.x * base.y / 40, delta=1e-12)
            normal = Vector(-base.y / 40, -base.x / 40, 1).normalize()
            self.assertLess((offset - base).cross(normal).Length, 1e-12)

    def test_limits_of_a_hyperbolic_paraboloid(self):
        """With k = 1/40 its principal radii at (0, 0) are -40 and 40, at other points longer."""
        lines = [
            self.shape_object(polyline((-30, y, -0.75 * y), (30, y, 0.75 * y)), "Line")
            for y in (-20, 20)
        ]
        obj = make_ruled_offset(*lines, 1)
        self.assertAlmostEqual(obj.MinOffset.Value, -40, delta=1e-4)
        self.assertAlmostEqual(obj.MaxOffset.Value, 40, delta=1e-4)
        obj.Distance = 50
        self.document.recompute()
        self.assertTrue(obj.isValid(), obj.getStatusString())
        self.assertRegex(obj.Status, "^Warning: At 50 mm, beyond the limit of (40|39.999)")

    def test_reversed_curve(self):
        obj = make_ruled_offset(*self.lines(), Reversed=True)
        self.assert_valid(obj)
        (face,) = obj.Shape.Faces
        (x0, _, _), (x1, _, _) = SKEW[0]
        for u, v in grid(face.Surface, 6):
            point = face.Surface.value(u, v)
            # The ruling through y joins x0 + t and x1 - t, at the heights 0 and (x1 - t) / 2.
            share = point.y / 20
            t = (point.x - share * x1) / (1 - 2 * share) if abs(share - 0.5) > 1e-3 else None
            if t is not None:
                self.assertAlmostEqual(point.z, share * (x1 - t) / 2, delta=1e-10)

    def test_object_with_one_face(self):
        shape = Part.makeRuledSurface(*(source.Shape.Edges[0] for source in self.lines()))
        source = self.shape_object(shape, "Ruled")
        by_face, by_curves = make_ruled_offset(source, None, 1), make_ruled_offset(*self.lines(), 1)
        self.assert_valid(by_face)
        self.assertEqual(
            [_poles(face) for face in by_face.Shape.Faces],
            [_poles(face) for face in by_curves.Shape.Faces],
        )

    def test_edges_of_one_object(self):
        lines = self.shape_object(Part.Compound([polyline(*line) for line in SKEW]), "Lines")
        obj = make_ruled_offset((lines, "Edge1"), (lines, ["Edge2"]), 1)
        self.assert_valid(obj)
        self.assertEqual((obj.CurveA, obj.CurveB), ((lines, ["Edge1"]), (lines, ["Edge2"])))

    def test_own_placement_survives(self):
        obj = make_ruled_offset(*self.lines(), 1)
        placement = Placement(Vector(1, 2, 3), Rotation(10, 20, 30))
        obj.Placement = placement
        obj.Distance = 2
        self.document.recompute()
        self.assertEqual(obj.Placement, placement)

    def test_wall_agrees_with_steiner(self):
        """The wall between -d and d has the volume 2 A d + (2/3) d^3 times the total curvature."""
        walls = []
        for distance in (1, 2, 3):
            wall = make_ruled_offset(*self.lines(), distance, Sides="Both sides", Output="Solid")
            self.assert_valid(wall)
            self.assertEqual(wall.Shape.ShapeType, "Solid")
            walls.append(volume(wall) / distance)
        # An even quadratic: equal steps of d^2 make equal steps of V / d.
        v1, v2, v3 = walls
        self.assertGreater(v1, 0)
        self.assertAlmostEqual(((v2 - v1) / 3) / ((v3 - v2) / 5), 1, delta=1e-6)

    def test_results_are_shown(self):
        obj = make_ruled_offset(*self.curves(), 1)
        self.assertRegex(obj.Degree, "^[0-9]+ x [0-9]+$")
        self.assertGreater(obj.Poles, 0)
        self.assertTrue(obj.Exact)
        self.assertLess(obj.DeviationBound, 1e-10)
        self.assertRegex(obj.TrimDeviation, "^[0-9.e-]+ mm$")
        for name in ("Degree", "TrimDeviation", "Status"):
            self.assertEqual(obj.getEditorMode(name), ["ReadOnly"])


class Errors(Recovery, RuledOffsetTest):
    def setUp(self):
        super().setUp()
        self.first, self.last = self.lines()
        self.remember(make_ruled_offset(self.first, self.last, 1))

    def link(self, source):
        self.obj.CurveB = (source, [])

    def test_curve_deleted(self):
        self.document.removeObject(self.last.Name)
        self.assert_fails_and_recovers(
            "A curve is missing.", lambda: self.link(self.shape_object(polyline(*SKEW[1])))
        )

    def test_curve_that_is_none(self):
        self.last.Shape = Part.Vertex(0, 0, 0)
        self.assert_fails_and_recovers("has no edge", self.repair)

    def test_curve_without_length(self):
        start = Part.BSplineCurve()
        start.buildFromPolesMultsKnots(
            [Vector(0, 20, 0), Vector(0, 20, 0), Vector(30, 20, 15)], [2, 1, 2], [0, 1, 2], False, 1
        )
        self.last.Shape = start.toShape()
        self.assert_fails_and_recovers("stands still", self.repair)

    def test_identical_curves(self):
        self.link(self.first)
        self.assert_fails_and_recovers("same", lambda: self.link(self.last))

    def test_curves_that_meet(self):
        self.last.Shape = polyline(SKEW[0][0], (30, 20, 15))
        self.assert_fails_and_recovers("meet", self.repair)

    def test_gap(self):
        lines = polyline((0, 20, 0), (5, 20, 0)), polyline((5, 21, 0), (9, 9, 9))
        self.last.Shape = Part.Compound(list(lines))
        self.assert_fails_and_recovers("a gap of 1 mm", self.repair)

    def test_vanished_edge(self):
        self.obj.CurveB = (self.last, ["Edge9"])
        self.assert_fails_and_recovers("Line001 has no Edge9 any more.", lambda: self.link(self.last))

    def test_developable_face(self):
        sheet = spline().toShape().extrude(Vector(0, 0, 30))
        self.obj.Face = (self.shape_object(sheet, "Sheet"), ["Face1"])
        self.assert_fails_and_recovers("developable", lambda: setattr(self.obj, "Face", None))

    def test_faces_that_are_for_another_command(self):
        for shape in (Part.makeCylinder(5, 10), Part.makeCone(5, 2, 10)):
            with self.subTest(shape.Faces[0].Surface.TypeId):
                self.obj.Face = (self.shape_object(shape, "Round"), ["Face1"])
                self.assert_fails_and_recovers(
                    "The command Quadric Offset makes", lambda: setattr(self.obj, "Face", None)
                )

    def test_circles_of_one_axis(self):
        """Those of a cylinder or cone are refused; turned against each other they are skew."""
        lower, upper = Part.makeCircle(10), Part.makeCircle(6, Vector(0, 0, 20))
        self.first.Shape, self.last.Shape = lower, upper

        def repair():
            self.first.Shape = polyline(*SKEW[0])
            self.repair()

        self.assert_fails_and_recovers("Both circles have one axis", repair)
        upper.rotate(Vector(), Vector(0, 0, 1), 40)
        self.first.Shape, self.last.Shape = lower, upper
        self.document.recompute()
        self.assertNotIn("one axis", self.obj.Status)

    def test_a_wall_without_thickness(self):
        self.obj.Sides, self.obj.Output, self.obj.Distance = "Both sides", "Solid", 0

        def repair():
            self.obj.Sides, self.obj.Output, self.obj.Distance = "Offset", "Surface", 1

        self.assert_fails_and_recovers("The wall would be 0 mm thick.", repair)

    def test_ends_that_are_not_flat(self):
        self.obj.Output = "Solid"
        self.assert_fails_and_recovers(
            "it leaves its plane by up to", lambda: setattr(self.obj, "Output", "Surface")
        )

    def test_edges_that_branch(self):
        self.last.Shape = Part.makeBox(1, 1, 1)
        self.assert_fails_and_recovers("branch", self.repair)

    def test_distances_that_are_none(self):
        for distance in (math.nan, math.inf):
            with self.subTest(distance):
                self.obj.Distance = distance
                self.assert_fails_and_recovers(
                    "not a finite number", lambda: setattr(self.obj, "Distance", 1)
                )

    def test_face_that_is_not_ruled(self):
        ball = self.shape_object(Part.makeSphere(5), "Ball")
        self.obj.Face = (ball, ["Face1"])
        self.assert_fails_and_recovers("not ruled", lambda: setattr(self.obj, "Face", None))

    def test_too_many_faces(self):
        box = self.shape_object(Part.makeBox(1, 1, 1), "Box")
        self.obj.Face = (box, [])
        self.assert_fails_and_recovers(
            "Box gives 6 faces. Choose one face.", lambda: setattr(self.obj, "Face", None)
        )

    def test_nothing_is_left_of_a_wrong_call(self):
        before = self.document.Objects
        with self.assertRaises(AttributeError):
            make_ruled_offset(self.first, self.last, 1, Colour="red")
        self.assertEqual(self.document.Objects, before)

    def repair(self):
        self.last.Shape = polyline(*SKEW[1])


def _poles(face):
    return [[tuple(pole) for pole in row] for row in face.Surface.getPoles()]
