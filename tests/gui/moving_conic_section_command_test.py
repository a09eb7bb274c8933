# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Moving Conic Section and its task panel, driven as a person drives them."""

import FreeCADGui
import main_window
from FreeCAD import Vector
from creation import CreationTests
from support import GuiTest, input_of, poles, wait_for_preview

COMMAND = "PNSurfaces_MovingConicSection"


class SectionTest(GuiTest):
    def open(self, source=None):
        self.select(source or self.spline, "Edge1")
        return self.run_creation(COMMAND)


class CreationTest(CreationTests, SectionTest):
    feature_name = "MovingConicSection"
    undo_name = "Moving conic section"
    typed = {"HalfHeight": "1.25"}
    picture = "moving_conic_section"

    def test_an_upright_line_gets_another_direction_upwards(self):
        feature, _ = self.open(self.line)
        wait_for_preview()
        self.assertEqual(feature.Up, Vector(0, 1, 0))
        self.assertTrue(feature.isValid(), feature.getStatusString())

    def test_without_a_spine_it_asks_for_one(self):
        FreeCADGui.Selection.clearSelection()
        self.assert_asks(COMMAND, "Select the spine first: edges of one object, a wire or a sketch.")


class PanelTest(SectionTest):
    def setUp(self):
        super().setUp()
        self.feature, self.panel = self.open()
        wait_for_preview()

    def input(self, name):
        return input_of(self.panel, name)

    def test_there_are_no_distances(self):
        for name in ("Distance", "Sides", "regular_range"):
            self.assertFalse(self.input(name).isVisible(), name)
        self.assertTrue(self.input("no_offsets").isVisible())
        self.assertIn("no exact offsets", self.input("no_offsets").text())

    def test_linear_half_axes(self):
        self.assertFalse(self.input("EndHalfWidth").isVisible())
        self.input("SectionLaw").setCurrentText("Linear")
        self.assertTrue(self.input("EndHalfWidth").isVisible())
        before = poles(self.feature)
        main_window.type_text(self.input("EndHalfWidth"), "1.5")
        wait_for_preview()
        self.assertEqual(self.feature.EndHalfWidth.Value, 1.5)
        self.assertNotEqual(poles(self.feature), before)
        self.assertEqual(self.input("status").text(), "Valid")

    def test_a_table(self):
        self.input("SectionLaw").setCurrentText("Table")
        wait_for_preview()
        self.assertEqual(self.panel.table.rowCount(), 2)
        self.input("radii").setCurrentIndex(self.panel.table.index(0, 0))
        self.input("add_row").click()
        self.assertEqual(self.panel.table.rowCount(), 3)
        self.assertTrue(self.panel.table.setData(self.panel.table.index(1, 2), "6 mm"))
        wait_for_preview()
        self.assertIn(6, self.feature.HalfHeights)
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())
        main_window.screenshot("moving_conic_section_table")

    def test_expressions(self):
        self.input("SectionLaw").setCurrentText("Expression")
        self.input("HalfWidthExpression").setText("2 mm + s * 0.5 mm")
        self.input("HalfHeightExpression").setText("1 mm")
        wait_for_preview()
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())

    def test_from_the_vertex(self):
        self.assertFalse(self.input("ConicConstant").isVisible())
        self.input("Section").setCurrentText("From the vertex")
        self.input("Planes").setCurrentText("Parallel")
        self.assertFalse(self.input("HalfWidth").isVisible())
        self.assertFalse(self.input("EndDepth").isVisible())
        wait_for_preview()
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())
        half_width_squared = 2 * self.feature.Radius.Value * self.feature.Depth.Value
        self.assertAlmostEqual(half_width_squared, self.feature.HalfWidth.Value**2)
        for name, text in (("Radius", "12"), ("Depth", "8"), ("ConicConstant", "-1.125")):
            main_window.type_text(self.input(name), text)
        wait_for_preview()
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())
        self.assertEqual(self.feature.ConicConstant, -1.125)
        self.assertEqual(self.feature.Radius.Value, 12)
        main_window.screenshot("moving_conic_section_from_the_vertex")
        self.input("Output").setCurrentText("Solid")
        wait_for_preview()
        self.assertIn("enclose no solid", self.input("status").text())
        self.input("Output").setCurrentText("Surface")
        self.input("Section").setCurrentText("Ellipse")
        wait_for_preview()
        self.assertTrue(self.input("HalfWidth").isVisible())
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())

    def test_a_table_from_the_vertex_keeps_the_positions(self):
        self.input("Planes").setCurrentText("Parallel")
        self.input("SectionLaw").setCurrentText("Table")
        self.input("radii").setCurrentIndex(self.panel.table.index(0, 0))
        self.input("add_row").click()
        positions = list(self.feature.Positions)
        self.input("Section").setCurrentText("From the vertex")
        self.assertEqual(list(self.feature.Positions), positions)
        self.assertEqual(self.panel.table.columnCount(), 4)
        self.assertTrue(self.panel.table.setData(self.panel.table.index(1, 2), "-0.9"))
        wait_for_preview()
        self.assertEqual(list(self.feature.ConicConstants), [-1, -0.9, -1])
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())
        main_window.screenshot("moving_conic_section_vertex_table")

    def test_parallel_sections(self):
        self.assertFalse(self.input("normal").isVisible())
        self.input("Planes").setCurrentText("Parallel")
        wait_for_preview()
        self.assertTrue(self.input("normal").isVisible())
        self.assertTrue(self.panel.normal.setData(self.panel.normal.index(0, 1), "0.25"))
        wait_for_preview()
        self.assertEqual(self.feature.Normal, Vector(1, 0.25, 0))
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())

    def test_a_solid(self):
        self.input("Output").setCurrentText("Solid")
        wait_for_preview()
        self.assertEqual(self.feature.Shape.ShapeType, "Solid")

    def test_an_error_is_a_sentence_and_recovers(self):
        main_window.type_text(self.input("HalfWidth"), "0")
        wait_for_preview()
        self.assertIn("The half-axis to the side is zero", self.input("status").text())
        main_window.type_text(self.input("HalfWidth"), "2")
        wait_for_preview()
        self.assertTrue(self.feature.isValid())

    def test_another_spine(self):
        self.select(self.line, "Edge1")
        self.assertTrue(self.panel.up.setData(self.panel.up.index(0, 1), "1"))
        self.input("use_selection").click()
        wait_for_preview()
        self.assertEqual(self.feature.Spine[0], self.line)
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())

    def test_edit_and_cancel(self):
        main_window.confirm(self.panel)
        before = poles(self.feature)
        panel = self.reopen_panel(self.feature)
        main_window.type_text(input_of(panel, "HalfWidth"), "3")
        wait_for_preview()
        main_window.cancel(panel)
        self.assertEqual(poles(self.feature), before)
