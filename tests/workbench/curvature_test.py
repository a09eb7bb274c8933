# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvatures against closed forms and OpenCASCADE's."""

import math

import numpy as np
import Part
from FreeCAD import Vector
from support import RADII, DocumentTest

from pnsurfaces import make_canal_surface, make_quadric_offset
from pnsurfaces.curvature import combs, curved_patches, smallest_radius
from pnsurfaces.face_grid import face_grid, lines


def curved(shape, rows=32, columns=64):
    return [patch for face in shape.Faces for patch in curved_patches(face_grid(face), rows, columns)]


class Curvatures(DocumentTest):
    def test_sphere(self):
        ball = make_quadric_offset("Ellipsoid", 8, 8, 8, 2)
        for patch in curved(ball.Shape):
            np.testing.assert_allclose(patch.strongest(), 0.1, rtol=1e-4)
            np.testing.assert_allclose(patch.gauss(), 0.01, rtol=1e-4)
            # Bent away from the normal, which is outwards.
            self.assertLess(patch.greatest.max(), 0)

    def test_torus(self):
        circle = Part.Circle(Vector(), Vector(0, 0, 1), 20).toShape()
        torus = make_canal_surface(self.shape_object(circle, "Circle"), 3, 1)
        for patch in curved(torus.Shape):
            cosine = (np.hypot(patch.points[..., 0], patch.points[..., 1]) - 20) / 4
            gauss = cosine / (4 * (20 + 4 * cosine))
            np.testing.assert_allclose(patch.gauss(), gauss, rtol=0, atol=1e-12)
            np.testing.assert_allclose(patch.strongest(), 1 / 4, rtol=1e-9)

    def test_against_opencascade(self):
        horn = make_canal_surface(self.spline_object(), ("Values at vertices", RADII), 0.3)
        face = horn.Shape.Faces[0]
        (patch,) = curved(horn.Shape)
        u, v = patch.patch
        for i in range(1, len(u) - 1, 7):
            for k in range(1, len(v) - 1, 7):
                if u[i] in face.Surface.getUKnots() or v[k] in face.Surface.getVKnots():
                    continue
                expected = face.curvatureAt(u[i], v[k])
                found = patch.least[i, k], patch.greatest[i, k]
                np.testing.assert_allclose(
                    np.sort(np.abs(found)), np.sort(np.abs(expected)), rtol=1e-7, atol=1e-9
                )

    def test_normals_are_on_the_side_of_the_face(self):
        ball = make_quadric_offset("Ellipsoid", 8, 8, 8)
        for face, sign in ((ball.Shape.Faces[0], 1), (ball.Shape.Faces[0].reversed(), -1)):
            for patch in curved_patches(face_grid(face), 9, 9):
                np.testing.assert_allclose(patch.normals, sign * patch.points / 8, atol=5e-3)


class SmallestRadius(DocumentTest):
    def test_end_of_the_long_axis(self):
        for a, b, c, d in ((30, 20, 10, 2), (17, 16, 15, -3)):
            egg = make_quadric_offset("Ellipsoid", a, b, c, d)
            found = smallest_radius(curved(egg.Shape))
            self.assertAlmostEqual(found.radius, c * c / a + d, delta=1e-6)
            np.testing.assert_allclose(np.abs(found.point), (a + d, 0, 0), atol=1e-2)

    def test_neck_of_a_saddle(self):
        saddle = make_quadric_offset(
            "Hyperbolic paraboloid", 30, 20, 10, bounds={"x": (-3, 6), "y": (-5, 5)}
        )
        found = smallest_radius(curved(saddle.Shape))
        self.assertAlmostEqual(found.radius, 20, delta=1e-4)

    def test_none_is_smaller(self):
        horn = make_canal_surface(self.spline_object(), ("Values at vertices", RADII), 0.3)
        found = smallest_radius(curved(horn.Shape))
        face = horn.Shape.Faces[0]
        u_first, u_last, v_first, v_last = face.ParameterRange
        for i in range(1, 40):
            for k in range(1, 40):
                u = u_first + (u_last - u_first) * i / 40
                v = v_first + (v_last - v_first) * k / 40
                strongest = max(map(abs, face.curvatureAt(u, v)))
                self.assertLessEqual(found.radius, 1 / strongest + 1e-9)

    def test_flat(self):
        rectangle = Part.makePlane(3, 4).toNurbs()
        self.assertEqual(smallest_radius(curved(rectangle)).radius, math.inf)


class Combs(DocumentTest):
    def test_of_a_cylinder(self):
        grid = face_grid(make_canal_surface(self.line_object(10), 2).Shape.Faces[0])
        for axis, expected in ((0, -0.5), (1, 0.0)):
            for points, normals, curvature in combs(grid, lines(grid, axis, 3, 17)):
                np.testing.assert_allclose(curvature, expected, rtol=0, atol=1e-11)
                np.testing.assert_allclose(normals[:, :2], points[:, :2] / 2, atol=1e-11)
