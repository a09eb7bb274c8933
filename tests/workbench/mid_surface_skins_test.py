# SPDX-License-Identifier: LGPL-2.1-or-later
"""The skins of a mid-surface as a feature: nets, sources, what is shown, and refusals."""

import FreeCAD
import numpy as np
import Part
from FreeCAD import Vector
from support import DocumentTest, Recovery

import pnsurfaces
from pnsurfaces import kernel
from pnsurfaces.mid_surface_skins import read_net

# A dome: corners, then the points between them.
NET = [(0, 0, 0), (100, 0, 0), (40, 80, 0), (50, 0, 8), (70, 40, 10), (20, 40, 9)]
RADII = [3.0, 4.0, 2.5, 4.0, 3.5, 3.0]


class Skins(DocumentTest):
    def make(self, *args, **properties):
        obj = pnsurfaces.make_mid_surface_skins(*args, document=self.document, **properties)
        self.assertTrue(obj.isValid(), obj.getStatusString())
        return obj

    def assert_certified(self, obj):
        """All samples lie where the spheres of the family say."""
        (report,) = pnsurfaces.certificate([obj])["objects"]
        for section in report["sections"]:
            sampled = section["sampling"]
            bound = section["deviation"] + sampled["rounding"]
            self.assertLessEqual(sampled["worst"], bound)

    def test_both_skins_are_exact(self):
        obj = self.make(NET, RADII)
        self.assertEqual(obj.Status, "Valid")
        self.assertTrue(obj.Exact)
        self.assertEqual(len(obj.Shape.Shells), 2)
        self.assert_valid(obj)
        self.assert_certified(obj)

    def test_offsets(self):
        self.assert_certified(self.make(NET, RADII, 1.5))
        self.assert_certified(self.make(NET, RADII, -1, Sides="Base and offset"))

    def test_each_skin_is_one_of_both(self):
        both = self.make(NET, RADII)
        parts = [self.make(NET, RADII, Skins=skin) for skin in ("Inner skin", "Outer skin")]
        self.assertAlmostEqual(both.Area.Value, sum(part.Area.Value for part in parts), delta=1e-9)
        self.assertEqual(both.Poles, sum(part.Poles for part in parts))
        heights = [part.Shape.BoundBox.ZMax for part in parts]
        self.assertLess(heights[0], heights[1])

    def test_solid(self):
        """Both skins, closed by three strips and three parts of spheres."""
        obj = self.make(NET, RADII, Output="Solid")
        self.assertEqual(obj.Status, "Valid")
        self.assertEqual((obj.Shape.ShapeType, len(obj.Shape.Faces)), ("Solid", 8))
        self.assertTrue(obj.Shape.isClosed())
        brep = obj.Shape.exportBrepToString()
        self.assertEqual(kernel.pnocct().check(brep, boolean=True), [])
        self.assert_certified(obj)
        box = Part.makeBox(60, 60, 60, Vector(20, -10, -20))
        parts = [obj.Shape.cut(box), obj.Shape.common(box)]
        self.assertTrue(all(part.isValid() for part in parts))
        volumes = [kernel.pnocct().volume(part.exportBrepToString()) for part in parts]
        self.assertAlmostEqual(sum(volumes) / obj.Volume.Value, 1, delta=1e-6)

    def test_the_volume_of_the_solid_is_a_cubic_of_the_distance(self):
        """V(d) has the leading coefficient 4 pi / 3: its normals cover the sphere once."""
        obj = self.make(NET, RADII, Output="Solid")
        distances, volumes = (-1.0, 0.0, 1.0, 2.0), []
        for distance in distances:
            obj.Distance = distance
            self.document.recompute()
            self.assertTrue(obj.isValid(), obj.getStatusString())
            volumes.append(obj.Volume.Value)
        third_difference = np.diff(volumes, 3)[0]
        self.assertAlmostEqual(third_difference / 6, 4 * np.pi / 3, delta=1e-6)
        self.assertGreater(volumes[1], 0)

    def test_one_skin_is_no_solid(self):
        obj = pnsurfaces.make_mid_surface_skins(
            NET, RADII, document=self.document, Skins="Outer skin", Output="Solid"
        )
        self.assert_error(obj, "One skin encloses no solid.")

    def test_vertices_are_followed(self):
        source = self.shape_object(
            Part.Compound([Part.Vertex(Vector(*point)) for point in NET]), "Net"
        )
        obj = self.make((source, [f"Vertex{i}" for i in range(1, 7)]), RADII)
        self.assertTrue(np.array_equal(read_net(obj)[:, :3], np.array(NET, dtype=float)))
        before = obj.Shape.BoundBox.ZMax
        moved = [*NET[:3], *((x, y, z + 5) for x, y, z in NET[3:])]
        source.Shape = Part.Compound([Part.Vertex(Vector(*point)) for point in moved])
        self.document.recompute()
        self.assertGreater(obj.Shape.BoundBox.ZMax, before + 1)

    def test_three_corners_are_a_flat_net(self):
        corners = np.array(NET[:3], dtype=float)
        obj = self.make(NET[:3], RADII)
        self.assert_certified(obj)
        middles = [(corners[i] + corners[j]) / 2 for i, j in ((0, 1), (1, 2), (2, 0))]
        self.assertTrue(np.array_equal(read_net(obj)[3:, :3], middles))

    def test_placement_survives(self):
        obj = self.make(NET, RADII)
        obj.Placement.Base = Vector(1, 2, 3)
        obj.Distance = 1
        self.document.recompute()
        self.assertEqual(obj.Placement.Base, Vector(1, 2, 3))


class Refusals(Recovery, DocumentTest):
    def setUp(self):
        super().setUp()
        self.remember(pnsurfaces.make_mid_surface_skins(NET, RADII, document=self.document))

    def restore(self):
        self.obj.Centres = [Vector(*point) for point in NET]
        self.obj.Radii = RADII

    def test_a_sphere_that_swallows_its_neighbours(self):
        self.obj.Radii = [3.0, 400.0, 2.5, 4.0, 3.5, 3.0]
        self.assert_fails_and_recovers("one sphere swallows its neighbours", self.restore)

    def test_points_on_a_line(self):
        self.obj.Centres = [Vector(i, 0, 0) for i in range(6)]
        self.assert_fails_and_recovers("line", self.restore)

    def test_too_few_points(self):
        self.obj.Centres = self.obj.Centres[:4]
        self.assert_fails_and_recovers("A net has 6 points, or its 3 corners, not 4.", self.restore)

    def test_too_few_radii(self):
        self.obj.Radii = [1.0, 2.0]
        self.assert_fails_and_recovers("A net has 6 radii, not 2.", self.restore)

    def test_a_radius_that_is_no_number(self):
        self.obj.Radii = [float("nan"), *RADII[1:]]
        self.assert_fails_and_recovers("", self.restore)


class ListOfDocument(DocumentTest):
    def test_without_a_document_one_is_made(self):
        FreeCAD.closeDocument(self.document.Name)
        obj = pnsurfaces.make_mid_surface_skins(NET, RADII)
        self.assertTrue(obj.isValid())
        self.document = obj.Document
