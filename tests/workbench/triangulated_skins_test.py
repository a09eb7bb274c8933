# SPDX-License-Identifier: LGPL-2.1-or-later
"""Skins over a triangulation as a feature: what is shown, slopes, and refusals."""

import FreeCAD
import numpy as np
from FreeCAD import Vector
from support import DocumentTest, Recovery

import pnsurfaces
from pnsurfaces import kernel
from pnsurfaces.slopes import estimated_slopes

# A dome over a square of four triangles around its middle.
POINTS = [(0, 0, 0), (100, 0, 1), (110, 90, 0), (0, 100, 2), (52, 48, 14)]
RADII = [5.0, 4.0, 5.0, 4.5, 2.0]
TRIANGLES = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]


class Skins(DocumentTest):
    def make(self, *args, **properties):
        obj = pnsurfaces.make_triangulated_skins(*args, document=self.document, **properties)
        self.assertTrue(obj.isValid(), obj.getStatusString())
        return obj

    def assert_certified(self, obj):
        """All samples lie where the spheres of the family say."""
        (report,) = pnsurfaces.certificate([obj])["objects"]
        self.assertEqual(report["shape"]["faults"], [])
        for section in report["sections"]:
            sampled = section["sampling"]
            self.assertLessEqual(sampled["worst"], section["deviation"] + sampled["rounding"])

    def test_both_skins_are_exact_shells(self):
        obj = self.make(POINTS, RADII, TRIANGLES)
        self.assertTrue(obj.Exact)
        self.assertEqual(len(obj.Shape.Shells), 2)
        self.assert_valid(obj)
        self.assert_certified(obj)
        self.assertEqual(obj.Status, "Valid")

    def test_offsets(self):
        self.assert_certified(self.make(POINTS, RADII, TRIANGLES, 0.5))
        self.assert_certified(self.make(POINTS, RADII, TRIANGLES, -0.5, Skins="Inner skin"))

    def test_a_shell_is_smooth(self):
        """The normals of both faces agree at the middle of every inner edge."""
        shape = self.make(POINTS, RADII, TRIANGLES, Skins="Outer skin").Shape
        (shell,) = shape.Shells
        inner = 0
        for edge in shell.Edges:
            faces = shell.ancestorsOfType(edge, type(shell.Faces[0]))
            if len(faces) != 2:
                continue
            inner += 1
            point = edge.valueAt((edge.FirstParameter + edge.LastParameter) / 2)
            normals = [face.normalAt(*face.Surface.parameter(point)) for face in faces]
            self.assertLess((normals[0] - normals[1]).Length, 1e-7)
        self.assertGreaterEqual(inner, 4 * 6 + 2 * 4)

    def test_given_slopes_are_taken(self):
        x, y = np.array(POINTS)[:, :2].T - [[52], [48]]
        slopes = np.array([[-x / 180, x / 1500], [-y / 200, y / 1300]]).transpose(2, 0, 1)
        self.assertTrue((slopes[4] == 0).all())
        obj = self.make(POINTS, RADII, TRIANGLES, slopes=slopes, Skins="Outer skin")
        # So the sphere in the middle touches at its top.
        top = FreeCAD.Vector(52, 48, 14 + 2)
        self.assertLess(min((v.Point - top).Length for v in obj.Shape.Vertexes), 1e-7)
        self.assert_certified(obj)

    def test_a_moved_centre_moves_the_skins(self):
        obj = self.make(POINTS, RADII, TRIANGLES)
        before = obj.Shape.BoundBox.ZMax
        obj.Centres = [*obj.Centres[:4], obj.Centres[4] + Vector(0, 0, 5)]
        self.document.recompute()
        self.assertGreater(obj.Shape.BoundBox.ZMax, before + 3)


