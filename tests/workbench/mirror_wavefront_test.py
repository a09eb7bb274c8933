# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wavefronts of a mirror as a feature: light, mirrors, what is shown, and refusals."""

import math

import FreeCAD
import Part
from FreeCAD import Vector
from support import DocumentTest, Recovery

import pnsurfaces
from pnsurfaces.mirror_wavefront import facing_light


def dish(height=10.0, size=50.0):
    """z = height (x^2 + y^2) / size^2 over a square."""
    surface = Part.BezierSurface()
    surface.increase(2, 2)
    heights = (height, -height, height)
    for i in range(3):
        for j in range(3):
            pole = Vector(size * (i - 1), size * (j - 1), heights[i] + heights[j])
            surface.setPole(i + 1, j + 1, pole)
    return surface


# z = a (x^2 + y^2) has its focus at the height 1 / (4 a).
FOCUS = 50.0**2 / 4 / 10.0


class MirrorTest(DocumentTest):
    def make(self, *args, **properties):
        obj = pnsurfaces.make_mirror_wavefront(*args, **properties)
        self.assertTrue(obj.isValid(), obj.getStatusString())
        return obj

    def assert_certified(self, obj):
        """All samples lie where Huygens' spheres say."""
        (report,) = pnsurfaces.certificate([obj])["objects"]
        for section in report["sections"]:
            sampled = section["sampling"]
            self.assertLessEqual(sampled["worst"], section["deviation"] + sampled["rounding"])


class Wavefronts(MirrorTest):
    def setUp(self):
        super().setUp()
        self.mirror = self.face_object(dish().toShape(), "Mirror")

    def test_light_along_the_axis_becomes_a_sphere_around_the_focus(self):
        obj = self.make(self.mirror, 120, direction=(0, 0, -3), origin=(0, 0, 100))
        self.assertEqual(obj.Status, "Valid")
        self.assertTrue(obj.Exact)
        self.assert_valid(obj)
        self.assert_certified(obj)
        (face,) = obj.Shape.Faces
        # The vertex of the dish is at z = 0: the path to the focus is 100 + FOCUS.
        radius = 100 + FOCUS - 120
        for u, v in ((0, 0), (0.3, 0.7), (1, 0.5)):
            self.assertAlmostEqual(
                face.valueAt(u, v).distanceToPoint(Vector(0, 0, FOCUS)), radius, delta=1e-11
            )
        self.assertAlmostEqual(obj.MaxOffset.Value, 100 + FOCUS, delta=1e-3)
        self.assertLessEqual(obj.MaxOffset.Value, 100 + FOCUS)

    def test_beyond_the_focus_there_is_a_warning(self):
        obj = self.make(self.mirror, 200, direction=(0, 0.2, -1), origin=(0, 0, 100))
        self.assertIn("singular points", obj.Status)
        self.assert_certified(obj)

    def test_oblique_light(self):
        mirror = self.face_object(dish(height=3).toShape(), "Flat")
        obj = self.make(
            mirror,
            140,
            direction=(0.5, 0.25, -1),
            origin=(0, 0, 100),
            Sides="Two offsets",
            SecondDistance=150,
        )
        self.assertEqual(obj.Status, "Valid")
        self.assertEqual(len(obj.Shape.Shells), 2)
        self.assertTrue(obj.Exact)
        self.assert_certified(obj)

    def test_light_from_the_focus_becomes_plane(self):
        obj = self.make(self.mirror, 50, origin=(0, 0, FOCUS))
        self.assertEqual(obj.Status, "Valid")
        self.assert_certified(obj)
        box = obj.Shape.BoundBox
        self.assertLess(box.ZLength, 1e-10)
        self.assertAlmostEqual(box.ZMax, 50 - FOCUS, delta=1e-10)

    def test_light_from_elsewhere_has_one_rational_wavefront(self):
        obj = self.make(self.mirror, 0, origin=(10, 5, 90))
        self.assertIn("not rational", obj.Status)
        self.assert_certified(obj)
        obj.Distance = 1
        self.document.recompute()
        self.assert_error(obj, "The offsets of this surface are not rational")

    def test_the_mirror_is_followed(self):
        obj = self.make(self.mirror, 110, direction=(0, 0, -1), origin=(0, 0, 100))
        before = obj.Shape.BoundBox.ZMax
        self.mirror[0].Shape = dish(height=8).toShape()
        self.document.recompute()
        self.assertNotAlmostEqual(obj.Shape.BoundBox.ZMax, before, delta=0.1)

    def test_a_cylinder_is_taken_as_the_spline_that_it_becomes(self):
        quarter = Part.makeCylinder(50, 60, Vector(), Vector(0, 0, 1), 90).Faces[0]
        obj = self.make(self.face_object(quarter), 150, direction=(-1, -1, 0.3), origin=(100, 100, 0))
        self.assertFalse(obj.Exact)
        self.assertIn("spline that FreeCAD makes", obj.Status)
        self.assert_certified(obj)

    def test_a_trimmed_face_reflects_as_a_whole(self):
        hole = Part.makeCylinder(10, 60, Vector(0, 0, -30))
        trimmed = dish().toShape().cut(hole)
        obj = self.make(self.face_object(trimmed), 110, direction=(0, 0, -1), origin=(0, 0, 100))
        self.assertIn("trimmed", obj.Status)

    def test_suitable_light_is_reflected(self):
        for shape in (dish().toShape(), Part.makePlane(20, 30), Part.makeCylinder(5, 9)):
            direction, origin, distance = facing_light(shape.Faces[0])
            self.assertAlmostEqual(math.hypot(*direction), 1, delta=0.02)
            self.make(self.face_object(shape), distance, direction=direction, origin=origin)


