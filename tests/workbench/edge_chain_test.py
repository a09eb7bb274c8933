# SPDX-License-Identifier: LGPL-2.1-or-later
"""What becomes of edges, wires and sketches: chains of curves, exactly."""

import math

import Part
from FreeCAD import Placement, Rotation, Vector
from support import KNOTS, MULTIPLICITIES, POLES, DocumentTest, polyline, spline

from pnsurfaces.edge_chain import ChainError, read_edge_chain
from pnsurfaces.linked_shape import LinkError

WEIGHTS = [1.0, 2.0, 0.5, 1.5, 3.0, 1.0, 0.75]


def _bspline(degree, knots, multiplicities, poles, weights=None):
    curve = Part.BSplineCurve()
    poles = [Vector(*pole) for pole in poles]
    arguments = [poles, multiplicities, knots, False, degree]
    curve.buildFromPolesMultsKnots(*arguments, *([weights] if weights else []))
    return [curve]


class EdgeChainTest(DocumentTest):
    def chain_of(self, *shapes):
        source = self.shape_object(Part.Compound(list(shapes)))
        return read_edge_chain(source, [])

    def assert_chain(self, curves, *points):
        """The curves run through the points, and join bit for bit."""
        self.assertEqual(len(curves), len(points) - 1)
        for before, after in zip(curves, curves[1:]):
            self.assertEqual(tuple(_end(before)), tuple(_start(after)))
        joints = [_start(curves[0]), *[_end(curve) for curve in curves]]
        for joint, point in zip(joints, points):
            self.assertLess((joint - Vector(*point)).Length, 1e-7)


def _start(curve):
    return curve.getPole(1)


def _end(curve):
    return curve.getPole(curve.NbPoles)


class OneEdge(EdgeChainTest):
    def test_bspline_keeps_every_double(self):
        original = _bspline(3, KNOTS, MULTIPLICITIES, POLES, WEIGHTS)[0]
        (curve,) = self.chain_of(original.toShape()).curves
        self.assertEqual([tuple(p) for p in curve.getPoles()], POLES)
        self.assertEqual(curve.getWeights(), WEIGHTS)
        self.assertEqual(curve.getKnots(), KNOTS)
        self.assertEqual(curve.getMultiplicities(), MULTIPLICITIES)

    def test_bezier_keeps_every_double(self):
        bezier = Part.BezierCurve()
        bezier.setPoles([Vector(*pole) for pole in POLES])
        (curve,) = self.chain_of(bezier.toShape()).curves
        self.assertEqual([tuple(p) for p in curve.getPoles()], POLES)
        self.assertEqual(curve.getKnots(), [0.0, 1.0])

    def test_trimmed_curves_end_where_the_edge_ends(self):
        bezier = Part.BezierCurve()
        bezier.setPoles([Vector(*pole) for pole in POLES])
        for original in (spline(), bezier):
            edge = original.toShape(0.3, 0.9)
            (curve,) = self.chain_of(edge).curves
            for i in range(21):
                share = i / 20
                parameter = curve.FirstParameter * (1 - share) + curve.LastParameter * share
                gap = curve.value(parameter) - original.value(0.3 + 0.6 * share)
                self.assertLess(gap.Length, 1e-13)

    def test_reversed_edge_runs_backwards(self):
        edge = spline().toShape(0.3, 0.9)
        edge.reverse()
        (curve,) = self.chain_of(edge).curves
        self.assertLess((_start(curve) - spline().value(0.9)).Length, 1e-13)
        self.assertLess((_end(curve) - spline().value(0.3)).Length, 1e-13)

    def test_conics_satisfy_their_equations(self):
        circle = Part.Circle(Vector(), Vector(0, 0, 1), 5)
        ellipse = Part.Ellipse(Vector(), 5, 3)
        hyperbola = Part.Hyperbola(Vector(), 5, 3)
        for conic, first, last, residual in (
            (circle, 0.1, 2.0, lambda p: p.Length / 5 - 1),
            (circle, 0.0, 2 * math.pi, lambda p: p.Length / 5 - 1),
            (circle, 5.0, 8.0, lambda p: p.Length / 5 - 1),
            (ellipse, 1.0, 4.0, lambda p: (p.x / 5) ** 2 + (p.y / 3) ** 2 - 1),
            (hyperbola, -1.0, 1.5, lambda p: (p.x / 5) ** 2 - (p.y / 3) ** 2 - 1),
        ):
            (curve,) = self.chain_of(conic.toShape(first, last)).curves
            for i in range(50):
                parameter = first + (last - first) * i / 49
                self.assertLess(abs(residual(curve.value(parameter))), 1e-14)
            self.assertLess((_start(curve) - conic.value(first)).Length, 1e-13)
            self.assertLess((_end(curve) - conic.value(last)).Length, 1e-13)

    def test_circle_is_closed_and_arc_is_not(self):
        circle = Part.Circle(Vector(), Vector(0, 0, 1), 5)
        chain = self.chain_of(circle.toShape())
        self.assertTrue(chain.closed)
        self.assertEqual(tuple(_start(chain.curves[0])), tuple(_end(chain.curves[-1])))
        self.assertFalse(self.chain_of(circle.toShape(0, 3)).closed)

    def test_periodic_spline_becomes_clamped(self):
        periodic = Part.BSplineCurve()
        periodic.interpolate([Vector(*pole) for pole in POLES], PeriodicFlag=True)
        chain = self.chain_of(periodic.toShape())
        (curve,) = chain.curves
        self.assertTrue(chain.closed)
        self.assertFalse(curve.isPeriodic())
        self.assertEqual(tuple(_start(curve)), tuple(_end(curve)))
        for i in range(50):
            parameter = periodic.LastParameter * i / 50
            self.assertLess((curve.value(parameter) - periodic.value(parameter)).Length, 1e-13)

    def test_poles_of_a_sphere_are_no_edges(self):
        (curve,) = self.chain_of(Part.makeSphere(5)).curves
        self.assertAlmostEqual((_end(curve) - _start(curve)).Length, 10, delta=1e-13)

    def test_curve_without_rational_form_is_refused(self):
        offset = Part.OffsetCurve(Part.Ellipse(Vector(), 5, 3), 0.5, Vector(0, 0, 1))
        with self.assertRaisesRegex(ChainError, "exact"):
            self.chain_of(offset.toShape())


