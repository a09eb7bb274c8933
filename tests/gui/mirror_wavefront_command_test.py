# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Mirror Wavefront and its task panel, driven as a person drives them."""

import FreeCADGui
import main_window
import Part
from FreeCAD import Vector
from creation import CreationTests
from support import GuiTest, input_of, poles, wait_for_preview

COMMAND = "PNSurfaces_MirrorWavefront"


def dish():
    surface = Part.BezierSurface()
    surface.increase(2, 2)
    for i in range(3):
        for j in range(3):
            z = 4 * ((i - 1) ** 2 + (j - 1) ** 2) - 4
            surface.setPole(i + 1, j + 1, Vector(50 * (i - 1), 50 * (j - 1), z))
    return surface.toShape()


class MirrorTest(GuiTest):
    def setUp(self):
        super().setUp()
        self.mirror = self.shape_object(dish(), "Mirror")
        self.document.clearUndos()

    def open(self):
        self.select(self.mirror, "Face1")
        return self.run_creation(COMMAND)


class CreationTest(CreationTests, MirrorTest):
    feature_name = "MirrorWavefront"
    undo_name = "Mirror wavefront"
    typed = {"Distance": "150"}
    picture = "mirror_wavefront"

    def test_the_selected_face_is_the_mirror(self):
        feature, _ = self.open()
        self.assertEqual(feature.Face, (self.mirror, ["Face1"]))

    def test_without_a_face_it_asks_for_one(self):
        FreeCADGui.Selection.clearSelection()
        self.assert_asks(COMMAND, "Select the mirror first: one face.")


class PanelTest(MirrorTest):
    def setUp(self):
        super().setUp()
        self.feature, self.panel = self.open()

    def type_in(self, table, column, text):
        self.assertTrue(table.setData(table.index(0, column), text))
        wait_for_preview()

    def test_a_typed_direction(self):
        before = poles(self.feature)
        self.type_in(self.panel.direction, 0, "0.3")
        self.assertAlmostEqual(self.feature.Direction.x, 0.3)
        self.assertNotEqual(poles(self.feature), before)

    def test_a_typed_origin(self):
        self.type_in(self.panel.origin, 2, "120 mm")
        self.assertEqual(self.feature.Origin.z, 120)

    def test_a_selected_vertex_is_the_origin_and_an_edge_the_direction(self):
        self.select(self.line, "Vertex2")
        input_of(self.panel, "use_selection").click()
        wait_for_preview()
        self.assertEqual(self.feature.Origin, Vector(0, 0, 100))
        self.select(self.line, "Edge1")
        input_of(self.panel, "use_selection").click()
        wait_for_preview()
        self.assertEqual(self.feature.Direction, Vector(0, 0, 1))

    def test_what_is_neither_is_explained(self):
        self.select(self.spline, "Edge1")
        input_of(self.panel, "use_selection").click()
        text = input_of(self.panel, "mirror").text()
        self.assertEqual(text, "Select one face, one straight edge or one vertex.")

    def test_light_from_a_point_has_no_direction(self):
        main_window.type_text(input_of(self.panel, "Distance"), "0")
        input_of(self.panel, "Light").setCurrentText("From a point")
        wait_for_preview()
        self.assertFalse(input_of(self.panel, "direction").isVisible())
        self.assertTrue(self.feature.isValid(), self.feature.getStatusString())
        self.assertIn("offsets are not", input_of(self.panel, "status").text())
        main_window.screenshot("mirror_wavefront_point")
        input_of(self.panel, "Light").setCurrentText("Parallel")
        wait_for_preview()
        self.assertTrue(input_of(self.panel, "direction").isVisible())
        self.assertTrue(self.feature.isValid())

    def test_an_error_is_a_sentence_and_recovers(self):
        self.type_in(self.panel.direction, 2, "0")
        self.assertIn("The light has no direction.", input_of(self.panel, "status").text())
        self.type_in(self.panel.direction, 2, "-1")
        self.assertTrue(self.feature.isValid())

    def test_edit(self):
        main_window.confirm(self.panel)
        before = self.feature.Distance.Value
        panel = self.reopen_panel(self.feature)
        main_window.type_text(input_of(panel, "Distance"), "140")
        wait_for_preview()
        main_window.cancel(panel)
        self.assertEqual(self.feature.Distance.Value, before)
