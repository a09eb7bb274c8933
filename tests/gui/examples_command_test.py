# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands Examples and Documentation, driven as a person drives them."""

import FreeCAD
import FreeCADGui
import main_window
from support import GuiTest

from pnsurfaces.compat import QtCore, QtWidgets
from pnsurfaces.documentation import Documentation
from pnsurfaces.examples import gallery
from pnsurfaces.examples_dialog import ExamplesDialog


# Until a dialog is drawn, in milliseconds.
_OPENING_TIME = 300


def shown_dialog(kind):
    """The open dialog of a class."""
    widgets = QtWidgets.QApplication.topLevelWidgets()
    return next(widget for widget in widgets if isinstance(widget, kind) and widget.isVisible())


class Examples(GuiTest):
    def run_gallery(self, act):
        """Runs the command and has act(dialog) done while the dialog is open."""

        def act_and_close():
            dialog = shown_dialog(ExamplesDialog)
            try:
                act(dialog)
            finally:
                if dialog.isVisible():
                    dialog.reject()

        QtCore.QTimer.singleShot(_OPENING_TIME, act_and_close)
        FreeCADGui.runCommand("PNSurfaces_Examples")
        main_window.settle()

    def test_every_example_has_a_picture(self):
        def look(dialog):
            main_window.screenshot("examples")
            for row in range(dialog.pictures.count()):
                self.assertFalse(dialog.pictures.item(row).icon().isNull())
            self.assertEqual(dialog.pictures.count(), len(gallery()))

        self.run_gallery(look)

    def test_cancel_makes_nothing(self):
        before = set(FreeCAD.listDocuments())
        self.run_gallery(lambda dialog: None)
        self.assertEqual(set(FreeCAD.listDocuments()), before)

    def test_arrow_keys_and_enter_open_an_example(self):
        def choose(dialog):
            dialog.pictures.setFocus()
            for key in (QtCore.Qt.Key_Right, QtCore.Qt.Key_Right, QtCore.Qt.Key_Return):
                main_window.press(dialog.pictures, key)

        since = len(main_window.recorded_commands())
        self.run_gallery(choose)
        reflector = FreeCAD.ActiveDocument
        self.assertEqual(reflector.Name, "Reflector")
        self.assertTrue(all(obj.isValid() for obj in reflector.Objects))
        main_window.screenshot("example_opened")
        script = main_window.recorded_commands()[since:]
        FreeCAD.closeDocument(reflector.Name)
        exec("\n".join(script), {"App": FreeCAD, "Gui": FreeCADGui})
        self.assertEqual(FreeCAD.ActiveDocument.Name, "Reflector")


class Pages(GuiTest):
    def test_links_lead_from_page_to_page_and_back(self):
        FreeCADGui.runCommand("PNSurfaces_Documentation")
        main_window.settle()
        window = shown_dialog(Documentation)
        self.addCleanup(window.close)
        self.assertIn("Documentation", window.pages.toPlainText())
        window.pages.setSource(QtCore.QUrl("canal_surface_command.md"))
        main_window.settle()
        self.assertIn("spine", window.pages.toPlainText())
        main_window.screenshot("documentation")
        window.pages.backward()
        self.assertIn("Documentation", window.pages.toPlainText())

    def test_every_command_says_what_it_is(self):
        for name in FreeCADGui.listCommands():
            if not name.startswith("PNSurfaces_"):
                continue
            with self.subTest(name):
                info = FreeCADGui.Command.get(name).getInfo()
                self.assertTrue(info["menuText"])
                self.assertTrue(info["toolTip"])
                self.assertTrue(info["statusTip"])
                self.assertIn(".md", info["whatsThis"])
