# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preferences page, and that new surfaces and STEP files follow it."""

import os
import tempfile
from unittest import mock

import FreeCAD
import FreeCADGui
import main_window
from support import GuiTest

import pnsurfaces
from pnsurfaces import preferences, progress
from pnsurfaces.compat import QtWidgets


class PreferencesTest(GuiTest):
    def test_defaults(self):
        self.assertEqual(preferences.distance(), 0)
        self.assertEqual(preferences.parameter_lines(), "Even")
        self.assertEqual(preferences.step_schema(), "AP214")
        self.assertTrue(preferences.step_parametric_curves())
        self.assertEqual(preferences.export_path("a.step"), "a.step")

    def test_page_decides_how_new_surfaces_start(self):
        def edit(widget):
            self.assertEqual(widget("step_schema").currentText(), preferences.step_schema())
            self.assertEqual(widget("parameter_lines").currentText(), preferences.parameter_lines())
            main_window.type_text(widget("distance"), "1.5")
            widget("parameter_lines").setCurrentText("Lowest degree")
            widget("step_schema").setCurrentText("AP242")
            self.assertTrue(widget("step_parametric_curves").isChecked())
            widget("step_parametric_curves").click()

        main_window.edit_preferences("PN Surfaces", edit)
        self.assertEqual(preferences.distance(), 1.5)
        self.assertEqual(preferences.parameter_lines(), "Lowest degree")
        self.assertEqual(preferences.step_schema(), "AP242")
        self.assertFalse(preferences.step_parametric_curves())
        feature, panel = self.open_panel(self.line, "Edge1")
        self.assertEqual(feature.Distance.Value, 1.5)
        self.assertEqual(feature.ParameterLines, "Lowest degree")
        main_window.cancel(panel)


class ExportStepTest(GuiTest):
    def test_selected_surface_is_written(self):
        feature = pnsurfaces.make_canal_surface(self.line, 3)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = os.path.join(folder.name, "tube.step")
        self.select(feature)
        since = len(main_window.recorded_commands())
        with self._answering(path):
            FreeCADGui.runCommand("PNSurfaces_ExportStep")
        with open(path, encoding="ascii") as file:
            header = file.read(1000)
        # The name of AP214 in STEP.
        self.assertIn("AUTOMOTIVE_DESIGN", header)
        self.assertEqual(preferences.export_path("b.step"), os.path.join(folder.name, "b.step"))
        (line,) = [c for c in main_window.recorded_commands()[since:] if "export_step" in c]
        self.assertIn("schema='AP214', parametric_curves=True", line)
        os.remove(path)
        exec(line, {"App": FreeCAD, "pnsurfaces": pnsurfaces})
        self.assertTrue(os.path.exists(path))

    def test_cancelling_leaves_the_old_file(self):
        feature = pnsurfaces.make_canal_surface(self.line, 3)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = os.path.join(folder.name, "tube.step")
        with open(path, "w", encoding="ascii") as file:
            file.write("old")
        self.select(feature)
        cancelled = mock.patch.object(
            progress._Bar, "__call__", side_effect=FreeCAD.Base.FreeCADAbort("Esc")
        )
        with self._answering(path), cancelled:
            FreeCADGui.runCommand("PNSurfaces_ExportStep")
        with open(path, encoding="ascii") as file:
            self.assertEqual(file.read(), "old")
        self.assertEqual(os.listdir(folder.name), ["tube.step"])

    def test_failure_is_explained(self):
        feature = pnsurfaces.make_canal_surface(self.line, 3)
        self.select(feature)
        answers = []
        main_window.answer_message_box(answers)
        with self._answering("/no such folder/tube.step"):
            FreeCADGui.runCommand("PNSurfaces_ExportStep")
        self.assertEqual(len(answers), 1)
        self.assertIn("/no such folder", answers[0])

    def test_it_needs_a_selection(self):
        FreeCADGui.Selection.clearSelection()
        self.assertFalse(FreeCADGui.Command.get("PNSurfaces_ExportStep").isActive())

    def _answering(self, path):
        dialog = mock.Mock()
        dialog.getSaveFileName.return_value = (path, "STEP files")
        return mock.patch.object(QtWidgets, "QFileDialog", dialog)