class ManyEdges(EdgeChainTest):
    def test_edges_in_any_order_and_direction(self):
        a, b, c, d = (0, 0, 0), (10, 0, 0), (10, 20, 0), (10, 20, 30)
        chain = self.chain_of(polyline(a, b), polyline(d, c), polyline(c, b))
        self.assert_chain(chain.curves, a, b, c, d)
        self.assertFalse(chain.closed)

    def test_parameter_is_the_length_of_the_edges(self):
        arc = Part.Arc(Vector(10, 0, 0), Vector(20, 10, 0), Vector(10, 20, 0)).toShape()
        line = polyline((0, 0, 0), (10, 0, 0))
        ranges = [c.LastParameter - c.FirstParameter for c in self.chain_of(line, arc).curves]
        self.assertAlmostEqual(ranges[0], 10, places=9)
        self.assertAlmostEqual(ranges[1], 10 * math.pi, places=9)

    def test_closed_wire(self):
        points = (0, 0, 0), (10, 0, 0), (10, 20, 0), (0, 0, 0)
        chain = self.chain_of(polyline(*points))
        self.assert_chain(chain.curves, *points)
        self.assertTrue(chain.closed)
        self.assertEqual(tuple(_start(chain.curves[0])), tuple(_end(chain.curves[-1])))

    def test_closed_wire_with_a_small_gap(self):
        a, b, c, nearly_a = (0, 0, 0), (10, 0, 0), (10, 20, 0), (0, 0, 5e-8)
        chain = self.chain_of(polyline(a, b), polyline(b, c), polyline(c, nearly_a))
        self.assertTrue(chain.closed)
        self.assertEqual(tuple(_start(chain.curves[0])), tuple(_end(chain.curves[-1])))

    def test_small_gap_is_closed_and_large_gap_is_named(self):
        line = polyline((0, 0, 0), (10, 0, 0))
        chain = self.chain_of(line, polyline((10, 5e-8, 0), (10, 20, 0)))
        self.assert_chain(chain.curves, (0, 0, 0), (10, 0, 0), (10, 20, 0))
        with self.assertRaisesRegex(ChainError, "a gap of 0.025 mm"):
            self.chain_of(line, polyline((10, 0.025, 0), (10, 20, 0)))

    def test_branches_are_refused(self):
        with self.assertRaisesRegex(ChainError, "branch"):
            self.chain_of(
                polyline((0, 0, 0), (10, 0, 0)),
                polyline((10, 0, 0), (20, 5, 0)),
                polyline((10, 0, 0), (20, -5, 0)),
            )

    def test_sketch(self):
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(Part.LineSegment(Vector(0, 0, 0), Vector(10, 0, 0)))
        arc = Part.Circle(Vector(10, 5, 0), Vector(0, 0, 1), 5)
        sketch.addGeometry(Part.ArcOfCircle(arc, -math.pi / 2, 0))
        sketch.Placement = Placement(Vector(0, 0, 7), Rotation())
        self.document.recompute()
        curves = read_edge_chain(sketch, []).curves
        if tuple(_start(curves[0])) != (0, 0, 7):
            self.assert_chain(curves, (15, 5, 7), (10, 0, 7), (0, 0, 7))
        else:
            self.assert_chain(curves, (0, 0, 7), (10, 0, 7), (15, 5, 7))


