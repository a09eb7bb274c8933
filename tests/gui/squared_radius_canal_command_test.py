# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Canal Surface from r² and its task panel, driven as a person drives them."""

import FreeCADGui
import main_window
from creation import CreationTests
from support import GuiTest, input_of, poles, wait_for_preview

COMMAND = "PNSurfaces_SquaredRadiusCanal"


class SquaredRadiusTest(GuiTest):
    def open(self):
        self.select(self.spline, "Edge1")
        return self.run_creation(COMMAND)


class CreationTest(CreationTests, SquaredRadiusTest):
    feature_name = "CanalSurfaceFromSquaredRadius"
    undo_name = "Canal surface from r²"
    typed = {"SquaredRadius": "1.25"}
    picture = "squared_radius_canal"

    def test_without_a_spine_it_asks_for_one(self):
        FreeCADGui.Selection.clearSelection()
        self.assert_asks(COMMAND, "Select the spine first: edges of one object, a wire or a sketch.")


class PanelTest(SquaredRadiusTest):
    def setUp(self):
        super().setUp()
        self.feature, self.panel = self.open()
        wait_for_preview()

    def input(self, name):
        return input_of(self.panel, name)

    def test_a_linear_law(self):
        self.assertFalse(self.input("EndSquaredRadius").isVisible())
        self.input("SquaredRadiusLaw").setCurrentText("Linear")
        self.assertTrue(self.input("EndSquaredRadius").isVisible())
        before = poles(self.feature)
        main_window.type_text(self.input("EndSquaredRadius"), "1.5")
        wait_for_preview()
        self.assertEqual(self.feature.EndSquaredRadius.Value, 1.5)
        self.assertNotEqual(poles(self.feature), before)
        self.assertEqual(self.input("status").text(), "Valid")

    def test_a_table(self):
        self.input("SquaredRadiusLaw").setCurrentText("Table")
        wait_for_preview()
        self.assertEqual(self.panel.table.rowCount(), 2)
        self.input("radii").setCurrentIndex(self.panel.table.index(0, 0))
        self.input("add_row").click()
        self.assertEqual(self.panel.table.rowCount(), 3)
        cell = self.panel.table.index(1, 1)
        self.assertFalse(self.panel.table.setData(cell, "2 mm"))
        self.assertTrue(self.panel.table.setData(cell, "0.015 cm^2"))
        wait_for_preview()
        self.assertEqual(self.feature.SquaredRadii[1], 1.5)
        self.assertIn("mm", self.panel.table.data(cell))
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())
        main_window.screenshot("squared_radius_canal_table")

    def test_bezier_coefficients(self):
        self.input("SquaredRadiusLaw").setCurrentText("Bezier coefficients")
        wait_for_preview()
        self.assertEqual(self.panel.table.columnCount(), 1)
        self.assertEqual(self.feature.SquaredRadii, [self.feature.SquaredRadius.Value] * 2)
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())

    def test_an_expression(self):
        self.input("SquaredRadiusLaw").setCurrentText("Expression")
        self.assertTrue(self.input("FitTolerance").isVisible())
        self.input("SquaredRadiusExpression").setText("1 mm^2 + s * 0.5 mm^2")
        wait_for_preview()
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())
        self.input("SquaredRadiusExpression").setText("1 mm")
        wait_for_preview()
        self.assertIn("not an area", self.input("status").text())

    def test_a_distance_needs_a_rational_radius(self):
        self.assertIn("where the radius itself is rational", self.input("about_offsets").text())
        main_window.type_text(self.input("SquaredRadius"), "2")
        wait_for_preview()
        for shown in (self.panel.limits, self.input("regular_range")):
            self.assertFalse(shown.isVisible())
        main_window.type_text(self.input("Distance"), "0.25")
        wait_for_preview()
        self.assertIn("not rational", self.input("status").text())
        main_window.screenshot("squared_radius_canal_refusal")
        main_window.type_text(self.input("SquaredRadius"), "2.25")
        wait_for_preview()
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())
        self.assertEqual(self.input("status").text(), "Valid")
        for shown in (self.panel.limits, self.input("regular_range")):
            self.assertTrue(shown.isVisible())

    def test_a_solid(self):
        self.input("Output").setCurrentText("Solid")
        wait_for_preview()
        self.assertEqual(self.feature.Shape.ShapeType, "Solid")

    def test_another_spine(self):
        self.select(self.line, "Edge1")
        self.input("use_selection").click()
        wait_for_preview()
        self.assertEqual(self.feature.Spine[0], self.line)
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())

    def test_edit_and_cancel(self):
        main_window.confirm(self.panel)
        before = poles(self.feature)
        panel = self.reopen_panel(self.feature)
        main_window.type_text(input_of(panel, "SquaredRadius"), "1.75")
        wait_for_preview()
        main_window.cancel(panel)
        self.assertEqual(poles(self.feature), before)
