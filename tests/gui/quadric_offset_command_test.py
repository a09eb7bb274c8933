# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Quadric offset and its task panel, driven as a person drives them."""

import FreeCADGui
import main_window
import Part
from FreeCAD import Matrix
from creation import CreationTests
from support import GuiTest, input_of, make_wall, poles, wait_for_preview

from pnsurfaces.quadric_offset import KINDS

# In pixels: the results of a quadric's panel are then out of view.
LOW_WINDOW = 560

COMMAND = "PNSurfaces_QuadricOffset"


class QuadricOffsetTest(GuiTest):
    def open_quadric_panel(self):
        FreeCADGui.Selection.clearSelection()
        return self.run_creation(COMMAND)

    def egg(self):
        """An ellipsoid as FreeCAD makes one: a scaled sphere."""
        matrix = Matrix()
        matrix.scale(2, 1, 0.75)
        egg = self.shape_object(Part.makeSphere(20).transformGeometry(matrix), "Egg")
        self.document.recompute()
        self.document.clearUndos()
        return egg


class CreationTest(CreationTests, QuadricOffsetTest):
    feature_name = "QuadricOffset"
    undo_name = "Quadric offset"
    typed = {"HalfAxisA": "50", "Distance": "-2.5"}
    picture = "quadric_offset"

    def open(self):
        return self.open_quadric_panel()

    def test_wall_of_a_sector(self):
        feature, panel = self.open_quadric_panel()
        input_of(panel, "Region").setCurrentText("Sector")
        main_window.type_text(input_of(panel, "MaxAngle"), "250")
        make_wall(panel, "2", "Base and offset")
        for curve in (self.line, self.spline):
            curve.ViewObject.hide()
        main_window.screenshot("quadric_wall")
        self.assertEqual(input_of(panel, "status").text(), "Valid")
        self.assertEqual(feature.Shape.ShapeType, "Solid")
        main_window.confirm(panel)

    def test_a_selected_face(self):
        self.select(self.egg(), "Face1")
        feature, panel = self.run_creation(COMMAND)
        self.assertEqual(feature.Kind, "Of a face")
        self.assertIn("Ellipsoid with a = 40 mm, b = 20 mm, c = 15 mm", input_of(panel, "face").text())
        self.assertFalse(input_of(panel, "HalfAxisA").isVisible())
        main_window.type_text(input_of(panel, "Distance"), "2")
        wait_for_preview()
        self.assertTrue(feature.isValid(), feature.getStatusString())
        main_window.screenshot("quadric_of_a_face")
        main_window.confirm(panel)

    def test_recorded_commands_make_the_same_surface(self):
        before = len(main_window.recorded_commands())
        feature, panel = self.open_quadric_panel()
        input_of(panel, "Kind").setCurrentText("Elliptic paraboloid")
        input_of(panel, "Region").setCurrentText("Heights")
        main_window.type_text(input_of(panel, "MinZ"), "0")
        main_window.type_text(input_of(panel, "MaxZ"), "30")
        main_window.type_text(input_of(panel, "Distance"), "1.5")
        wait_for_preview()
        self.assertTrue(feature.isValid(), feature.getStatusString())
        main_window.confirm(panel)
        self.assert_recorded(before, feature, poles(feature))


