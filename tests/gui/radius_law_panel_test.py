# SPDX-License-Identifier: LGPL-2.1-or-later
"""Radius laws and hollow pipes in the task panel of a canal surface, typed and pasted."""

import main_window
import Part
from FreeCAD import Vector
from support import GuiTest, input_of, poles, wait_for_preview

from pnsurfaces.compat import QtWidgets


class LawTest(GuiTest):
    def open_law(self, law, spine=None):
        feature, panel = self.open_panel(spine or self.line, "Edge1")
        input_of(panel, "RadiusLaw").setCurrentText(law)
        return feature, panel

    def assert_valid(self, feature):
        wait_for_preview()
        self.assertTrue(feature.isValid(), feature.getStatusString())


class TablePanel(LawTest):
    def setUp(self):
        super().setUp()
        self.feature, self.panel = self.open_law("Table")
        input_of(self.panel, "PositionBy").setCurrentText("Arc length")

    def type_cell(self, row, column, text):
        return self.panel.table.setData(self.panel.table.index(row, column), text)

    def select_row(self, row):
        input_of(self.panel, "radii").setCurrentIndex(self.panel.table.index(row, 0))

    def paste(self, text, button=True):
        QtWidgets.QApplication.clipboard().setText(text)
        if button:
            input_of(self.panel, "paste_rows").click()
        else:
            self.panel._paste_key.activated.emit()

    def test_a_new_table_spans_the_spine(self):
        radius = self.feature.Radius.Value
        self.assertEqual(self.feature.Positions, [0, 100])
        self.assertEqual(self.feature.Radii, [radius, radius])
        self.assert_valid(self.feature)
        self.assert_radius(self.feature, radius)

    def test_rows_are_typed_added_and_removed(self):
        self.select_row(0)
        input_of(self.panel, "add_row").click()
        self.assertEqual(self.feature.Positions, [0, 50, 100])
        self.assertTrue(self.type_cell(1, 0, "1 in"))
        self.assertTrue(self.type_cell(1, 1, "8"))
        self.assertFalse(self.type_cell(1, 1, "wide"))
        self.assert_valid(self.feature)
        self.assertEqual(self.feature.Positions, [0, 25.4, 100])
        self.assertEqual(self.feature.Radii, [5, 8, 5])
        main_window.screenshot("table")
        self.select_row(0)
        input_of(self.panel, "remove_row").click()
        self.assertEqual(self.feature.Positions, [25.4, 100])
        for _ in range(3):
            input_of(self.panel, "remove_row").click()
        self.assertEqual(len(self.feature.Positions), 1)
        self.assert_valid(self.feature)

    def test_rows_come_from_a_spreadsheet(self):
        self.paste("Position\tRadius\n0\t4\n40 mm\t6.5\n100\t1 cm\n")
        self.assert_valid(self.feature)
        self.assertEqual(self.feature.Positions, [0, 40, 100])
        self.assertEqual(self.feature.Radii, [4, 6.5, 10])
        self.select_row(1)
        self.paste("50\t7\n", button=False)
        self.assertEqual(self.feature.Positions, [0, 50, 100])
        self.assertEqual(self.feature.Radii, [4, 7, 10])
        for text in ("0\tfour\n1\tfive", "1\n2\n3", ""):
            self.paste(text)
            self.assertEqual(self.feature.Radii, [4, 7, 10])
        self.paste("0\tfour\n1\tfive")
        self.assertIn("2 columns of numbers", input_of(self.panel, "status").text())

    def test_another_measure_keeps_the_places(self):
        self.paste("0\t4\n40\t6\n100\t5\n")
        input_of(self.panel, "PositionBy").setCurrentText("Relative length")
        self.assertEqual(self.feature.Positions, [0, 0.4, 1])
        self.assert_valid(self.feature)

    def test_recorded_commands_make_the_same_surface(self):
        self.panel.reject()
        main_window.settle()
        before = len(main_window.recorded_commands())
        feature, self.panel = self.open_law("Table")
        self.paste("0\t4\n0.4\t6\n1\t5\n")
        self.assert_valid(feature)
        main_window.confirm(self.panel)
        self.assert_recorded(before, feature, poles(feature))


class ExpressionPanel(LawTest):
    def test_a_formula_is_typed(self):
        feature, panel = self.open_law("Expression")
        formula = input_of(panel, "RadiusExpression")
        self.assertFalse(input_of(panel, "Radius").isVisible())
        main_window.type_text(formula, "6 mm + 3 mm * sin(2*pi*s)")
        self.assert_valid(feature)
        self.assertEqual(feature.RadiusExpression, "6 mm + 3 mm * sin(2*pi*s)")
        self.assertIn("Fitted within", input_of(panel, "status").text())
        shown = input_of(panel, "FitTolerance").property("rawValue")
        self.assertAlmostEqual(shown, feature.FitTolerance.Value, delta=1e-12)
        main_window.screenshot("expression")
        main_window.type_text(formula, "1 mm / s")
        wait_for_preview()
        self.assertIn("at position 0", input_of(panel, "status").text())
        self.assertFalse(main_window.report_view_is_open())


class ProfilePanel(LawTest):
    def test_an_edge_is_chosen(self):
        arc = Part.Arc(Vector(20, 0, -10), Vector(8, 0, 50), Vector(20, 0, 110))
        profile = self.shape_object(arc.toShape(), "Profile")
        feature, panel = self.open_law("Profile")
        wait_for_preview()
        self.assertIn("The profile is missing", input_of(panel, "status").text())
        self.select(profile, "Edge1")
        input_of(panel, "use_profile").click()
        self.assert_valid(feature)
        self.assertEqual(feature.Profile, (profile, ["Edge1"]))
        self.assertIn("Profile", input_of(panel, "profile").text())
        main_window.screenshot("profile")

    def test_the_surface_itself_is_no_profile(self):
        feature, panel = self.open_law("Profile")
        self.select(feature, "Edge1")
        input_of(panel, "use_profile").click()
        self.assertIn("made from this surface", input_of(panel, "profile").text())
        self.assertIsNone(feature.Profile)


class HollowPanel(LawTest):
    def test_wall_and_bore(self):
        feature, panel = self.open_law("Constant", self.spline)
        input_of(panel, "Output").setCurrentText("Solid")
        input_of(panel, "Hollow").setCurrentText("Wall thickness")
        self.assertTrue(input_of(panel, "WallThickness").isVisible())
        self.assertFalse(input_of(panel, "InnerRadius").isVisible())
        main_window.type_text(input_of(panel, "WallThickness"), "1.5")
        self.assert_valid(feature)
        self.assertEqual(len(feature.Shape.Solids), 1)
        main_window.screenshot("hollow_pipe")
        input_of(panel, "Hollow").setCurrentText("Inner radius")
        main_window.type_text(input_of(panel, "InnerRadius"), "2.5")
        self.assert_valid(feature)
        self.assertEqual(feature.InnerRadius.Value, 2.5)

    def test_helix(self):
        helix = self.document.addObject("Part::Helix", "Helix")
        helix.Pitch, helix.Height, helix.Radius = 30, 90, 40
        self.document.recompute()
        feature, panel = self.open_panel(helix)
        main_window.type_text(input_of(panel, "Radius"), "6")
        self.assert_valid(feature)
        self.assertTrue(input_of(panel, "FitTolerance").isVisible())
        self.assertIn("proven", input_of(panel, "status").text())
        main_window.screenshot("helix")
