# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview: the window stays alive while surfaces are computed, and only the latest counts."""

import contextlib
import math
import threading
from unittest import mock

import FreeCAD
import FreeCADGui
import main_window
from support import GuiTest, input_of, poles, wait_for_preview

from pnsurfaces.canal_surface import CanalSurface
from pnsurfaces.preview import LONG

# Seconds after which a test has hung.
_PATIENCE = 30


@contextlib.contextmanager
def held_up():
    """Canal surfaces are computed only when the yielded event is set, or at the end."""
    gate = threading.Event()
    base = CanalSurface.base

    def waiting(proxy, inputs):
        gate.wait(_PATIENCE)
        return base(proxy, inputs)

    with mock.patch.object(CanalSurface, "base", waiting):
        try:
            yield gate
        finally:
            gate.set()


class LivePreviewTest(GuiTest):
    def setUp(self):
        super().setUp()
        self.feature, self.panel = self.open_panel(self.line, "Edge1")

    def type(self, name, text):
        main_window.type_text(input_of(self.panel, name), text)

    def test_the_window_goes_on_during_a_computation(self):
        with held_up() as gate:
            self.type("Radius", "7")
            main_window.settle(2 * LONG)
            self.assertTrue(self.panel.is_busy())
            gate.set()
            wait_for_preview()
        self.assert_radius(self.feature, 7)

    def test_the_latest_value_wins(self):
        with held_up() as gate:
            for radius in ("4", "5", "6"):
                self.type("Radius", radius)
                main_window.settle()
            gate.set()
            wait_for_preview()
        self.assert_radius(self.feature, 6)

    def test_a_distance_needs_no_new_surface(self):
        wait_for_preview()
        self.type("Radius", "4")
        wait_for_preview()
        with mock.patch.object(CanalSurface, "base", side_effect=AssertionError):
            self.type("Distance", "1.5")
            wait_for_preview()
        self.assert_radius(self.feature, 5.5)

    def test_while_the_distance_changes_points_are_drawn_at_once(self):
        self.type("Radius", "4")
        wait_for_preview()
        self.assertTrue(main_window.is_drawn(self.feature))
        for distance in (0.5, 1.0, 1.5):
            self.type("Distance", str(distance))
            self.assertFalse(main_window.is_drawn(self.feature))
            drawn = main_window.drawn_points(self.feature)
            self.assertGreater(len(drawn), 100)
            for x, y, _ in drawn:
                self.assertAlmostEqual(math.hypot(x, y), 4 + distance, places=4)
        main_window.screenshot("sketch")
        wait_for_preview()
        self.assertTrue(main_window.is_drawn(self.feature))
        self.assertEqual(main_window.drawn_points(self.feature), [])

    def test_cancel_while_points_are_drawn_shows_the_shape(self):
        main_window.confirm(self.panel)
        self.panel = self.reopen_panel(self.feature)
        self.type("Radius", "4")
        wait_for_preview()
        self.type("Distance", "3")
        self.assertFalse(main_window.is_drawn(self.feature))
        main_window.cancel(self.panel)
        self.assertTrue(main_window.is_drawn(self.feature))
        self.assertEqual(main_window.drawn_points(self.feature), [])

    def test_a_changed_source_needs_a_new_surface(self):
        self.type("Distance", "1")
        wait_for_preview()
        self.line.Shape = self.line.Shape.translated(FreeCAD.Vector(0, 0, 50))
        self.type("Distance", "2")
        wait_for_preview()
        self.assertAlmostEqual(self.feature.Shape.Faces[0].Surface.bounds()[1], 100, places=0)
        z = [vertex.Z for vertex in self.feature.Shape.Vertexes]
        self.assertAlmostEqual(min(z), 50)

    def test_progress_is_shown_after_a_while_only(self):
        progress = input_of(self.panel, "progress")
        with held_up():
            self.type("Radius", "7")
            main_window.settle(LONG // 2)
            self.assertFalse(progress.isVisible())
            main_window.settle(LONG)
            self.assertTrue(progress.isVisible())
            main_window.screenshot("progress")
        wait_for_preview()
        self.assertFalse(progress.isVisible())

    def test_stop_keeps_the_surface_and_the_panel(self):
        wait_for_preview()
        before = poles(self.feature)
        with held_up():
            self.type("Radius", "7")
            main_window.settle(2 * LONG)
            input_of(self.panel, "stop").click()
            self.assertFalse(input_of(self.panel, "progress").isVisible())
        main_window.settle()
        self.assertEqual(poles(self.feature), before)
        self.assertTrue(input_of(self.panel, "status").text().startswith("Stopped."))
        self.assertTrue(FreeCADGui.Control.activeDialog())
        main_window.screenshot("stopped")
        main_window.confirm(self.panel)
        self.assert_nothing_open()
        self.assert_radius(self.feature, 7)

    def test_escape_is_the_shortcut_of_stop(self):
        self.assertEqual(input_of(self.panel, "stop").shortcut().toString(), "Esc")

    def test_ok_waits_for_the_surface(self):
        with held_up() as gate:
            self.type("Radius", "7")
            self.assertFalse(self.panel.accept())
            main_window.settle()
            self.assertTrue(FreeCADGui.Control.activeDialog())
            self.assertFalse(input_of(self.panel, "Radius").isEnabled())
            gate.set()
            main_window.settle_until(lambda: not self.panel.is_busy())
        self.assert_nothing_open()
        self.assert_radius(self.feature, 7)
        self.assertEqual(self.document.UndoNames, ["Canal surface"])
        self.document.undo()
        self.assertEqual(self.document.Objects, [self.line, self.spline])
        self.document.redo()
        self.assert_radius(self.document.CanalSurface, 7)

    def test_ok_waits_and_an_error_keeps_the_panel(self):
        with held_up() as gate:
            input_of(self.panel, "RadiusLaw").setCurrentText("Linear")
            self.type("EndRadius", "500")
            self.assertFalse(self.panel.accept())
            gate.set()
            wait_for_preview()
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.assertTrue(input_of(self.panel, "Radius").isEnabled())
        self.assertTrue(input_of(self.panel, "status").text().startswith("Error: "))

    def test_cancel_during_a_computation_leaves_nothing(self):
        with held_up() as gate:
            self.type("Radius", "7")
            main_window.settle()
            main_window.cancel(self.panel)
            self.assert_nothing_open()
            gate.set()
            main_window.settle()
        self.assertEqual(self.document.Objects, [self.line, self.spline])
        self.assertEqual(self.document.UndoCount, 0)

    def test_closing_the_document_during_a_computation(self):
        with held_up() as gate:
            self.type("Radius", "7")
            main_window.settle()
            FreeCAD.closeDocument(self.document.Name)
            gate.set()
            main_window.settle()
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_deleting_the_feature_during_a_computation(self):
        with held_up() as gate:
            self.type("Radius", "7")
            main_window.settle()
            self.document.removeObject(self.feature.Name)
            gate.set()
            main_window.settle()
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_undo_during_a_computation(self):
        with held_up() as gate:
            self.type("Radius", "7")
            main_window.settle()
            self.document.undo()
            gate.set()
            main_window.settle()
        self.assert_nothing_open()
        self.assertEqual(self.document.Objects, [self.line, self.spline])
