# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of skins over a triangulation, opened by a double-click in the tree."""

import main_window
from support import GuiTest, input_of, wait_for_preview

import pnsurfaces

POINTS = [(0, 0, 0), (100, 0, 1), (110, 90, 0), (0, 100, 2), (52, 48, 14)]
RADII = [5.0, 4.0, 5.0, 4.5, 2.0]
TRIANGLES = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]


class PanelTest(GuiTest):
    def setUp(self):
        super().setUp()
        self.feature = pnsurfaces.make_triangulated_skins(
            POINTS, RADII, TRIANGLES, document=self.document, name="Dome"
        )
        self.document.clearUndos()
        main_window.settle()
        self.panel = self.reopen_panel(self.feature)
        wait_for_preview()

    def type_in_table(self, row, column, text):
        table = self.panel.table
        self.assertTrue(table.setData(table.index(row, column), text))
        wait_for_preview()

    def test_a_typed_radius_is_one_undo_step(self):
        top = self.feature.Shape.BoundBox.ZMax
        self.type_in_table(4, 3, "6 mm")
        self.assertEqual(self.feature.Radii[4], 6)
        self.assertGreater(self.feature.Shape.BoundBox.ZMax, top + 3)
        main_window.screenshot("triangulated_skins")
        main_window.confirm(self.panel)
        self.assert_nothing_open()
        self.document.undo()
        self.assertEqual(self.feature.Radii[4], 2)

    def test_a_typed_centre_and_cancel(self):
        self.type_in_table(4, 2, "20")
        self.assertEqual(self.feature.Centres[4].z, 20)
        main_window.cancel(self.panel)
        self.assertEqual(self.feature.Centres[4].z, 14)

    def test_each_skin(self):
        faces = len(self.feature.Shape.Faces)
        input_of(self.panel, "Skins").setCurrentText("Inner skin")
        wait_for_preview()
        self.assertLess(len(self.feature.Shape.Faces), faces)
        main_window.cancel(self.panel)

    def test_an_error_is_a_sentence_and_recovers(self):
        self.type_in_table(0, 3, "500")
        self.assertIn("no envelope", input_of(self.panel, "status").text())
        self.type_in_table(0, 3, "5")
        self.assertEqual(self.feature.Status, "Valid")
        main_window.cancel(self.panel)
