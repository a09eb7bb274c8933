# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window in German."""

import FreeCADGui
import main_window
from support import GuiTest, input_of, wait_for_preview

from pnsurfaces.choice_names import CHOICES, shown_choice
from pnsurfaces.compat import QtWidgets


class German(GuiTest):
    def setUp(self):
        super().setUp()
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        main_window.settle()

    def test_panel(self):
        feature, panel = self.open_panel(self.spline, "Edge1")
        labels = [label.text() for form in panel.form for label in form.findChildren(QtWidgets.QLabel)]
        for text in ("Leitkurve", "Abstand", "Abweichung", "Kontrollpunkte"):
            self.assertIn(text, labels)
        sides = input_of(panel, "Sides")
        self.assertEqual(sides.currentText(), "Versatz")
        sides.setCurrentText("Beide Seiten")
        self.assertEqual(feature.Sides, "Both sides")
        self.assertEqual(input_of(panel, "Radius").toolTip(), "Radius, oder Radius am Anfang")
        wait_for_preview()
        main_window.screenshot("german_panel")
        main_window.cancel(panel)

    def test_quadric_panel(self):
        feature, panel = self.run_creation("PNSurfaces_QuadricOffset")
        kind = input_of(panel, "Kind")
        kind.setCurrentText("Elliptisches Paraboloid")
        self.assertEqual(feature.Kind, "Elliptic paraboloid")
        input_of(panel, "Region").setCurrentText("Höhen")
        self.assertEqual(feature.Region, "Heights")
        wait_for_preview()
        main_window.screenshot("german_quadric_panel")
        main_window.cancel(panel)

    def test_commands(self):
        menus = FreeCADGui.getMainWindow().menuBar().findChildren(QtWidgets.QMenu)
        texts = [action.text() for menu in menus for action in menu.actions()]
        self.assertIn("Versatz einer Regelfläche…", texts)

    def test_no_two_choices_of_one_box_have_one_name(self):
        names = [shown_choice(choice) for choice in CHOICES]
        self.assertEqual(len(set(names)), len(names))
