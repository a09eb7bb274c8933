# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples of the gallery: every surface is regular and every solid fit for Booleans."""

from support import DocumentTest

import pnsurfaces
from pnsurfaces import kernel
from pnsurfaces.examples import gallery
from pnsurfaces.feature import VALID


class Examples(DocumentTest):
    def test_all_objects_are_valid(self):
        for example in gallery():
            for obj in pnsurfaces.open_example(example.name).Objects:
                with self.subTest(example.name, obj=obj.Label):
                    self.assertTrue(obj.isValid(), obj.getStatusString())
                    self.assertEqual(getattr(obj, "Status", VALID), VALID)
                    self.assertTrue(obj.Shape.isValid())

    def test_surfaces_are_exact_regular_and_where_they_are_said_to_be(self):
        for example in gallery():
            document = pnsurfaces.open_example(example.name)
            surfaces = [document.getObject(name) for name in example.surfaces]
            for report in pnsurfaces.certificate(surfaces)["objects"]:
                with self.subTest(example.name, surface=report["label"]):
                    self.assertTrue(report["exact"])
                    self.assertEqual(report["shape"]["faults"], [])
                    for section in report["sections"]:
                        self.assertIn(section["regular"], (True, None))
                        sampled = section["sampling"]
                        self.assertLessEqual(
                            sampled["worst"], section["deviation"] + sampled["rounding"]
                        )

    def test_solids_are_fit_for_boolean_operations(self):
        for example in gallery():
            document = pnsurfaces.open_example(example.name)
            for name in example.solids:
                with self.subTest(example.name, solid=name):
                    shape = document.getObject(name).Shape
                    self.assertEqual(shape.ShapeType, "Solid")
                    faults = kernel.pnocct().check(shape.exportBrepToString(), boolean=True)
                    self.assertEqual(faults, [])

    def test_there_is_no_other_example(self):
        with self.assertRaisesRegex(KeyError, "reflector"):
            pnsurfaces.open_example("refelctor")

    def test_walls_follow_their_distance(self):
        for name, leader, wall in (
            ("intake_horn", "Outer", "Wall"),
            ("saddle_roof", "Upper", "Shell"),
            ("twisted_blade", "Suction", "Blade"),
        ):
            with self.subTest(name):
                document = pnsurfaces.open_example(name)
                leader, wall = document.getObject(leader), document.getObject(wall)
                before = wall.Shape.Volume
                leader.Distance = 2 * leader.Distance
                document.recompute()
                self.assertTrue(wall.isValid(), wall.getStatusString())
                self.assertAlmostEqual(wall.Shape.Volume / before, 2, delta=0.02)
