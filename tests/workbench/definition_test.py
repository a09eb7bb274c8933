# SPDX-License-Identifier: LGPL-2.1-or-later
"""The comparison with the definition of a surface: it is met, and it sees what is planted."""

import itertools
import math

import numpy as np
import Part
from FreeCAD import Placement, Rotation, Vector
from support import RADII, DocumentTest, polyline, samples

from pnsurfaces import make_canal_surface, make_quadric_offset, make_ruled_offset
from pnsurfaces.definition import definition_of

# In mm; the surfaces are some 10 mm to 100 mm in size.
ROUNDING = 5e-13


class Definitions(DocumentTest):
    def assert_met(self, obj):
        self.assertTrue(obj.isValid(), obj.getStatusString())
        points, normals = samples(obj)
        self.assertGreater(len(points), 100)
        definition, distance = definition_of(obj), obj.Distance.Value
        self.assertLess(definition.deviations(points, normals, distance).max(), ROUNDING)
        # What is off by a little along the normal is seen, and by how much.
        for error in (1e-3, -1e-7, 1e-10):
            found = definition.deviations(points + error * normals, normals, distance)
            np.testing.assert_allclose(found, abs(error), rtol=0, atol=ROUNDING + abs(error) / 1e3)

    def test_canal_surfaces(self):
        spine = self.spline_object()
        for radius, distance, lines in (
            (2, 0, "Even"),
            ((2, 3.5), 0.25, "Even"),
            (("Values at vertices", RADII), -0.5, "Even"),
            ((3, 2), 0.5, "Lowest degree"),
        ):
            self.assert_met(make_canal_surface(spine, radius, distance, ParameterLines=lines))

    def test_a_straight_and_a_round_pipe(self):
        self.assert_met(make_canal_surface(self.line_object(), 2, 0.5))
        circle = Part.Circle(Vector(3, 4, 5), Vector(1, 2, 3), 20).toShape()
        self.assert_met(make_canal_surface(self.shape_object(circle), 3, -1))

    def test_corners_have_zones_of_spheres(self):
        bent = polyline((0, 0, 0), (30, 0, 0), (30, 30, 0), (30, 30, 40))
        pipe = make_canal_surface(self.shape_object(bent), 4, 0.5)
        self.assertEqual(len(pipe.Shape.Faces), 5)
        points, normals = samples(pipe)
        self.assertLess(definition_of(pipe).deviations(points, normals, 0.5).max(), ROUNDING)

    def test_beyond_a_singular_point(self):
        circle = Part.Circle(Vector(), Vector(0, 0, 1), 5).toShape()
        pipe = make_canal_surface(self.shape_object(circle), 3, 4)
        self.assertIn("singular", pipe.Status)
        points, normals = samples(pipe)
        self.assertLess(definition_of(pipe).deviations(points, normals, 4).max(), ROUNDING)

    def test_ruled_surfaces(self):
        low = Part.makeLine(Vector(0, 0, 0), Vector(40, 0, 0))
        high = Part.makeLine(Vector(0, 30, 0), Vector(40, 40, 30))
        self.assert_met(make_ruled_offset(self.shape_object(low), self.shape_object(high), 1))
        spline = self.spline_object()
        shifted = spline.Shape.copy()
        shifted.Placement = Placement(Vector(0, 5, 30), Rotation(Vector(1, 0, 0), 20))
        pair = spline, self.shape_object(shifted)
        self.assert_met(make_ruled_offset(*pair, 0))
        self.assert_met(make_ruled_offset(*pair, -0.7))

    def test_quadrics(self):
        regions = {
            "Ellipsoid": None,
            "One-sheet hyperboloid": {"z": (-3, 6)},
            "Two-sheet hyperboloid": {"z": (0, 14)},
            "Elliptic paraboloid": {"z": (0, 9)},
            "Hyperbolic paraboloid": {"x": (-3, 6), "y": (-5, 5)},
            "Parabolic cylinder": {"x": (-3, 6), "y": (-5, 5)},
        }
        for (kind, bounds), distance in itertools.product(regions.items(), (0.5, -0.5)):
            self.assert_met(make_quadric_offset(kind, 30, 20, 10, distance, bounds=bounds))
        for kind in ("Cylinder", "Cone"):
            self.assert_met(make_quadric_offset(kind, 10, 10, 20, 1, bounds={"z": (2, 20)}))

    def test_a_moved_quadric_of_a_face(self):
        ball = self.document.addObject("Part::Sphere", "Ball")
        ball.Placement = Placement(Vector(7, 8, 9), Rotation(Vector(1, 2, 3), 50))
        self.document.recompute()
        self.assert_met(make_quadric_offset((ball, "Face1"), distance=2))

    def test_another_surface_is_off(self):
        spine = self.spline_object()
        pipe, cone = make_canal_surface(spine, 2), make_canal_surface(spine, (2, 2.001))
        points, normals = samples(cone)
        deviations = definition_of(pipe).deviations(points, normals, 0)
        self.assertAlmostEqual(deviations.max(), 1e-3, delta=1e-5)
        self.assertLess(deviations.min(), 1e-10)

    def test_a_point_far_away_has_its_distance(self):
        pipe = make_canal_surface(self.line_object(10), 2)
        point = np.array([[5.0, 0, 3]])
        found = definition_of(pipe).deviations(point, point / math.sqrt(34), 0)
        np.testing.assert_allclose(found, 3, rtol=1e-12)
        # Beyond the end it is the distance from the last sphere.
        beyond = np.array([[3.0, 0, 14]])
        self.assertAlmostEqual(definition_of(pipe).deviations(beyond, beyond, 0)[0], 3)

    def test_other_objects_have_none(self):
        self.assertIsNone(definition_of(self.line_object()))
