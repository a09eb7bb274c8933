# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of all sections at once, against the kernel's own and against equations."""

import unittest

import numpy as np

from pnsurfaces import kernel
from pnsurfaces.section_mesh import section_mesh

# Rounding of points some 100 mm from the origin, and of unit normals made of their differences.
_ROUNDING = 1e-10


class SectionMeshTest(unittest.TestCase):
    def setUp(self):
        self.pn = kernel.pnkernel()

    def test_pipe_around_a_line(self):
        spine = self.pn.Curve.bezier([[0, 0, 0], [0, 0, 50]])
        mesh = section_mesh(self.pn.canal_surface(spine, self.pn.Law.constant(3)))
        for distance in (0.0, 2.5, -4.0):
            x, y, z = mesh.section(distance).T
            np.testing.assert_allclose(np.hypot(x, y), abs(3 + distance), atol=_ROUNDING)
            np.testing.assert_allclose((z.min(), z.max()), (0, 50), atol=_ROUNDING)

    def test_corners_are_filled(self):
        pn = self.pn
        legs = [pn.Curve.bezier(ends) for ends in ([[0, 0, 0], [40, 0, 0]], [[40, 0, 0], [40, 40, 0]])]
        mesh = section_mesh(pn.canal_surface(pn.Curve.chain(legs), pn.Law.constant(4)))
        outermost = mesh.points @ (1, -1, 0) / np.sqrt(2)
        # The sphere at the corner reaches as far beyond it as its radius.
        self.assertAlmostEqual(outermost.max(), 40 / np.sqrt(2) + 4, delta=0.05)

    def test_ellipsoid(self):
        mesh = section_mesh(self.pn.quadric("ellipsoid", 40, 30, 20))
        equation = ((mesh.points / (40, 30, 20)) ** 2).sum(axis=1)
        np.testing.assert_allclose(equation, 1, atol=_ROUNDING)
        gradients = mesh.points / np.square((40, 30, 20))
        gradients /= np.linalg.norm(gradients, axis=1)[:, None]
        np.testing.assert_allclose(mesh.normals, gradients, atol=_ROUNDING)

    def test_trimmed_faces_are_filled_up_to_their_edges(self):
        for name, bounds in (("elliptic_paraboloid", {"z": (0, 20)}), ("ellipsoid", {"z": (-5, 8)})):
            mesh = section_mesh(self.pn.quadric(name, 40, 30, 20, bounds))
            low, high = bounds["z"]
            z = mesh.points[:, 2]
            self.assertGreater(z.min(), low - 0.05)
            self.assertLess(z.max(), high + 0.05)
            self.assertAlmostEqual(_area(mesh), _area_of_faces(self.pn, name, bounds), delta=20)

    def test_triangles_face_the_normals(self):
        for surface in (
            self.pn.quadric("elliptic_paraboloid", 40, 30, 20, {"z": (0, 20)}),
            self.pn.quadric("ellipsoid", 40, 30, 20),
        ):
            mesh = section_mesh(surface)
            facing = np.einsum("mc,mc->m", _crosses(mesh), mesh.normals[mesh.triangles[:, 0]])
            self.assertGreaterEqual(facing.min(), -_ROUNDING)

    def test_long_spines_keep_few_points(self):
        count = 1000
        turns = np.arange(count + 3) / 20
        poles = np.column_stack([40 * np.cos(turns), 40 * np.sin(turns), 10 * turns])
        multiplicities = [4] + [1] * (count - 1) + [4]
        spine = self.pn.Curve.bspline(3, np.arange(count + 1.0), multiplicities, poles)
        mesh = section_mesh(self.pn.canal_surface(spine, self.pn.Law.constant(1)))
        self.assertLess(len(mesh.points), 100_000)
        np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=_ROUNDING)


def _crosses(mesh):
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


def _area(mesh):
    return np.linalg.norm(_crosses(mesh), axis=1).sum() / 2


def _area_of_faces(pn, name, bounds):
    occt = kernel.pnocct()
    return occt.area(occt.shell(pn.quadric(name, 40, 30, 20, bounds).bsplines()))
