# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two curves that are read from ruled faces, against the faces themselves."""

import math

import Part
from FreeCAD import Placement, Rotation, Vector
from support import DocumentTest, polyline, spline

from pnsurfaces.ruled_face import NotRuled, read_ruled_face


class RuledFaceTest(DocumentTest):
    def assert_rulings(self, face):
        """Points between the curves lie on the face, and the curves run along all of its sides."""
        curves = [chain.curves[0] for chain in read_ruled_face(face)]
        first, last = curves[0].FirstParameter, curves[0].LastParameter
        self.assertEqual((curves[1].FirstParameter, curves[1].LastParameter), (first, last))
        for i in range(8):
            t = first + (last - first) * i / 7
            a, b = (curve.value(t) for curve in curves)
            for v in (0, 0.3, 1):
                distance, _, _ = face.distToShape(Part.Vertex(a + v * (b - a)))
                self.assertLess(distance, 1e-9)
        corners = [curve.value(t) for curve in curves for t in (first, last)]
        for vertex in face.Vertexes:
            self.assertLess(min((vertex.Point - corner).Length for corner in corners), 1e-9)


class Ruled(RuledFaceTest):
    def test_ruled_surface_of_two_curves_keeps_every_pole(self):
        other = spline()
        other.translate(Vector(0, 0, 20))
        face = Part.makeRuledSurface(spline().toShape(), other.toShape())
        first, last = read_ruled_face(face)
        self.assertEqual(first.curves[0].getPoles(), spline().getPoles())
        self.assertEqual(last.curves[0].getPoles(), other.getPoles())
        self.assert_rulings(face)

    def test_analytic_faces(self):
        arc = Part.Arc(Vector(5, 0, 0), Vector(0, 5, 0), Vector(-5, 0, 0)).toShape()
        for name, face in (
            ("plane", Part.makePlane(10, 5)),
            ("cylinder", Part.makeCylinder(5, 10).Faces[0]),
            ("quarter", Part.makeCylinder(5, 10, Vector(), Vector(0, 0, 1), 90).Faces[0]),
            ("cone", Part.makeCone(5, 2, 10).Faces[0]),
            ("extrusion", arc.extrude(Vector(1, 2, 8)).Faces[0]),
            ("extruded spline", spline().toShape().extrude(Vector(1, 2, 8)).Faces[0]),
        ):
            with self.subTest(name):
                placed = face.copy()
                placed.Placement = Placement(Vector(1, 2, 3), Rotation(10, 20, 30))
                self.assert_rulings(placed.Faces[0])

    def test_bezier_face(self):
        surface = Part.BezierSurface()
        surface.increase(2, 1)
        for i in range(3):
            for j in range(2):
                surface.setPole(i + 1, j + 1, Vector(10 * i, 8 * j, i * i - 3 * j))
        self.assert_rulings(surface.toShape())

    def test_closed_curves_end_where_they_start(self):
        for chain in read_ruled_face(Part.makeCylinder(5, 10).Faces[0]):
            self.assertTrue(chain.closed)
            (curve,) = chain.curves
            self.assertEqual(curve.getPole(1), curve.getPole(curve.NbPoles))
            ends = curve.getMultiplicities()[0], curve.getMultiplicities()[-1]
            self.assertEqual(ends, (curve.Degree + 1, curve.Degree + 1))
            for i in range(16):
                point = curve.value(2 * math.pi * i / 16)
                self.assertAlmostEqual(math.hypot(point.x, point.y), 5, delta=1e-14)


class NotRuledTest(RuledFaceTest):
    def assert_refused(self, face, sentence):
        with self.assertRaisesRegex(NotRuled, sentence) as caught:
            read_ruled_face(face)
        self.assertEqual(caught.exception.code, "not_ruled")
        self.assertRegex(str(caught.exception), r"^[A-Z][^\n]*[.]$")

    def test_faces_that_are_curved_in_both_directions(self):
        for shape in (Part.makeSphere(5), Part.makeTorus(10, 2)):
            self.assert_refused(shape.Faces[0], "curved in both directions")

    def test_faces_that_end_elsewhere(self):
        cylinder = Part.makeCylinder(5, 20)
        slanted = cylinder.cut(Part.makeBox(40, 40, 40, Vector(-20, -20, 12), Vector(0.3, 0, 1)))
        face = next(f for f in slanted.Faces if isinstance(f.Surface, Part.Cylinder))
        triangle = Part.Face(polyline((0, 0, 0), (5, 0, 0), (0, 5, 0), (0, 0, 0)))
        for cut in (face, triangle):
            self.assert_refused(cut, "ends along other lines")