class Refusals(Recovery, MirrorTest):
    def setUp(self):
        super().setUp()
        self.plane = self.face_object(Part.makePlane(30, 20), "Plane")
        self.remember(
            pnsurfaces.make_mirror_wavefront(self.plane, 50, direction=(0, 0, -1), origin=(0, 0, 30))
        )

    def restore(self):
        self.obj.Face = (self.plane[0], ["Face1"])
        self.obj.Light = "Parallel"
        self.obj.Direction = Vector(0, 0, -1)
        self.obj.Origin = Vector(0, 0, 30)

    def test_light_along_the_mirror(self):
        self.obj.Direction = Vector(1, 2, 0)
        self.assert_fails_and_recovers("runs along the mirror everywhere", self.restore)

    def test_no_direction(self):
        self.obj.Direction = Vector()
        self.assert_fails_and_recovers("The light has no direction.", self.restore)

    def test_a_source_on_the_mirror(self):
        self.obj.Light, self.obj.Origin = "From a point", Vector(10, 10, 0)
        self.assert_fails_and_recovers("lies on the mirror", self.restore)

    def test_a_plane_mirror_and_a_point(self):
        self.obj.Light = "From a point"
        self.assert_fails_and_recovers("spheres around the image", self.restore)

    def test_a_number_that_is_none(self):
        self.obj.Origin = Vector(0, 0, float("nan"))
        self.assert_fails_and_recovers("not a finite number", self.restore)

    def test_no_mirror(self):
        self.obj.Face = None
        self.assert_fails_and_recovers("Choose a face.", self.restore)

    def test_too_many_faces(self):
        self.obj.Face = (self.shape_object(Part.makeBox(1, 2, 3)), [])
        self.assert_fails_and_recovers("Choose one face.", self.restore)


class ListOfDocument(MirrorTest):
    def test_the_document_of_the_mirror_is_taken(self):
        mirror = self.face_object(dish().toShape())
        other = FreeCAD.newDocument()
        obj = self.make(mirror, 110, direction=(0, 0, -1), origin=(0, 0, 100))
        self.assertEqual(obj.Document, self.document)
        FreeCAD.closeDocument(other.Name)
