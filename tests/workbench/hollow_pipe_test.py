# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hollow pipes by a wall thickness or an inner radius: volumes, and what is refused."""

import math

import Part
from FreeCAD import Vector
from support import RADII, DocumentTest, shape_data, volume

from pnsurfaces import make_canal_surface

SOLID = {"Output": "Solid"}


class HollowPipe(DocumentTest):
    def assert_hollow(self, obj, expected, shells=1):
        self.assert_valid(obj)
        self.assertEqual(obj.Shape.ShapeType, "Solid")
        self.assertEqual(len(obj.Shape.Shells), shells)
        self.assertAlmostEqual(volume(obj) / expected, 1, delta=1e-9)

    def test_a_cylinder(self):
        line = self.line_object(10)
        expected = math.pi * (3**2 - 2**2) * 10
        wall = make_canal_surface(line, 3, Hollow="Wall thickness", WallThickness=1, **SOLID)
        self.assert_hollow(wall, expected)
        bore = make_canal_surface(line, 3, Hollow="Inner radius", InnerRadius=2, **SOLID)
        self.assert_hollow(bore, expected)

    def test_the_wall_is_measured_inwards_from_the_offset(self):
        obj = make_canal_surface(
            self.line_object(10), 3, 0.5, Hollow="Wall thickness", WallThickness=1, **SOLID
        )
        self.assert_hollow(obj, math.pi * (3.5**2 - 2.5**2) * 10)

    def test_a_wall_is_the_one_between_two_offsets(self):
        source = self.spline_object()
        law = ("Values at vertices", RADII)
        hollow = make_canal_surface(
            source, law, 0.25, Hollow="Wall thickness", WallThickness=0.5, **SOLID
        )
        sides = make_canal_surface(source, law, 0.25, Sides="Both sides", **SOLID)
        self.assertEqual(_numbers(hollow), _numbers(sides))

    def test_a_constant_bore_in_a_cone(self):
        """A frustum less a cylinder, and the rings of cones between their different ends."""
        obj = make_canal_surface(
            self.line_object(10), (4, 3), Hollow="Inner radius", InnerRadius=2, **SOLID
        )
        slope = -0.1
        shrink = math.sqrt(1 - slope**2)
        lower, upper = -slope * 4, 10 - slope * 3
        first, last = 4 * shrink, 3 * shrink
        outer = _frustum(upper - lower, first, last)
        # The bore runs from 0 to 10, its ends are joined to those of the cone.
        expected = outer + _frustum(lower, 2, first) - _frustum(upper - 10, 2, last)
        self.assert_hollow(obj, expected - math.pi * 2**2 * 10)

    def test_a_bore_under_another_law(self):
        for law in (("Values at vertices", RADII), ("Bezier coefficients", [3, 2, 4, 2, 3])):
            source = self.spline_object()
            obj = make_canal_surface(source, law, Hollow="Inner radius", InnerRadius=1, **SOLID)
            self.assert_valid(obj)
            outer = make_canal_surface(source, law, **SOLID)
            inner = make_canal_surface(source, 1, **SOLID)
            # The flat ends of both differ by thin rings.
            self.assertAlmostEqual(volume(obj) / (volume(outer) - volume(inner)), 1, delta=0.02)

    def test_a_torus(self):
        ring = self.shape_object(Part.Circle(Vector(), Vector(0, 0, 1), 20).toShape())
        expected = 2 * math.pi**2 * 20 * (3**2 - 2**2)
        for hollow in (
            {"Hollow": "Wall thickness", "WallThickness": 1},
            {"Hollow": "Inner radius", "InnerRadius": 2},
        ):
            self.assert_hollow(make_canal_surface(ring, 3, **hollow, **SOLID), expected, shells=2)

    def test_surfaces(self):
        obj = make_canal_surface(self.spline_object(), 3, Hollow="Inner radius", InnerRadius=2)
        self.assert_valid(obj)
        inner = make_canal_surface(obj.Spine[0], 2)
        outer = make_canal_surface(obj.Spine[0], 3)
        self.assertEqual(shape_data(obj.Shape), shape_data(inner.Shape) + shape_data(outer.Shape))

    def test_what_is_refused(self):
        line = self.line_object(100)
        for properties, sentence in (
            ({"Hollow": "Wall thickness", "WallThickness": 0}, "0 mm thick"),
            ({"Hollow": "Inner radius", "InnerRadius": 2.5}, "A bore of radius 2.5 mm leaves no"),
            ({"Hollow": "Inner radius", "Sides": "Both sides"}, "not Both sides"),
        ):
            obj = make_canal_surface(line, (2, 3), **properties)
            with self.subTest(sentence):
                self.assert_error(obj, sentence)

    def test_a_wall_thicker_than_the_pipe_warns(self):
        obj = make_canal_surface(self.line_object(), 2, Hollow="Wall thickness", WallThickness=3)
        self.assertIn("At -3 mm, beyond the limit of -2 mm", obj.Status)

    def test_only_its_own_property_is_shown(self):
        obj = make_canal_surface(self.line_object(), 2)
        for hollow, shown in (
            ("Wall thickness", {"WallThickness"}),
            ("Inner radius", {"InnerRadius"}),
            ("No", set()),
        ):
            obj.Hollow = hollow
            names = ("WallThickness", "InnerRadius")
            visible = {name for name in names if "Hidden" not in obj.getEditorMode(name)}
            self.assertEqual(visible, shown)


def _frustum(height, first, last):
    return math.pi * height * (first**2 + first * last + last**2) / 3


def _numbers(obj):
    faces = [f for f in obj.Shape.Faces if isinstance(f.Surface, Part.BSplineSurface)]
    return [[tuple(pole) for row in f.Surface.getPoles() for pole in row] for f in faces]
