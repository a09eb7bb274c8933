# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Mid-Surface Skins and its task panel, driven as a person drives them."""

import FreeCADGui
import main_window
import Part
from FreeCAD import Vector
from creation import CreationTests
from support import GuiTest, input_of, wait_for_preview

COMMAND = "PNSurfaces_MidSurfaceSkins"
NET = [(0, 0, 0), (100, 0, 0), (40, 80, 0), (50, 0, 8), (70, 40, 10), (20, 40, 9)]


class MidSurfaceSkinsTest(GuiTest):
    def open(self):
        FreeCADGui.Selection.clearSelection()
        return self.run_creation(COMMAND)


class CreationTest(CreationTests, MidSurfaceSkinsTest):
    feature_name = "MidSurfaceSkins"
    undo_name = "Mid-surface skins"
    picture = "mid_surface_skins"

    def test_selected_vertices_are_the_net(self):
        net = self.shape_object(Part.Compound([Part.Vertex(Vector(*p)) for p in NET]), "Net")
        self.select(net, *(f"Vertex{i}" for i in range(1, 7)))
        feature, panel = self.run_creation(COMMAND)
        self.assertEqual(feature.Points[0], net)
        self.assertIn("Net", input_of(panel, "points").text())
        main_window.cancel(panel)


class PanelTest(MidSurfaceSkinsTest):
    def setUp(self):
        super().setUp()
        self.feature, self.panel = self.open()

    def type_in_table(self, row, column, text):
        table = self.panel.table
        self.assertTrue(table.setData(table.index(row, column), text))
        wait_for_preview()

    def test_a_typed_radius(self):
        top = self.feature.Shape.BoundBox.ZMax
        self.type_in_table(4, 3, "9 mm")
        self.assertEqual(self.feature.Radii[4], 9)
        self.assertGreater(self.feature.Shape.BoundBox.ZMax, top)
        main_window.screenshot("mid_surface_skins_radius")

    def test_a_typed_centre(self):
        self.type_in_table(3, 2, "30")
        self.assertEqual(self.feature.Centres[3].z, 30)

    def test_the_spheres_are_drawn_while_the_panel_is_open(self):
        drawn = main_window.sphere_radii(self.feature)
        self.assertEqual(drawn, [3, 3, 3, 4, 4, 4])
        self.type_in_table(0, 3, "2")
        self.assertEqual(main_window.sphere_radii(self.feature)[0], 2)
        main_window.confirm(self.panel)
        self.assertEqual(main_window.sphere_radii(self.feature), [])

    def test_each_skin(self):
        faces = len(self.feature.Shape.Faces)
        input_of(self.panel, "Skins").setCurrentText("Outer skin")
        wait_for_preview()
        self.assertLess(len(self.feature.Shape.Faces), faces)

    def test_what_is_no_net_is_explained(self):
        self.select(self.spline, "Edge1")
        input_of(self.panel, "use_selection").click()
        text = input_of(self.panel, "points").text()
        self.assertEqual(text, "Select three or six vertices of one object.")

    def test_an_error_is_a_sentence_and_recovers(self):
        self.type_in_table(0, 3, "500")
        self.assertIn("swallows its neighbours", input_of(self.panel, "status").text())
        self.type_in_table(0, 3, "3")
        self.assertEqual(self.feature.Status, "Valid")

    def test_edit(self):
        main_window.confirm(self.panel)
        panel = self.reopen_panel(self.feature)
        main_window.type_text(input_of(panel, "Distance"), "2")
        wait_for_preview()
        main_window.cancel(panel)
        self.assertEqual(self.feature.Distance.Value, 0)
