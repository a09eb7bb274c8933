# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tutorials of docs/, step by step: what they say happens, and these are their pictures.

scripts/tutorials runs this module and copies the pictures to docs/images.
"""

import os
import pathlib
import tempfile
from unittest import mock

import FreeCAD
import FreeCADGui
import main_window
from support import GuiTest, input_of, make_wall, wait_for_preview

import pnsurfaces
from pnsurfaces.compat import QtWidgets

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"


class Tutorial(GuiTest):
    page = ""

    def assert_says(self, *texts):
        """The page says these texts, however its lines are broken."""
        said = " ".join((DOCS / self.page).read_text(encoding="utf-8").split())
        for text in texts:
            self.assertIn(text, said)

    def open_example(self, name):
        self.document = pnsurfaces.open_example(name)
        for obj in self.document.Objects:
            obj.ViewObject.Visibility = False
        main_window.settle()

    def show(self, *objects):
        for obj in objects:
            obj.ViewObject.Visibility = True
        FreeCADGui.activeDocument().activeView().viewIsometric()

    def picture(self, number):
        main_window.screenshot(f"{pathlib.Path(self.page).stem}_{number}")


class CanalSurface(Tutorial):
    page = "canal_surface_tutorial.md"

    def test_tutorial(self):
        self.open_example("hose")
        spine = self.document.getObjectsByLabel("Spine")[0]
        self.show(spine)
        feature, panel = self.open_panel(spine)
        self.assert_says(f"a radius of {feature.Radius.Value:g} mm")
        self.picture(1)
        input_of(panel, "RadiusLaw").setCurrentText("Linear")
        main_window.type_text(input_of(panel, "Radius"), "12")
        main_window.type_text(input_of(panel, "EndRadius"), "18")
        wait_for_preview()
        self.assert_says("**Start** `12`", "**End** `18`", f"*{feature.Poles}* poles")
        input_of(panel, "Hollow").setCurrentText("Wall thickness")
        main_window.type_text(input_of(panel, "WallThickness"), "3")
        input_of(panel, "Output").setCurrentText("Solid")
        wait_for_preview()
        self.assertEqual(feature.Shape.ShapeType, "Solid")
        self.picture(2)
        limit = feature.MaxOffset.Value
        main_window.type_text(input_of(panel, "Distance"), "40")
        wait_for_preview()
        self.assertLess(limit, 40)
        self.assertIn("beyond the limit", feature.Status)
        self.assert_says("**Distance** `40`", f"beyond {int(limit)} mm", "beyond the limit")
        self.picture(3)
        main_window.type_text(input_of(panel, "Distance"), "0")
        wait_for_preview()
        self.assertEqual(feature.Status, "Valid")
        main_window.confirm(panel)
        self.assert_nothing_open()
        self.document.undo()
        self.assertIsNone(self.document.getObject("CanalSurface"))
        self.document.redo()
        self.assertTrue(self.document.CanalSurface.Shape.isValid())


class RuledSurface(Tutorial):
    page = "ruled_surface_tutorial.md"

    def test_tutorial(self):
        self.open_example("twisted_blade")
        curves = [self.document.getObjectsByLabel(label)[0] for label in ("Root", "Tip")]
        self.show(*curves)
        FreeCADGui.Selection.clearSelection()
        for curve in curves:
            FreeCADGui.Selection.addSelection(curve)
        feature, panel = self.run_creation("PNSurfaces_RuledOffset")
        self.assert_says(f"*{feature.Poles}* poles")
        self.picture(1)
        make_wall(panel, "2", "Both sides")
        self.assertEqual(feature.Shape.ShapeType, "Solid")
        self.assert_says(
            "**Distance** `2`",
            "*Both sides*",
            "*Solid*",
            f"*{feature.Poles}* poles",
            f"{feature.Volume.getValueAs('cm^3').Value:.1f} cm³",
        )
        self.picture(2)
        main_window.confirm(panel)
        self.assert_nothing_open()
        points = curves[1].Points
        points[1] = points[1] + FreeCAD.Vector(0, 0, 30)
        curves[1].Points = points
        self.document.recompute()
        self.assertTrue(feature.isValid(), feature.getStatusString())


class Quadric(Tutorial):
    page = "quadric_tutorial.md"

    def test_tutorial(self):
        for obj in (self.line, self.spline):
            self.document.removeObject(obj.Name)
        feature, panel = self.run_creation("PNSurfaces_QuadricOffset")
        self.assertEqual(feature.Kind, "Ellipsoid")
        self.picture(1)
        input_of(panel, "Kind").setCurrentText("One-sheet hyperboloid")
        for name, value in (
            ("HalfAxisA", "30"),
            ("HalfAxisB", "22"),
            ("HalfAxisC", "40"),
            ("MinZ", "-60"),
            ("MaxZ", "30"),
        ):
            main_window.type_text(input_of(panel, name), value)
            self.assert_says(f"`{value}`")
        make_wall(panel, "3", "Base and offset")
        self.assertEqual(feature.Shape.ShapeType, "Solid")
        self.assertTrue(feature.Exact)
        self.assert_says("**Distance** `3`", "*Base and offset*", f"*{feature.Poles}* poles")
        self.picture(2)
        main_window.confirm(panel)
        self.assert_nothing_open()
        self.assertEqual(feature.Status, "Valid")


class Trust(Tutorial):
    page = "certificate_tutorial.md"

    def test_tutorial(self):
        self.open_example("reflector")
        front = self.document.Front
        self.show(front)
        self.select(front)
        FreeCADGui.runCommand("PNSurfaces_Certificate")
        main_window.settle()
        form = FreeCADGui.getMainWindow().findChild(QtWidgets.QWidget, "Certificate")
        self.assertIn("Proven deviation", form.report.toPlainText())
        self.picture(1)
        FreeCADGui.Control.closeDialog()
        main_window.settle()
        FreeCADGui.runCommand("PNSurfaces_CurvatureMap")
        FreeCADGui.runCommand("PNSurfaces_ControlNet")
        FreeCADGui.Selection.clearSelection()
        self.picture(2)
        self.assert_says(f"*{front.Poles}* poles")
        self.select(self.document.Dish)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "dish.step")
            with mock.patch("pnsurfaces.commands.ask_export_path", return_value=path):
                FreeCADGui.runCommand("PNSurfaces_ExportStep")
            self.assertTrue(os.path.exists(path))
