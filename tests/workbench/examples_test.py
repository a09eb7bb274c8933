# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples of the gallery: every surface is regular and every solid fit for Booleans."""

import importlib
import pathlib
import sys

import FreeCAD
from support import DocumentTest

from pnsurfaces import kernel
from pnsurfaces.feature import VALID

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "resources" / "examples"


class Examples(DocumentTest):
    def setUp(self):
        super().setUp()
        sys.path.append(str(FOLDER))
        self.addCleanup(sys.path.remove, str(FOLDER))

    def make(self, name):
        return getattr(importlib.import_module(name), f"make_{name}")()

    def assert_sound(self, name, *solids):
        """All objects are valid, and the Boolean check finds nothing in the exact solids."""
        document = self.make(name)
        for obj in document.Objects:
            self.assertTrue(obj.isValid(), f"{obj.Label}: {obj.getStatusString()}")
            self.assertEqual(getattr(obj, "Status", VALID), VALID)
            self.assertTrue(obj.Shape.isValid(), obj.Label)
        for solid in solids:
            shape = document.getObject(solid).Shape
            self.assertEqual(shape.ShapeType, "Solid")
            self.assertEqual(kernel.pnocct().check(shape.exportBrepToString(), boolean=True), [])

    def test_intake_horn(self):
        self.assert_sound("intake_horn", "Wall")

    def test_reflector(self):
        self.assert_sound("reflector", "Dish")

    def test_saddle_roof(self):
        self.assert_sound("saddle_roof", "Shell")

    def test_cooling_tower(self):
        self.assert_sound("cooling_tower", "Wall")

    def test_twisted_blade(self):
        self.assert_sound("twisted_blade", "Blade", "Hub")

    def test_walls_follow_their_distance(self):
        for name, leader, wall in (
            ("intake_horn", "Outer", "Wall"),
            ("saddle_roof", "Upper", "Shell"),
            ("twisted_blade", "Suction", "Blade"),
        ):
            with self.subTest(name):
                document = self.make(name)
                leader, wall = document.getObject(leader), document.getObject(wall)
                before = wall.Shape.Volume
                leader.Distance = 2 * leader.Distance
                document.recompute()
                self.assertTrue(wall.isValid(), wall.getStatusString())
                self.assertAlmostEqual(wall.Shape.Volume / before, 2, delta=0.02)
