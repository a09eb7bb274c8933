# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Certificate and its panel, driven as a person drives them."""

import json
import os
import tempfile
from unittest import mock

import FreeCADGui
import main_window
from support import GuiTest

import pnsurfaces
from pnsurfaces.certificate_text import as_markdown
from pnsurfaces.compat import QtCore, QtWidgets

COMMAND = "PNSurfaces_Certificate"


class CertificateTest(GuiTest):
    def setUp(self):
        super().setUp()
        self.feature = pnsurfaces.make_canal_surface(self.spline, (8, 12), 2)
        self.select(self.feature)

    def open_certificate(self):
        FreeCADGui.runCommand(COMMAND)
        main_window.settle()
        window = FreeCADGui.getMainWindow()
        return window.findChild(QtWidgets.QWidget, "Certificate")

    def close_certificate(self):
        FreeCADGui.Control.closeDialog()
        main_window.settle()

    def markdown(self, **options):
        return as_markdown(pnsurfaces.certificate([self.feature], **options))

    def test_report_is_shown(self):
        form = self.open_certificate()
        text = form.report.toPlainText()
        self.assertIn("CanalSurface", text)
        self.assertIn("Proven deviation", text)
        self.assertIn(f"1, {self.feature.Poles}", text)
        main_window.screenshot("certificate")
        self.close_certificate()
        self.assert_nothing_open()
        self.assertEqual(self.document.UndoCount, 0)
        self.assertNotIn("Touched", self.feature.State)

    def test_copy(self):
        form = self.open_certificate()
        form.copy.click()
        self.assertEqual(QtWidgets.QApplication.clipboard().text(), self.markdown())
        self.close_certificate()

    def test_comparison_is_made_when_asked(self):
        form = self.open_certificate()
        self.assertNotIn("FreeCAD's own offset", form.report.toPlainText())
        form.compare.click()
        self.assertIn("FreeCAD's own offset", form.report.toPlainText())
        form.compare.click()
        self.assertNotIn("FreeCAD's own offset", form.report.toPlainText())
        self.close_certificate()

    def test_save(self):
        form = self.open_certificate()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = os.path.join(folder.name, "pipe.json")
        with self._answering(path):
            form.save.click()
        with open(path, encoding="utf-8") as file:
            self.assertEqual(json.load(file), pnsurfaces.certificate([self.feature]))
        self.close_certificate()

    def test_a_failure_to_save_is_explained(self):
        form = self.open_certificate()
        answers = []
        main_window.answer_message_box(answers)
        with self._answering("/no such folder/pipe.md"):
            form.save.click()
        self.assertEqual(len(answers), 1)
        self.assertIn("/no such folder", answers[0])
        self.close_certificate()

    def test_escape_closes(self):
        form = self.open_certificate()
        main_window.press(form, QtCore.Qt.Key_Escape)
        main_window.settle()
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_other_objects_are_answered(self):
        self.select(self.line)
        form = self.open_certificate()
        self.assertIn("Line is no surface of PN Surfaces", form.report.toPlainText())
        self.close_certificate()

    def test_it_needs_a_selection(self):
        FreeCADGui.Selection.clearSelection()
        self.assertFalse(FreeCADGui.Command.get(COMMAND).isActive())

    def _answering(self, path):
        return mock.patch.object(QtWidgets.QFileDialog, "getSaveFileName", return_value=(path, ""))
