# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrow in the 3D view that drags the distance."""

import main_window
from support import GuiTest, input_of, wait_for_preview


class DistanceHandleTest(GuiTest):
    def setUp(self):
        super().setUp()
        self.feature, self.panel = self.open_panel(self.line, "Edge1")
        main_window.type_text(input_of(self.panel, "Radius"), "8")
        wait_for_preview()

    def test_dragging_changes_distance_and_surface(self):
        main_window.drag_handle(self.feature, 1)
        distance = self.feature.Distance.Value
        self.assertGreater(distance, 0)
        self.assertEqual(input_of(self.panel, "Distance").property("rawValue"), distance)
        self.assertEqual(self.panel.limits.marks[0].distance, distance)
        self.assertFalse(main_window.is_drawn(self.feature))
        main_window.screenshot("dragged")
        wait_for_preview()
        self.assert_radius(self.feature, 8 + distance)

    def test_dragging_stops_at_round_distances(self):
        main_window.drag_handle(self.feature, 0.123456789)
        self.assertEqual(self.feature.Distance.Value, round(self.feature.Distance.Value, 2))
        self.assertNotEqual(self.feature.Distance.Value, 0)

    def test_the_arrow_stands_on_the_surface(self):
        for distance in (0, 3, -2):
            main_window.type_text(input_of(self.panel, "Distance"), str(distance))
            x, y, _ = main_window.handle_position(self.feature)
            self.assertAlmostEqual((x * x + y * y) ** 0.5, 8 + distance, places=4)

    def test_the_arrow_goes_with_the_panel(self):
        self.assertTrue(main_window.has_handle(self.feature))
        main_window.confirm(self.panel)
        self.assertFalse(main_window.has_handle(self.feature))

    def test_the_arrow_is_there_when_the_panel_opens_again(self):
        main_window.confirm(self.panel)
        self.document.clearUndos()
        self.panel = self.reopen_panel(self.feature)
        wait_for_preview()
        self.assertTrue(main_window.has_handle(self.feature))
        main_window.screenshot("handle")
        main_window.confirm(self.panel)
        self.assertEqual(self.document.UndoCount, 0)

    def test_a_bound_distance_is_not_dragged(self):
        main_window.confirm(self.panel)
        self.feature.setExpression("Distance", "1 mm + 1 mm")
        self.document.recompute()
        self.panel = self.reopen_panel(self.feature)
        wait_for_preview()
        self.assertFalse(main_window.has_handle(self.feature))

    def test_binding_the_distance_takes_the_arrow_away(self):
        self.feature.setExpression("Distance", "1 mm + 1 mm")
        wait_for_preview()
        self.assertFalse(main_window.has_handle(self.feature))
        self.feature.setExpression("Distance", None)
        main_window.type_text(input_of(self.panel, "Distance"), "3")
        wait_for_preview()
        self.assertTrue(main_window.has_handle(self.feature))