class Sources(EdgeChainTest):
    def test_chosen_edges_only(self):
        source = self.shape_object(polyline((0, 0, 0), (10, 0, 0), (10, 20, 0), (10, 20, 30)))
        curves = read_edge_chain(source, ["Edge2", "Edge3"]).curves
        self.assert_chain(curves, (10, 0, 0), (10, 20, 0), (10, 20, 30))

    def test_vanished_edge_is_named(self):
        source = self.shape_object(polyline((0, 0, 0), (10, 0, 0)))
        with self.assertRaisesRegex(LinkError, "Edge7"):
            read_edge_chain(source, ["Edge7"])

    def test_source_without_edges(self):
        point = self.shape_object(Part.Vertex(1, 2, 3))
        empty = self.document.addObject("Part::Feature", "Empty")
        for source in (point, empty):
            with self.assertRaisesRegex(ChainError, "no edge"):
                read_edge_chain(source, [])

    def test_placement_of_the_source(self):
        source = self.spline_object()
        source.Placement = Placement(Vector(1, 2, 3), Rotation(10, 20, 30))
        (curve,) = read_edge_chain(source, []).curves
        for pole, original in zip(curve.getPoles(), POLES):
            self.assertLess((pole - source.Placement.multVec(Vector(*original))).Length, 1e-13)

    def test_coordinates_are_those_of_the_container(self):
        part = self.document.addObject("App::Part", "Part")
        part.Placement = Placement(Vector(100, 0, 0), Rotation(Vector(0, 0, 1), 90))
        source = self.spline_object()
        part.addObject(source)
        (inside,) = read_edge_chain(source, [], container=part).curves
        self.assertEqual([tuple(p) for p in inside.getPoles()], POLES)
        other = self.document.addObject("App::Part", "Other")
        other.Placement = Placement(Vector(0, 50, 0), Rotation(Vector(1, 0, 0), 30))
        for container, frame in ((None, Placement()), (other, other.Placement)):
            (outside,) = read_edge_chain(source, [], container).curves
            for pole, original in zip(outside.getPoles(), POLES):
                expected = part.Placement.multVec(Vector(*original))
                self.assertLess((frame.multVec(pole) - expected).Length, 1e-13)


class Reversal(EdgeChainTest):
    def test_the_chain_runs_back_through_the_same_points(self):
        a, b, c = (0, 0, 0), (10, 0, 0), (10, 20, 0)
        arc = Part.Arc(Vector(*c), Vector(15, 25, 0), Vector(10, 30, 0)).toShape()
        chain = self.chain_of(polyline(a, b, c), arc)
        back = chain.reversed()
        self.assert_chain(back.curves, (10, 30, 0), c, b, a)
        self.assert_chain(chain.curves, a, b, c, (10, 30, 0))
        for curve, same in zip(chain.curves, reversed(back.curves)):
            first, last = curve.FirstParameter, curve.LastParameter
            for i in range(11):
                t = first + (last - first) * i / 10
                self.assertLess((same.value(first + last - t) - curve.value(t)).Length, 1e-13)