class Slopes(DocumentTest):
    def test_what_is_quadratic_is_met(self):
        random = np.random.default_rng(1)
        places = np.array([(x, y) for x in range(4) for y in range(4)], dtype=float)
        places += random.uniform(-0.2, 0.2, places.shape)
        squares = [4 * i + j for i in range(3) for j in range(3)]
        triangles = [t for k in squares for t in ((k, k + 4, k + 5), (k, k + 5, k + 1))]
        x, y = places.T
        values = np.column_stack([3 + x - 2 * y + x * x - x * y, y * y + 0.5 * x])
        expected = np.stack(
            [np.column_stack([1 + 2 * x - y, 0.5 + 0 * x]), np.column_stack([-2 - x, 2 * y])], axis=1
        )
        found = estimated_slopes(places, values, triangles)
        self.assertLess(np.abs(found - expected).max(), 1e-12)

    def test_one_triangle_has_the_slope_of_its_plane(self):
        places = np.array([(0, 0), (2, 0), (0, 2)], dtype=float)
        found = estimated_slopes(places, np.array([[0.0], [0.0], [0.0]]), [(0, 1, 2)])
        self.assertTrue(np.array_equal(found, np.zeros((3, 2, 1))))


class Refusals(Recovery, DocumentTest):
    def setUp(self):
        super().setUp()
        self.remember(
            pnsurfaces.make_triangulated_skins(POINTS, RADII, TRIANGLES, document=self.document)
        )

    def restore(self):
        self.obj.Centres = [Vector(*point) for point in POINTS]
        self.obj.Radii = RADII
        self.obj.Triangles = np.ravel(TRIANGLES).tolist()
        self.obj.Slopes = []
        self.obj.Output = "Surface"

    def test_lists_that_do_not_fit(self):
        self.obj.Radii = RADII[:4]
        self.assert_fails_and_recovers("There are 5 centres, but 4 radii.", self.restore)
        self.obj.Triangles = [0, 1]
        self.assert_fails_and_recovers("Triangles have three points each", self.restore)
        self.obj.Triangles = [0, 1, 9]
        self.assert_fails_and_recovers("counted from 0 to 4", self.restore)
        self.obj.Slopes = [0.0] * 19
        self.assert_fails_and_recovers("The 5 points have 20 slopes", self.restore)

    def test_clockwise_triangles(self):
        self.obj.Triangles = np.ravel([t[::-1] for t in TRIANGLES]).tolist()
        self.assert_fails_and_recovers("Triangle 0 runs clockwise", self.restore)

    def test_radii_that_swallow(self):
        self.obj.Radii = [5.0, 4.0, 5.0, 4.5, 200.0]
        self.assert_fails_and_recovers("no envelope over triangle", self.restore)

    def test_a_radius_that_is_no_number(self):
        self.obj.Radii = [*RADII[:4], float("nan")]
        self.assert_fails_and_recovers("not a finite number", self.restore)

    def test_a_solid(self):
        self.obj.Output = "Solid"
        self.assert_fails_and_recovers("enclose no solid", self.restore)


class KernelOrder(DocumentTest):
    def test_skins_are_those_of_the_kernel(self):
        slopes = np.random.default_rng(2).uniform(-0.1, 0.1, (5, 2, 2))
        obj = pnsurfaces.make_triangulated_skins(
            POINTS, RADII, TRIANGLES, slopes=slopes, document=self.document, Skins="Inner skin"
        )
        derivatives = np.zeros((5, 2, 4))
        derivatives[:, 0, 0] = derivatives[:, 1, 1] = 1
        derivatives[:, :, 2:] = slopes
        family = kernel.pnkernel().sphere_family_powell_sabin(POINTS, RADII, derivatives, TRIANGLES)
        faces = family.skins[1].bsplines()
        self.assertEqual(len(obj.Shape.Faces), len(faces))
        for own, face in zip(obj.Shape.Faces, faces):
            self.assertTrue(np.array_equal(np.array(own.Surface.getPoles()), face.poles))
