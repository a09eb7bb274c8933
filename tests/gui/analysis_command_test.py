# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of PN Analysis: what they draw, that it follows the surface, and that it goes."""

import os
import tempfile

import FreeCAD
import FreeCADGui
import main_window
import numpy as np
from pivy import coin
from support import GuiTest, poles

import pnsurfaces
from pnsurfaces import analysis
from pnsurfaces.compat import QtGui

COMMANDS = {
    "PNSurfaces_CurvatureMap": analysis.CURVATURE,
    "PNSurfaces_GaussMap": analysis.GAUSS,
    "PNSurfaces_Zebra": analysis.ZEBRA,
    "PNSurfaces_Combs": analysis.COMBS,
    "PNSurfaces_ControlNet": analysis.CONTROL_NET,
    "PNSurfaces_ParameterLines": analysis.PARAMETER_LINES,
}


class AnalysisTest(GuiTest):
    def setUp(self):
        super().setUp()
        self.feature = pnsurfaces.make_canal_surface(self.spline, (8, 14), 2)
        self.document.clearUndos()
        self.root = self.feature.ViewObject.RootNode
        self.before = self.children()
        self.select(self.feature)

    def children(self):
        return [
            self.root.getChild(i).getTypeId().getName().getString()
            for i in range(self.root.getNumChildren())
        ]

    def shown(self):
        return self.feature.ViewObject.Proxy.analysis.shown

    def nodes(self, kind):
        """All nodes of a kind that are drawn for the feature."""
        search = coin.SoSearchAction()
        search.setType(coin.SoType.fromName(kind))
        search.setInterest(coin.SoSearchAction.ALL)
        search.apply(self.root)
        paths = search.getPaths()
        return [paths.get(i).getTail() for i in range(paths.getLength())]

    def texts(self):
        return [node.string.getValues()[0] for node in self.nodes("SoText2")]

    def picture(self):
        """The colours (h, w, 3) of the 3D view on white."""
        FreeCADGui.SendMsgToActiveView("ViewFit")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "view.png")
            FreeCADGui.activeDocument().activeView().saveImage(path, 300, 300, "White")
            image = QtGui.QImage(path).convertToFormat(QtGui.QImage.Format_RGB888)
        rows = np.frombuffer(image.constBits(), np.uint8).reshape(300, image.bytesPerLine())
        return rows[:, :900].reshape(300, 300, 3).astype(int)


class ShowingTest(AnalysisTest):
    def test_each_command_shows_and_hides(self):
        for command, name in COMMANDS.items():
            FreeCADGui.runCommand(command)
            self.assertEqual(self.shown(), {name})
            main_window.screenshot(f"analysis_{name.replace(' ', '_')}")
            self.assertEqual(len(self.children()), len(self.before) + 2)
            FreeCADGui.runCommand(command)
            self.assertEqual(self.shown(), set())
            self.assertEqual(self.children(), self.before)

    def test_lines_may_lie_on_colours(self):
        for command in ("CurvatureMap", "ParameterLines", "ControlNet", "Combs"):
            FreeCADGui.runCommand(f"PNSurfaces_{command}")
        self.assertEqual(len(self.shown()), 4)
        main_window.screenshot("analysis_together")

    def test_one_colouring_replaces_another(self):
        for command in ("CurvatureMap", "GaussMap", "Zebra"):
            FreeCADGui.runCommand(f"PNSurfaces_{command}")
            self.assertEqual(self.shown(), {COMMANDS[f"PNSurfaces_{command}"]})

    def test_all_selected_surfaces(self):
        other = pnsurfaces.make_canal_surface(self.line, 5)
        FreeCADGui.runCommand("PNSurfaces_Zebra")
        FreeCADGui.Selection.addSelection(other)
        FreeCADGui.Selection.addSelection(self.spline)
        FreeCADGui.runCommand("PNSurfaces_Zebra")
        self.assertEqual(other.ViewObject.Proxy.analysis.shown, {analysis.ZEBRA})
        self.assertEqual(self.shown(), {analysis.ZEBRA})
        FreeCADGui.runCommand("PNSurfaces_Zebra")
        self.assertEqual(self.shown(), set())

    def test_they_need_a_surface_of_ours(self):
        self.select(self.spline)
        for command in COMMANDS:
            self.assertFalse(FreeCADGui.Command.get(command).isActive())


