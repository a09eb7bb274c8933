# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spines: speed through joints, places on them, curves without a rational form, touching."""

import math

import numpy as np
import Part
from FreeCAD import Placement, Rotation, Vector
from support import DocumentTest, polyline, spline

from pnsurfaces import make_canal_surface
from pnsurfaces.edge_chain import ChainError
from pnsurfaces.edge_fit import polynomial_where_possible
from pnsurfaces.spine import read_spine


class SpineTest(DocumentTest):
    def spine_of(self, *shapes):
        return read_spine(self.shape_object(Part.Compound(list(shapes))), [])

    def mixed_shapes(self):
        """A line, an arc and a spline that go on smoothly, and a line that turns off."""
        line = polyline((0, 0, 0), (10, 0, 0))
        arc = Part.Circle(Vector(10, 10, 0), Vector(0, 0, 1), 10).toShape(-math.pi / 2, 0)
        bezier = Part.BezierCurve()
        poles = (20, 10, 0), (20, 25, 0), (22, 30, 5), (30, 40, 8)
        bezier.setPoles([Vector(*pole) for pole in poles])
        return [line, arc, bezier.toShape(), polyline((30, 40, 8), (50, 40, 8))]


class Joints(SpineTest):
    def test_order_and_direction_do_not_matter(self):
        shapes = self.mixed_shapes()
        turned = [shape.reversed() for shape in (shapes[1], shapes[3])]
        for mixed in (shapes, [shapes[0], turned[1], shapes[2], turned[0]]):
            spine = self.spine_of(*mixed)
            self.assertAlmostEqual(spine.length, sum(shape.Length for shape in shapes), delta=1e-9)
            self.assertLess((spine.stretches[0].point(0) - Vector()).Length, 1e-12)
            last = spine.stretches[-1]
            self.assertLess((last.point(last.end) - Vector(50, 40, 8)).Length, 1e-12)

    def test_the_speed_goes_on_through_tangent_joints(self):
        spine = self.spine_of(*self.mixed_shapes())
        joints = list(zip(spine.stretches, spine.stretches[1:]))
        for before, after in joints[:-1]:
            self.assertEqual(before.end, after.begin)
            jump = after.velocity(after.begin) - before.velocity(before.end)
            self.assertLess(jump.Length, 1e-12)
        # After the corner the speed is 1 again.
        self.assertAlmostEqual(spine.stretches[-1].velocity(spine.curve.domain[1]).Length, 1)

    def test_a_linear_law_makes_no_crease_at_a_tangent_joint(self):
        source = self.shape_object(Part.Compound(self.mixed_shapes()[:3]))
        obj = make_canal_surface(source, (2, 3))
        self.assert_valid(obj)
        self.assertEqual((obj.Status, obj.Exact), ("Valid", True))

    def test_a_corner_has_its_zone(self):
        obj = make_canal_surface(self.shape_object(Part.Compound(self.mixed_shapes())), 1)
        self.assert_valid(obj)
        self.assertIn("(30, 40, 8)", obj.Status)

    def test_a_spline_in_a_chain_stays_one_face(self):
        curve = spline()
        first = Part.makeLine(curve.value(0) - curve.tangent(0)[0] * 10, curve.value(0))
        obj = make_canal_surface(self.shape_object(Part.Compound([first, curve.toShape()])), 1)
        self.assert_valid(obj)
        self.assertEqual(len(obj.Shape.Faces), 2)


class Places(SpineTest):
    def test_lengths_and_parameters_are_inverse(self):
        spine = self.spine_of(*self.mixed_shapes())
        for length in np.linspace(0, spine.length, 40):
            t = spine.parameter_at(length)
            self.assertAlmostEqual(spine.stretch_at(t).length_at(t), length, delta=1e-10)
        self.assertEqual(spine.parameter_at(0), spine.curve.domain[0])
        self.assertEqual(spine.parameter_at(spine.length), spine.curve.domain[1])

    def test_a_touching_spine_is_told(self):
        eight = polyline(
            (0, 0, 0), (10, 10, 0), (20, 0, 0), (20, 20, 0), (10, 10, 0), (0, 20, 0), (0, 0, 0)
        )
        spine = self.spine_of(eight)
        self.assertEqual(spine.notes, ("The spine touches itself at (10, 10, 0).",))
        obj = make_canal_surface(self.shape_object(eight), 1)
        self.assertIn("The spine touches itself at (10, 10, 0).", obj.Status)
        self.assertEqual(self.spine_of(*self.mixed_shapes()).notes, ())


