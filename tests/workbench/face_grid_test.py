# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grids and lines end where faces end: their area and length against FreeCAD's."""

import numpy as np
import Part
from FreeCAD import Vector
from support import DocumentTest

from pnsurfaces import make_canal_surface, make_quadric_offset, make_ruled_offset
from pnsurfaces.face_grid import face_grid, lines, patches
from pnsurfaces.spline_grid import points_at


# Points in each direction at which FreeCAD is asked whether they lie inside a face.
_POINTS = 25


def patches_of(face, rows=64, columns=32):
    return patches(face_grid(face), rows, columns)


def parameter_area(patch):
    """Area of a patch in the plane of the parameters."""
    v = np.broadcast_to(patch.v, (len(patch.u), np.shape(patch.v)[-1]))
    widths = np.ptp(v, axis=1)
    return np.sum(np.diff(patch.u) * (widths[:-1] + widths[1:]) / 2)


class Patches(DocumentTest):
    def assert_covered(self, face):
        """All points of the patches lie inside, and they are as large as the inside is."""
        u_first, u_last, v_first, v_last = face.ParameterRange
        u, v = (
            low + (high - low) * (np.arange(_POINTS) + 0.5) / _POINTS
            for low, high in ((u_first, u_last), (v_first, v_last))
        )
        inside = np.mean([face.isPartOfDomain(a, b) for a in u for b in v])
        area = sum(map(parameter_area, patches_of(face)))
        # The boundary is met by few of the lines of points.
        self.assertAlmostEqual(
            area / ((u_last - u_first) * (v_last - v_first)), inside, delta=1 / _POINTS
        )
        for patch in patches_of(face, 9, 5):
            rows = np.broadcast_to(patch.v, (len(patch.u), np.shape(patch.v)[-1]))
            for a, row in zip(patch.u[2:-2], rows[2:-2, 1:-1]):
                for b in row:
                    self.assertTrue(face.isPartOfDomain(a, b), (a, b))

    def test_whole_faces(self):
        pipe = make_canal_surface(self.spline_object(), (2, 3), 0.5)
        egg = make_quadric_offset("Ellipsoid", 30, 20, 10, 2)
        for face in (*pipe.Shape.Faces, *egg.Shape.Faces):
            self.assertIsNone(face_grid(face).boundary)
            (patch,) = patches_of(face)
            self.assertEqual((patch.u[0], patch.u[-1], patch.v[0], patch.v[-1]), face.ParameterRange)

    def test_a_cut_ruled_face(self):
        edges = (
            self.shape_object(Part.makeLine(Vector(0, 0, 0), Vector(40, 0, 0))),
            self.shape_object(Part.makeLine(Vector(0, 30, 0), Vector(40, 40, 30))),
        )
        (face,) = make_ruled_offset(*edges, 1).Shape.Faces
        self.assertIsNotNone(face_grid(face).boundary)
        self.assert_covered(face)

    def test_regions_of_quadrics(self):
        for kind, bounds in (
            ("Ellipsoid", {"z": (-3, 6), "angle": (10, 110)}),
            ("Ellipsoid", {"z": (-3, 6)}),
            ("Hyperbolic paraboloid", {"x": (-3, 6), "y": (-5, 5)}),
        ):
            for face in make_quadric_offset(kind, 30, 20, 10, 1, bounds=bounds).Shape.Faces:
                self.assert_covered(face)

    def test_a_face_with_a_hole(self):
        pipe = make_canal_surface(self.line_object(20), 6)
        drill = Part.makeCylinder(2, 20, Vector(0, 0, 10), Vector(0.3, -1, 0))
        (pierced,) = pipe.Shape.cut(drill).Faces
        self.assertLess(pierced.Area, pipe.Shape.Area - 10)
        self.assertGreater(len(patches_of(pierced)), 3)
        self.assert_covered(pierced)

    def test_a_plane_has_no_grid(self):
        self.assertIsNone(face_grid(Part.makePlane(1, 1).Faces[0]))

    def test_reversed_faces_are_told(self):
        face = make_canal_surface(self.line_object(), 2).Shape.Faces[0]
        self.assertEqual(face_grid(face).side, 1)
        self.assertEqual(face_grid(face.reversed()).side, -1)


class Lines(DocumentTest):
    def test_lines_of_a_whole_face_are_its_parameter_lines(self):
        grid = face_grid(make_canal_surface(self.line_object(10), 2).Shape.Faces[0])
        for line in lines(grid, 0, 5, 9):
            heights = points_at(grid.surface, line[:1, 0], line[:, 1])[0, :, 2]
            self.assertLess(np.ptp(heights), 1e-12)
        along = lines(grid, 1, 5, 9)
        self.assertGreaterEqual(len(along), 5)
        for line in along:
            points = points_at(grid.surface, line[:, 0], line[:, 1:])[:, 0]
            self.assertAlmostEqual(np.linalg.norm(points[-1] - points[0]), 10, delta=1e-12)

    def test_lines_of_a_cut_face_end_on_its_boundary(self):
        region = {"x": (-3, 6), "y": (-5, 5)}
        saddle = make_quadric_offset("Hyperbolic paraboloid", 30, 20, 10, bounds=region)
        (face,) = saddle.Shape.Faces
        grid = face_grid(face)
        for axis in (0, 1):
            ends = [line[[0, -1]] for line in lines(grid, axis, 7, 5)]
            self.assertTrue(ends)
            for u, v in np.concatenate(ends):
                x, y, _ = face.Surface.value(u, v)
                self.assertLess(min(abs(x + 3), abs(x - 6), abs(abs(y) - 5)), 1e-3)