class TruthTest(AnalysisTest):
    def test_the_smallest_radius_is_named(self):
        tube = pnsurfaces.make_canal_surface(self.line, 5, 2)
        self.select(tube)
        self.root = tube.ViewObject.RootNode
        FreeCADGui.runCommand("PNSurfaces_CurvatureMap")
        self.assertIn("smallest radius 7 mm", self.texts())
        self.assertIn("r = 7 mm", self.texts())
        (label,) = self.nodes("SoFrameLabel")
        self.assertIn("smallest radius 7 mm", label.getField("string").get().getString())

    def test_the_control_net_is_that_of_the_shape(self):
        FreeCADGui.runCommand("PNSurfaces_ControlNet")
        coordinates = self.nodes("SoCoordinate3")
        net = next(node for node in coordinates if node.point.getNum() == self.feature.Poles)
        found = [tuple(node.getValue()) for node in net.point.getValues()]
        np.testing.assert_allclose(found, poles(self.feature)[0], rtol=1e-6, atol=1e-5)

    def test_colours_are_seen_though_the_object_is_selected(self):
        FreeCADGui.runCommand("PNSurfaces_Zebra")
        picture = self.picture()
        grey = np.ptp(picture, axis=2) < 30
        self.assertGreater((picture.max(axis=2) < 60)[grey].sum(), 1000)
        self.assertGreater(grey.mean(), 0.97)


class LifeTest(AnalysisTest):
    def test_it_follows_the_surface(self):
        FreeCADGui.runCommand("PNSurfaces_CurvatureMap")
        before = self.texts()
        self.feature.Distance = -3
        self.document.recompute()
        self.assertNotEqual(self.texts(), before)
        self.assertEqual(len(self.children()), len(self.before) + 2)

    def test_it_is_hidden_with_the_object(self):
        FreeCADGui.runCommand("PNSurfaces_Zebra")
        self.line.ViewObject.Visibility = self.spline.ViewObject.Visibility = False
        self.assertLess(self.picture().min(), 60)
        self.feature.ViewObject.Visibility = False
        self.assertEqual(self.picture().min(), 255)
        self.feature.ViewObject.Visibility = True
        self.assertLess(self.picture().min(), 60)

    def test_nothing_is_stored_and_nothing_to_undo(self):
        FreeCADGui.runCommand("PNSurfaces_CurvatureMap")
        self.assertEqual(self.document.UndoCount, 0)
        self.assertNotIn("Touched", self.feature.State)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "pipe.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            opened = FreeCAD.openDocument(path)
            self.assertEqual(opened.CanalSurface.ViewObject.Proxy.analysis.shown, set())

    def test_it_goes_with_the_object(self):
        FreeCADGui.runCommand("PNSurfaces_Combs")
        self.document.removeObject(self.feature.Name)
        main_window.settle()
        self.assertIsNone(self.document.getObject("CanalSurface"))

    def test_the_shape_is_not_touched(self):
        before = poles(self.feature)
        for command in COMMANDS:
            FreeCADGui.runCommand(command)
        self.assertEqual(poles(self.feature), before)

    def test_it_is_where_the_object_is_and_the_legend_makes_no_room_for_itself(self):
        self.feature.Placement = FreeCAD.Placement(FreeCAD.Vector(1e4, 0, 0), FreeCAD.Rotation())
        FreeCADGui.runCommand("PNSurfaces_CurvatureMap")
        action = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(100, 100))
        action.apply(self.root)
        # It is kept by a name: pivy's corner of a box lives no longer than the box.
        box = action.getBoundingBox()
        self.assertGreater(box.getMin().getValue()[0], 9e3)
