# SPDX-License-Identifier: LGPL-2.1-or-later
"""The evaluation of its own against OpenCASCADE's."""

import numpy as np
import Part
from FreeCAD import Vector
from support import RADII, DocumentTest

from pnsurfaces import make_canal_surface
from pnsurfaces.spline_grid import basis, jet_at, points_and_normals, points_at, spline_surface, spread

# Places in a Jet, and the orders of the derivatives.
_ORDERS = {"u": (1, 0), "v": (0, 1), "uu": (2, 0), "uv": (1, 1), "vv": (0, 2)}


class SplineGrid(DocumentTest):
    def setUp(self):
        super().setUp()
        obj = make_canal_surface(self.spline_object(), ("Values at vertices", RADII), 0.3)
        self.surface = obj.Shape.Faces[0].Surface
        self.grid = spline_surface(self.surface)

    def parameters(self):
        """None of them a knot, where second derivatives jump."""
        u, v = (spread(knots, 17) for knots in (self.grid.u_knots, self.grid.v_knots))
        return (u[:-1] + u[1:]) / 2, (v[:-1] + v[1:]) / 2

    def test_points_and_derivatives(self):
        u, v = self.parameters()
        jet = jet_at(self.grid, u, v)
        for i in range(0, len(u), 3):
            for k in range(0, len(v), 3):
                point = np.array(self.surface.value(u[i], v[k]))
                np.testing.assert_allclose(jet.point[i, k], point, rtol=0, atol=1e-12)
                for name, orders in _ORDERS.items():
                    expected = np.array(self.surface.getDN(u[i], v[k], *orders))
                    size = max(1, np.abs(expected).max())
                    found = getattr(jet, name)[i, k]
                    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * size)

    def test_each_u_may_have_its_own_v(self):
        u, v = self.parameters()
        own = np.array([v + 0.01 * i for i in range(len(u))])
        points = points_at(self.grid, u, own)
        for i in (0, 3, len(u) - 1):
            row = points_at(self.grid, u[i : i + 1], own[i])
            np.testing.assert_allclose(points[i], row[0], rtol=0, atol=1e-13)

    def test_ends_belong_to_the_last_span(self):
        u_first, u_last, v_first, v_last = self.surface.bounds()
        points = points_at(self.grid, np.array([u_first, u_last]), np.array([v_first, v_last]))
        poles = np.array(self.surface.getPoles())
        np.testing.assert_allclose(points, poles[[0, -1]][:, [0, -1]], rtol=0, atol=1e-13)

    def test_normals_are_those_of_opencascade(self):
        u, v = self.parameters()
        normals = jet_at(self.grid, u, v).normals()
        for i in range(0, len(u), 5):
            for k in range(0, len(v), 5):
                expected = np.array(self.surface.normal(u[i], v[k]))
                np.testing.assert_allclose(normals[i, k], expected, rtol=0, atol=1e-12)

    def test_a_pole_has_no_normal_and_is_left_out(self):
        sphere = spline_surface(Part.makeSphere(2).toNurbs().Faces[0].Surface)
        u, v = np.unique(sphere.u_knots), np.unique(sphere.v_knots)
        points, normals = points_and_normals(sphere, u, v)
        self.assertEqual(len(points), len(u) * (len(v) - 2))
        np.testing.assert_allclose(normals, points / 2, rtol=0, atol=1e-12)

    def test_basis_functions_add_up_to_one_and_their_derivatives_to_zero(self):
        knots = np.array([0, 0, 0, 0, 0.2, 0.5, 0.5, 1, 1, 1, 1], dtype=float)
        t = np.linspace(0, 1, 41)
        np.testing.assert_allclose(basis(knots, 3, t).sum(axis=-1), 1, atol=1e-14)
        for order in (1, 2, 3):
            derivative = basis(knots, 3, t, order)
            np.testing.assert_allclose(derivative.sum(axis=-1), 0, atol=1e-9)
        np.testing.assert_array_equal(basis(knots, 3, t, 4), 0)

    def test_spread_has_every_knot(self):
        knots = np.array([0, 0, 0.3, 0.7, 0.7, 1, 1])
        values = spread(knots, 10)
        self.assertGreaterEqual(len(values), 10)
        self.assertLessEqual({0, 0.3, 0.7, 1}, set(values))
        self.assertTrue((np.diff(values) > 0).all())

    def test_planes_are_none(self):
        self.assertIsNone(spline_surface(Part.Plane()))

    def test_bezier_surfaces_are_splines(self):
        bezier = Part.BezierSurface()
        bezier.setPole(1, 1, Vector(0, 0, 3))
        u = np.array([0.25])
        point = points_at(spline_surface(bezier), u, u)[0, 0]
        np.testing.assert_allclose(point, np.array(bezier.value(0.25, 0.25)), atol=1e-15)