class PanelTest(QuadricOffsetTest):
    def assert_visible(self, panel, *names):
        every = (
            "HalfAxisA",
            "HalfAxisB",
            "HalfAxisC",
            "Region",
            "MinX",
            "MinY",
            "MaxZ",
            "MinAngle",
            "equation",
            "face",
            "use_selection",
        )
        visible = {name for name in every if input_of(panel, name).isVisible()}
        self.assertEqual(visible, set(names))

    def test_only_the_inputs_of_kind_and_region_are_shown(self):
        _, panel = self.open_quadric_panel()
        axes = ("HalfAxisA", "HalfAxisB", "HalfAxisC")
        self.assert_visible(panel, *axes, "Region", "equation")
        input_of(panel, "Region").setCurrentText("Sector")
        self.assert_visible(panel, *axes, "Region", "equation", "MaxZ", "MinAngle")
        input_of(panel, "Kind").setCurrentText("Parabolic cylinder")
        input_of(panel, "Region").setCurrentText("Rectangle")
        self.assert_visible(panel, "HalfAxisA", "HalfAxisC", "Region", "equation", "MinX", "MinY")
        self.assertEqual(input_of(panel, "equation").text(), "z = c x²/a²")
        main_window.screenshot("quadric_rectangle")
        input_of(panel, "Kind").setCurrentText("Of a face")
        self.assert_visible(panel, "face", "use_selection")

    def test_every_kind_begins_with_a_surface(self):
        """Its region is offered, its bounds are in proportion, and no log says a word."""
        feature, panel = self.open_quadric_panel()
        regions = input_of(panel, "Region")
        for kind in KINDS:
            with self.subTest(kind):
                input_of(panel, "Kind").setCurrentText(kind)
                wait_for_preview()
                self.assertEqual(input_of(panel, "status").text(), "Valid")
                offered = [regions.itemText(i) for i in range(regions.count())]
                self.assertEqual(offered, list(KINDS[kind].regions))
                self.assertEqual(regions.currentText(), feature.Region)
                self.assertEqual(input_of(panel, "MaxZ").property("value").Value, feature.MaxZ.Value)

    def test_a_sentence_comes_into_view_in_a_low_window(self):
        _, panel = self.open_quadric_panel()
        window = FreeCADGui.getMainWindow()
        window.resize(window.width(), LOW_WINDOW)
        main_window.settle()
        status = input_of(panel, "status")
        self.assertTrue(status.visibleRegion().isEmpty())
        main_window.type_text(input_of(panel, "HalfAxisB"), "0")
        wait_for_preview()
        self.assertFalse(status.visibleRegion().isEmpty())
        self.assertNotIn("Traceback", main_window.status_bar_text())

    def test_an_angle_is_typed_in_degrees(self):
        feature, panel = self.open_quadric_panel()
        input_of(panel, "Region").setCurrentText("Sector")
        main_window.type_text(input_of(panel, "MaxAngle"), "90")
        self.assertEqual(feature.MaxAngle.Value, 90)

    def test_selection_gives_the_face(self):
        egg = self.egg()
        feature, panel = self.open_quadric_panel()
        input_of(panel, "Kind").setCurrentText("Of a face")
        wait_for_preview()
        self.assertIn("The face is missing.", input_of(panel, "status").text())
        FreeCADGui.Selection.clearSelection()
        input_of(panel, "use_selection").click()
        self.assertEqual(input_of(panel, "face").text(), "Select one face.")
        self.select(egg)
        input_of(panel, "use_selection").click()
        wait_for_preview()
        self.assertEqual(feature.Face, (egg, ["Face1"]))
        self.assertEqual(input_of(panel, "status").text(), "Valid")
        self.assertIn("away from the face", input_of(panel, "face").text())

    def test_error_is_a_sentence_and_recovers(self):
        feature, panel = self.open_quadric_panel()
        good = poles(feature)
        main_window.type_text(input_of(panel, "HalfAxisB"), "0")
        wait_for_preview()
        self.assertFalse(feature.isValid())
        self.assertEqual(input_of(panel, "status").text(), f"Error: {feature.getStatusString()}")
        self.assertEqual(poles(feature), good)
        main_window.confirm(panel)
        self.assertTrue(FreeCADGui.Control.activeDialog())
        main_window.type_text(input_of(panel, "HalfAxisB"), "30")
        wait_for_preview()
        self.assertEqual(input_of(panel, "status").text(), "Valid")
        self.assertEqual(poles(feature), good)

    def test_beyond_the_limit_it_warns(self):
        feature, panel = self.open_quadric_panel()
        main_window.type_text(input_of(panel, "Distance"), "-25")
        wait_for_preview()
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertRegex(input_of(panel, "status").text(), "^Warning: .*beyond the limit")

    def test_expression(self):
        feature, panel = self.open_quadric_panel()
        feature.setExpression("HalfAxisA", "2 * HalfAxisB")
        wait_for_preview()
        main_window.confirm(panel)
        self.assertEqual(feature.HalfAxisA.Value, 2 * feature.HalfAxisB.Value)

    def test_edit_and_cancel_restores_everything(self):
        feature, panel = self.open_quadric_panel()
        main_window.confirm(panel)
        self.document.clearUndos()
        before = poles(feature)
        panel = self.reopen_panel(feature)
        input_of(panel, "Kind").setCurrentText("One-sheet hyperboloid")
        self.assertEqual(feature.Region, "Heights")
        wait_for_preview()
        self.assertTrue(feature.isValid(), feature.getStatusString())
        self.assertNotEqual(poles(feature), before)
        main_window.cancel(panel)
        self.assertEqual((feature.Kind, feature.Region), ("Ellipsoid", "Whole"))
        self.assertEqual(poles(feature), before)
        self.assertNotIn("Touched", feature.State)
        self.assertEqual(self.document.UndoCount, 0)


class TreeTest(QuadricOffsetTest):
    def test_sources_are_children(self):
        egg = self.egg()
        self.select(egg, "Face1")
        feature, panel = self.run_creation(COMMAND)
        main_window.confirm(panel)
        self.assertEqual(feature.ViewObject.Proxy.claimChildren(), [egg])
