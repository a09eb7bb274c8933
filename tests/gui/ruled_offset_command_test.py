# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Ruled surface offset and its task panel, driven as a person drives them."""

import FreeCADGui
import main_window
import Part
from FreeCAD import Vector
from creation import CreationTests
from support import GuiTest, input_of, make_wall, poles, wait_for_preview

COMMAND = "PNSurfaces_RuledOffset"
QUESTION = "Select two edges, wires or sketches first, or one ruled face."


class RuledOffsetTest(GuiTest):
    def setUp(self):
        super().setUp()
        self.rail = self.shape_object(Part.makeLine(Vector(60, 0, 0), Vector(60, 30, 100)), "Rail")
        self.document.recompute()
        self.document.clearUndos()

    def open_ruled_panel(self, *selected):
        FreeCADGui.Selection.clearSelection()
        for source, name in selected:
            FreeCADGui.Selection.addSelection(source, name)
        return self.run_creation(COMMAND)

    def ruled_object(self):
        edges = self.line.Shape.Edges[0], self.rail.Shape.Edges[0]
        return self.shape_object(Part.makeRuledSurface(*edges), "Ruled")

    def open_between_lines(self):
        return self.open_ruled_panel((self.line, "Edge1"), (self.rail, "Edge1"))


class CreationTest(CreationTests, RuledOffsetTest):
    feature_name = "RuledOffset"
    undo_name = "Ruled surface offset"
    typed = {"Distance": "4.5"}
    picture = "ruled_offset"

    def open(self):
        return self.open_between_lines()

    def enter(self, panel):
        super().enter(panel)
        input_of(panel, "Sides").setCurrentText("Base and offset")

    def test_wall_between_splines_of_different_degrees_and_knots(self):
        curve = Part.BSplineCurve()
        poles = [Vector(-10, 30, 70), Vector(40, 50, 90), Vector(80, 10, 80), Vector(120, 80, 90)]
        curve.buildFromPolesMultsKnots(poles, [3, 1, 3], [0.0, 0.3, 1.0], False, 2)
        upper = self.shape_object(curve.toShape(), "Upper")
        feature, panel = self.open_ruled_panel((self.spline, "Edge1"), (upper, "Edge1"))
        make_wall(panel, "2.5", "Both sides")
        self.line.ViewObject.hide()
        self.rail.ViewObject.hide()
        main_window.screenshot("ruled_wall")
        self.assertEqual(input_of(panel, "status").text(), "Valid")
        self.assertEqual(feature.Shape.ShapeType, "Solid")
        main_window.confirm(panel)

    def test_it_asks_for_curves(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        for selected in ([], [(self.line, "Edge1")], [(box, "Vertex1"), (self.line, "Edge1")]):
            FreeCADGui.Selection.clearSelection()
            for source, name in selected:
                FreeCADGui.Selection.addSelection(source, name)
            self.assert_asks(COMMAND, QUESTION)

    def test_two_edges_of_one_object(self):
        rails = self.shape_object(Part.Compound([self.line.Shape, self.rail.Shape]), "Rails")
        feature, panel = self.open_ruled_panel((rails, "Edge1"), (rails, "Edge2"))
        self.assertEqual(feature.CurveA, (rails, ["Edge1"]))
        self.assertEqual(feature.CurveB, (rails, ["Edge2"]))
        self.assertTrue(feature.isValid(), feature.getStatusString())
        main_window.cancel(panel)

    def test_curves_that_run_apart_are_turned(self):
        back = self.shape_object(Part.makeLine(Vector(60, 30, 100), Vector(60, 0, 0)), "Back")
        feature, panel = self.open_ruled_panel((self.line, "Edge1"), (back, "Edge1"))
        self.assertTrue(feature.Reversed)
        self.assertTrue(input_of(panel, "Reversed").isChecked())
        main_window.cancel(panel)

    def test_a_ruled_face(self):
        ruled = self.ruled_object()
        feature, panel = self.open_ruled_panel((ruled, "Face1"))
        self.assertEqual(feature.Face, (ruled, ["Face1"]))
        self.assertIn("degree 1, spans 1", input_of(panel, "source").text())
        self.assertTrue(feature.isValid(), feature.getStatusString())
        main_window.confirm(panel)

    def test_recorded_commands_make_the_same_surface(self):
        before = len(main_window.recorded_commands())
        feature, panel = self.open_between_lines()
        input_of(panel, "Reversed").click()
        main_window.type_text(input_of(panel, "Distance"), "1.5")
        wait_for_preview()
        main_window.confirm(panel)
        self.assertTrue(feature.Reversed)
        self.assert_recorded(before, feature, poles(feature))


class PanelTest(RuledOffsetTest):
    def test_curves_are_recognised(self):
        _, panel = self.open_ruled_panel((self.line, "Edge1"), (self.spline, "Edge1"))
        text = input_of(panel, "source").text()
        for part in ("Line, Edge1", "Spline, Edge1", "degree 1, spans 1", "degree 3, spans 4"):
            self.assertIn(part, text)

    def test_selection_replaces_the_curves(self):
        other = self.shape_object(Part.makeLine(Vector(0, 60, 0), Vector(20, 50, 90)), "Other")
        feature, panel = self.open_between_lines()
        before = poles(feature)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.line, "Edge1")
        FreeCADGui.Selection.addSelection(other, "Edge1")
        input_of(panel, "use_selection").click()
        wait_for_preview()
        self.assertEqual(feature.CurveB, (other, ["Edge1"]))
        self.assertNotEqual(poles(feature), before)
        FreeCADGui.Selection.clearSelection()
        input_of(panel, "use_selection").click()
        self.assertIn("Select two edges", input_of(panel, "source").text())
        self.assertEqual(feature.CurveB, (other, ["Edge1"]))

    def test_a_face_replaces_the_curves_and_back(self):
        ruled = self.ruled_object()
        feature, panel = self.open_between_lines()
        self.select(ruled, "Face1")
        input_of(panel, "use_selection").click()
        self.assertEqual((feature.Face, feature.CurveA), ((ruled, ["Face1"]), None))
        FreeCADGui.Selection.clearSelection()
        for source in (self.line, self.rail):
            FreeCADGui.Selection.addSelection(source, "Edge1")
        input_of(panel, "use_selection").click()
        wait_for_preview()
        self.assertIsNone(feature.Face)
        self.assertTrue(feature.isValid(), feature.getStatusString())

    def test_error_is_a_sentence_and_ok_waits(self):
        ball = self.document.addObject("Part::Sphere", "Ball")
        self.document.recompute()
        feature, panel = self.open_between_lines()
        good = poles(feature)
        self.select(ball, "Face1")
        input_of(panel, "use_selection").click()
        wait_for_preview()
        self.assertFalse(feature.isValid())
        self.assertIn("not ruled", input_of(panel, "status").text())
        self.assertEqual(poles(feature), good)
        main_window.confirm(panel)
        self.assertTrue(FreeCADGui.Control.activeDialog())

    def test_edit_and_cancel_restores_everything(self):
        feature, panel = self.open_between_lines()
        main_window.confirm(panel)
        self.document.clearUndos()
        before = poles(feature)
        panel = self.reopen_panel(feature)
        input_of(panel, "Reversed").click()
        main_window.type_text(input_of(panel, "Distance"), "3")
        wait_for_preview()
        self.assertNotEqual(poles(feature), before)
        main_window.cancel(panel)
        self.assertFalse(feature.Reversed)
        self.assertEqual(poles(feature), before)
        self.assertNotIn("Touched", feature.State)
        self.assertEqual(self.document.UndoCount, 0)
