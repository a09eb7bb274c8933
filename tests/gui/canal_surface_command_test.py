# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Canal surface and its task panel, driven as a person drives them."""

import gc
import os
import tempfile
import weakref
from unittest import mock

import FreeCAD
import FreeCADGui
import main_window
import Part
from FreeCAD import Vector
from creation import CreationTests
from support import GuiTest, input_of, make_wall, poles, wait_for_preview

from pnsurfaces import kernel


# A closed spine with corners, in millimetres.
SQUARE = [(0, 0, 0), (80, 0, 0), (80, 80, 0), (0, 80, 0), (0, 0, 0)]

# An end radius, in millimetres, to which the radius changes faster than Line advances.
TOO_WIDE = "500"


class CreationTest(CreationTests, GuiTest):
    feature_name = "CanalSurface"
    undo_name = "Canal surface"
    typed = {"EndRadius": "9.5", "Distance": "-1.25"}
    picture = "canal_surface"

    def open(self):
        return self.open_panel(self.spline, "Edge1")

    def enter(self, panel):
        input_of(panel, "RadiusLaw").setCurrentText("Linear")
        super().enter(panel)

    def test_closed_panel_is_forgotten(self):
        _, panel = self.open_panel(self.spline, "Edge1")
        parts = [panel, panel.table]
        parts += [input_of(panel, name) for name in ("RadiusLaw", "Radius", "use_selection")]
        forgotten = [weakref.ref(part) for part in parts]
        main_window.cancel(panel)
        del panel, parts
        gc.collect()
        self.assertEqual([reference() for reference in forgotten], [None] * len(forgotten))

    def test_undo_while_the_panel_is_open_takes_the_surface_back(self):
        _, panel = self.open_panel(self.spline, "Edge1")
        main_window.type_text(input_of(panel, "Distance"), "2")
        self.document.undo()
        wait_for_preview()
        self.assert_nothing_open()
        self.assertEqual(self.document.Objects, [self.line, self.spline])

    def test_without_spine_it_asks_for_one(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        objects = self.document.Objects
        for select in (
            FreeCADGui.Selection.clearSelection,
            lambda: self.select(box, "Face1"),
            lambda: FreeCADGui.Selection.addSelection(self.line, "Edge1"),
        ):
            select()
            answers = []
            main_window.answer_message_box(answers)
            FreeCADGui.runCommand("PNSurfaces_CanalSurface")
            self.assertEqual(
                answers, ["Select the spine first: edges of one object, a wire or a sketch."]
            )
            self.assertEqual(self.document.Objects, objects)

    def test_without_kernel_it_says_how_to_install(self):
        sentence = "The PN Surfaces kernel is not built. Run scripts/build."
        self.select(self.spline, "Edge1")
        answers = []
        main_window.answer_message_box(answers)
        with mock.patch.object(kernel, "pnkernel", side_effect=kernel.KernelMissing(sentence)):
            FreeCADGui.runCommand("PNSurfaces_CanalSurface")
        self.assertEqual(answers, [sentence])
        self.assertEqual(self.document.Objects, [self.line, self.spline])

    def test_recorded_commands_make_the_same_surface(self):
        before = len(main_window.recorded_commands())
        feature, panel = self.open_panel(self.spline, "Edge1")
        input_of(panel, "RadiusLaw").setCurrentText("Values at vertices")
        panel.table.setData(panel.table.index(2, 0), "7 mm")
        feature.setExpression("Distance", "1 mm + 0.5 mm")
        wait_for_preview()
        main_window.confirm(panel)
        made, expressions = poles(feature), feature.ExpressionEngine
        self.assertEqual([path for path, _ in expressions], ["Distance"])
        script = main_window.recorded_commands()[before:]
        self.document.removeObject("CanalSurface")
        exec("\n".join(script), {"App": FreeCAD, "Gui": FreeCADGui})
        again = self.document.CanalSurface
        self.assertEqual(poles(again), made)
        self.assertEqual(again.ExpressionEngine, expressions)

    def test_closing_the_document_closes_the_panel(self):
        _, panel = self.open_panel(self.spline, "Edge1")
        main_window.type_text(input_of(panel, "Distance"), "2")
        FreeCAD.closeDocument(self.document.Name)
        wait_for_preview()
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertIsNone(FreeCAD.getActiveTransaction())


class EditingTest(GuiTest):
    def setUp(self):
        super().setUp()
        self.feature, panel = self.open_panel(self.line, "Edge1")
        main_window.confirm(panel)
        self.document.clearUndos()

    def test_ok_is_one_undo_step(self):
        radius = self.feature.Radius.Value
        panel = self.reopen_panel(self.feature)
        main_window.type_text(input_of(panel, "Distance"), "3")
        main_window.type_text(input_of(panel, "Radius"), "4.125")
        main_window.confirm(panel)
        self.assert_nothing_open()
        self.assertEqual(self.document.UndoNames, ["Edit CanalSurface"])
        self.assert_radius(self.feature, 7.125)
        self.document.undo()
        self.assertEqual(self.feature.Distance.Value, 0)
        self.assertEqual(self.feature.Radius.Value, radius)
        self.assert_radius(self.feature, radius)

    def test_cancel_restores_everything(self):
        before = poles(self.feature)
        panel = self.reopen_panel(self.feature)
        main_window.type_text(input_of(panel, "Distance"), "3")
        input_of(panel, "RadiusLaw").setCurrentText("Bezier coefficients")
        wait_for_preview()
        self.assertNotEqual(poles(self.feature), before)
        main_window.cancel(panel)
        self.assert_nothing_open()
        self.assertEqual(self.feature.Distance.Value, 0)
        self.assertEqual(self.feature.RadiusLaw, "Constant")
        self.assertEqual(self.feature.Radii, [])
        self.assertEqual(poles(self.feature), before)
        self.assertNotIn("Touched", self.feature.State)
        self.assertEqual(self.document.UndoCount, 0)

    def test_cancel_after_an_error_restores_a_valid_feature(self):
        panel = self.reopen_panel(self.feature)
        input_of(panel, "RadiusLaw").setCurrentText("Linear")
        main_window.type_text(input_of(panel, "EndRadius"), TOO_WIDE)
        wait_for_preview()
        self.assertFalse(self.feature.isValid())
        main_window.cancel(panel)
        self.assertTrue(self.feature.isValid())
        self.assertEqual(self.feature.Status, "Valid")
        self.assertNotIn("Touched", self.feature.State)

    def test_looking_changes_nothing(self):
        self.feature.Radius = 1.23456789
        self.document.recompute()
        self.document.clearUndos()
        panel = self.reopen_panel(self.feature)
        main_window.confirm(panel)
        self.assertEqual(self.feature.Radius.Value, 1.23456789)
        self.assertEqual(self.document.UndoCount, 0)

    def test_dependent_objects_follow_on_ok_only(self):
        follower = self.document.addObject("Part::Box", "Follower")
        follower.setExpression("Length", "CanalSurface.Distance + 1 mm")
        self.document.recompute()
        panel = self.reopen_panel(self.feature)
        main_window.type_text(input_of(panel, "Distance"), "3")
        wait_for_preview()
        self.assertEqual(follower.Length.Value, 1)
        main_window.confirm(panel)
        self.assertEqual(follower.Length.Value, 4)

    def test_preview_follows_typing_after_a_pause(self):
        panel = self.reopen_panel(self.feature)
        radius = self.feature.Radius.Value
        main_window.type_text(input_of(panel, "Distance"), "2.5")
        self.assert_radius(self.feature, radius)
        wait_for_preview()
        self.assert_radius(self.feature, radius + 2.5)
        self.assertEqual(input_of(panel, "Poles").text(), str(self.feature.Poles))

    def test_expression_in_the_panel(self):
        panel = self.reopen_panel(self.feature)
        self.feature.setExpression("Distance", "2 mm + 3 mm")
        wait_for_preview()
        self.assertEqual(input_of(panel, "Distance").property("rawValue"), 5)
        main_window.confirm(panel)
        self.assertEqual([path for path, _ in self.feature.ExpressionEngine], ["Distance"])
        self.assert_radius(self.feature, self.feature.Radius.Value + 5)

    def test_saved_document_can_be_edited(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = os.path.join(folder.name, "saved.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        main_window.settle()
        feature = self.document.CanalSurface
        before = poles(feature)
        panel = self.reopen_panel(feature)
        main_window.type_text(input_of(panel, "Distance"), "3")
        wait_for_preview()
        self.assertNotEqual(poles(feature), before)
        main_window.cancel(panel)
        self.assertEqual(poles(feature), before)

    def test_deleting_the_feature_closes_the_panel(self):
        panel = self.reopen_panel(self.feature)
        main_window.type_text(input_of(panel, "Distance"), "3")
        self.document.removeObject(self.feature.Name)
        wait_for_preview()
        self.assertFalse(FreeCADGui.Control.activeDialog())


class PanelTest(GuiTest):
    def test_spine_is_recognised(self):
        _, panel = self.open_panel(self.spline, "Edge1")
        self.assertIn("Degree 3, spans 4, vertices 5", input_of(panel, "spine").text())

    def test_selection_replaces_the_spine(self):
        feature, panel = self.open_panel(self.spline, "Edge1")
        self.select(self.line, "Edge1")
        input_of(panel, "use_selection").click()
        wait_for_preview()
        self.assertEqual(feature.Spine, (self.line, ["Edge1"]))
        self.assert_radius(feature, feature.Radius.Value)
        FreeCADGui.Selection.clearSelection()
        input_of(panel, "use_selection").click()
        self.assertIn("Select edges", input_of(panel, "spine").text())
        self.assertEqual(feature.Spine, (self.line, ["Edge1"]))

    def test_values_at_vertices(self):
        feature, panel = self.open_panel(self.spline, "Edge1")
        input_of(panel, "RadiusLaw").setCurrentText("Values at vertices")
        wait_for_preview()
        self.assertEqual(feature.Radii, [feature.Radius.Value] * 5)
        for row, text in enumerate(["5", "4 mm", "6.5", "1 cm", "12"]):
            self.assertTrue(panel.table.setData(panel.table.index(row, 0), text))
        wait_for_preview()
        self.assertEqual(feature.Radii, [5, 4, 6.5, 10, 12])
        self.assertTrue(feature.isValid(), feature.getStatusString())
        main_window.screenshot("values_at_vertices")
        for text in ("wide", "3 deg", ""):
            self.assertFalse(panel.table.setData(panel.table.index(0, 0), text))
        self.assertEqual(feature.Radii, [5, 4, 6.5, 10, 12])

    def test_closed_spine_has_its_first_vertex_once(self):
        wire = Part.makePolygon([Vector(*point) for point in SQUARE])
        square = self.document.addObject("Part::Feature", "Square")
        square.Shape = wire
        feature, panel = self.open_panel(square)
        self.assertIn("vertices 4, closed", input_of(panel, "spine").text())
        feature.Radii = [6, 8]
        input_of(panel, "RadiusLaw").setCurrentText("Values at vertices")
        self.assertEqual(panel.table.rowCount(), 4)
        wait_for_preview()
        self.assertEqual(feature.Radii, [6, 6.5, 7, 7.5, 6])
        self.assertTrue(feature.isValid(), feature.getStatusString())
        panel.table.setData(panel.table.index(0, 0), "12")
        wait_for_preview()
        self.assertEqual(feature.Radii, [12, 6.5, 7, 7.5, 12])
        self.assertTrue(feature.isValid(), feature.getStatusString())
        main_window.screenshot("closed_spine")

    def test_radii_are_shown_in_full_when_edited(self):
        feature, panel = self.open_panel(self.line, "Edge1")
        input_of(panel, "RadiusLaw").setCurrentText("Bezier coefficients")
        index = panel.table.index(0, 0)
        panel.table.setData(index, "1.23456789 mm")
        panel.table.setData(index, panel.table.data(index, main_window.EDIT_ROLE))
        self.assertEqual(feature.Radii[0], 1.23456789)

    def test_bezier_coefficients(self):
        feature, panel = self.open_panel(self.line, "Edge1")
        radius = feature.Radius.Value
        input_of(panel, "RadiusLaw").setCurrentText("Bezier coefficients")
        self.assertEqual(feature.Radii, [radius, radius])
        input_of(panel, "add_row").click()
        panel.table.setData(panel.table.index(2, 0), "9")
        wait_for_preview()
        self.assertEqual(feature.Radii, [radius, radius, 9])
        self.assertTrue(feature.isValid(), feature.getStatusString())
        main_window.screenshot("bezier_coefficients")
        for _ in range(3):
            input_of(panel, "remove_row").click()
        self.assertEqual(feature.Radii, [radius])

    def test_error_is_a_sentence_and_recovers(self):
        feature, panel = self.open_panel(self.line, "Edge1")
        good = poles(feature)
        input_of(panel, "RadiusLaw").setCurrentText("Linear")
        main_window.type_text(input_of(panel, "EndRadius"), TOO_WIDE)
        wait_for_preview()
        status = input_of(panel, "status")
        self.assertFalse(feature.isValid())
        self.assertEqual(status.text(), f"Error: {feature.getStatusString()}")
        self.assertIn("color", status.styleSheet())
        self.assertFalse(input_of(panel, "Degree").isEnabled())
        self.assertEqual(poles(feature), good)
        self.assertFalse(main_window.report_view_is_open())
        main_window.screenshot("error")
        main_window.confirm(panel)
        self.assertTrue(FreeCADGui.Control.activeDialog())
        main_window.type_text(input_of(panel, "EndRadius"), "2")
        wait_for_preview()
        self.assertEqual(status.text(), "Valid")
        self.assertEqual(status.styleSheet(), "")
        self.assertTrue(input_of(panel, "Degree").isEnabled())

    def test_error_reaches_the_tree(self):
        feature, panel = self.open_panel(self.line, "Edge1")
        main_window.confirm(panel)
        feature.RadiusLaw = "Linear"
        feature.EndRadius = float(TOO_WIDE)
        self.document.recompute()
        main_window.settle()
        self.assertIn(feature.getStatusString(), main_window.hover_in_tree(feature.Label))

    def test_distance_outside_the_regular_range_warns(self):
        feature, panel = self.open_panel(self.line, "Edge1")
        main_window.type_text(input_of(panel, "Radius"), "5")
        main_window.type_text(input_of(panel, "Distance"), "-7")
        wait_for_preview()
        self.assertTrue(feature.isValid())
        status = input_of(panel, "status")
        self.assertTrue(status.text().startswith("Warning: "), status.text())
        self.assertIn("color", status.styleSheet())
        self.assertEqual(input_of(panel, "regular_range").text(), "-5 to ∞ mm")
        main_window.screenshot("warning")

    def test_wall(self):
        feature, panel = self.open_panel(self.spline, "Edge1")
        input_of(panel, "RadiusLaw").setCurrentText("Linear")
        main_window.type_text(input_of(panel, "EndRadius"), "12")
        make_wall(panel, "1", "Both sides")
        self.assertTrue(feature.isValid(), feature.getStatusString())
        main_window.screenshot("wall")
        main_window.confirm(panel)
        main_window.screenshot("wall_in_tree")

    def test_caps_are_a_matter_of_solids(self):
        feature, panel = self.open_panel(self.spline, "Edge1")
        self.assertTrue(input_of(panel, "Caps").isHidden())
        input_of(panel, "Output").setCurrentText("Solid")
        self.assertFalse(input_of(panel, "Caps").isHidden())
        input_of(panel, "Caps").setCurrentText("Spherical")
        wait_for_preview()
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertEqual(input_of(panel, "Volume").text(), feature.Volume.UserString)
        main_window.screenshot("spherical_caps")
        main_window.confirm(panel)
        self.assertEqual((feature.Caps, len(feature.Shape.Faces)), ("Spherical", 3))

    def test_two_offsets(self):
        feature, panel = self.open_panel(self.spline, "Edge1")
        self.assertTrue(input_of(panel, "SecondDistance").isHidden())
        make_wall(panel, "1", "Two offsets")
        self.assertFalse(input_of(panel, "SecondDistance").isHidden())
        main_window.type_text(input_of(panel, "SecondDistance"), "0.25")
        main_window.confirm(panel)
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertEqual(feature.SecondDistance.Value, 0.25)
        self.assertEqual(feature.Shape.ShapeType, "Solid")