class Fits(SpineTest):
    def test_a_helix_is_fitted_and_counted(self):
        source = self.shape_object(Part.makeHelix(10, 30, 20))
        for tolerance in (1e-3, 1e-7):
            obj = make_canal_surface(source, 3, FitTolerance=tolerance)
            self.assert_valid(obj)
            self.assertFalse(obj.Exact)
            self.assertRegex(obj.FitDeviation, "mm, proven$")
            self.assertLess(obj.DeviationBound, 1.1 * tolerance)
            self.assertGreater(obj.DeviationBound, 0.1 * tolerance)
            self.assertEqual(len(obj.Shape.Faces), 1)
            self.assert_distance_from_helix(obj, 3)

    def assert_distance_from_helix(self, obj, radius):
        """Every point of the surface is the radius away from its true sphere's centre."""
        face = obj.Shape.Faces[0]
        first, last = face.Surface.bounds()[:2]
        for share in np.linspace(0.02, 0.98, 50):
            angle = 6 * math.pi * share
            centre = Vector(20 * math.cos(angle), 20 * math.sin(angle), 30 * share)
            point = face.Surface.value(first + (last - first) * share, 0.7)
            self.assertAlmostEqual((point - centre).Length, radius, delta=obj.DeviationBound)

    def test_a_helix_in_a_moved_part_stays_a_helix(self):
        part = self.document.addObject("App::Part", "Part")
        part.Placement = Placement(Vector(100, 0, 0), Rotation(Vector(1, 0, 0), 30))
        source = self.shape_object(Part.makeHelix(10, 30, 20))
        part.addObject(source)
        obj = make_canal_surface(source, 3)
        self.assertRegex(obj.FitDeviation, "proven$")

    def test_the_turns_of_a_long_helix_go_on_smoothly(self):
        obj = make_canal_surface(self.shape_object(Part.makeLongHelix(10, 60, 20)), 3)
        self.assert_valid(obj)
        self.assertEqual(len(obj.Shape.Faces), 6)
        self.assertEqual(obj.Status.count("Fitted"), 1)
        self.assertNotIn("corner", obj.Status)

    def test_an_offset_curve_is_measured(self):
        ellipse = Part.Ellipse(Vector(), 50, 30)
        offset = Part.OffsetCurve(ellipse, 5, Vector(0, 0, 1)).toShape()
        for shape in (offset, offset.reversed()):
            obj = make_canal_surface(self.shape_object(shape), 3)
            self.assert_valid(obj)
            self.assertRegex(obj.FitDeviation, "mm, measured$")
            self.assertIn("OffsetCurve", obj.Status)

    def test_exact_edges_have_no_fit(self):
        spine = self.spine_of(*self.mixed_shapes())
        self.assertEqual(spine.fits, ())

    def test_conics_are_fitted_where_the_radius_is(self):
        for conic, proven in (
            (Part.Circle(Vector(1, 2, 3), Vector(1, 1, 1), 8), True),
            (Part.Ellipse(Vector(), 8, 3), False),
        ):
            for edge in (conic.toShape(0.5, 3), conic.toShape(0.5, 3).reversed()):
                source = self.shape_object(edge)
                spine = read_spine(source, [], curve_of=polynomial_where_possible(1e-7))
                (fit,) = spine.fits
                self.assertEqual(fit.proven, proven)
                self.assertFalse(spine.stretches[0].curve.isRational())
                for length in np.linspace(0, spine.length, 30):
                    point = spine.stretches[0].point(spine.parameter_at(length))
                    gap = edge.distToShape(Part.Vertex(point))[0]
                    self.assertLessEqual(gap, fit.deviation + 1e-12)


class Refusals(SpineTest):
    def test_an_edge_without_length_is_named(self):
        standing = Part.BSplineCurve()
        standing.buildFromPolesMultsKnots([Vector(1, 2, 3)] * 4, [4, 4], [0, 1], False, 3)
        with self.assertRaisesRegex(ChainError, r"near \(1, 2, 3\) has no length \(0 mm\)"):
            self.spine_of(standing.toShape())

    def test_a_branch_is_named(self):
        with self.assertRaisesRegex(ChainError, r"branch: 3 edges meet at \(10, 0, 0\)"):
            self.spine_of(
                polyline((0, 0, 0), (10, 0, 0)),
                polyline((10, 0, 0), (20, 5, 0)),
                polyline((10, 0, 0), (20, -5, 0)),
            )

    def test_a_gap_is_named_with_its_ends(self):
        with self.assertRaisesRegex(
            ChainError, r"a gap of 0.5 mm, from \(10, 0, 0\) to \(10, 0.5, 0\)"
        ):
            self.spine_of(polyline((0, 0, 0), (10, 0, 0)), polyline((10, 0.5, 0), (20, 5, 0)))
