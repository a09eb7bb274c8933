# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents on disk: every double comes back, and a document opens without the kernel."""

import os
import pathlib
import subprocess

import FreeCAD
from support import RADII, DocumentTest, shape_data

from pnsurfaces import make_canal_surface


def _numbers(data):
    """All numbers of nested lists and tuples, in order."""
    if isinstance(data, (list, tuple)):
        for entry in data:
            yield from _numbers(entry)
    else:
        yield data


class Storage(DocumentTest):
    def setUp(self):
        super().setUp()
        law = ("Values at vertices", RADII)
        self.obj = make_canal_surface(self.spline_object(), law, 0.3, name="Horn", Sides="Both sides")
        self.file = str(self.folder / "horn.FCStd")

    def reopened(self):
        self.document.saveAs(self.file)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(self.file)
        return self.document.getObject("Horn")

    def test_every_double_comes_back(self):
        """FreeCAD's usual text format cuts digits after the 17th decimal; they are restored."""
        preferences = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document")
        self.addCleanup(preferences.RemBool, "SaveBinaryBrep")
        for binary in (False, True):
            with self.subTest(binary=binary):
                preferences.SetBool("SaveBinaryBrep", binary)
                data = shape_data(self.document.getObject("Horn").Shape)
                obj = self.reopened()
                self.assertEqual(shape_data(obj.Shape), data)
                self.assertNotIn("Touched", obj.State)

    def test_a_placed_surface_comes_back(self):
        self.obj.Placement = FreeCAD.Placement(
            FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(1, 1, 0), 30)
        )
        data = shape_data(self.obj.Shape)
        obj = self.reopened()
        self.assertEqual(obj.Placement.Base, obj.Shape.Placement.Base)
        for number, other in zip(_numbers(data), _numbers(shape_data(obj.Shape))):
            self.assertAlmostEqual(number, other, delta=1e-13)

    def test_another_shape_is_not_replaced(self):
        """Only lost digits are restored: a spine that changed waits for a recompute."""
        data = shape_data(self.obj.Shape)
        self.document.getObject("Spline").Shape = self.line_object().Shape
        restored = list(_numbers(shape_data(self.reopened().Shape)))
        for number, other in zip(_numbers(data), restored):
            self.assertLess(abs(number - other), 1e-17)

    def test_properties_come_back(self):
        names = [
            "RadiusLaw",
            "Radius",
            "EndRadius",
            "Radii",
            "Distance",
            "Sides",
            "Output",
            "ParameterLines",
            "Degree",
            "Poles",
            "Deviation",
            "DeviationBound",
            "Exact",
            "MinOffset",
            "MaxOffset",
            "Status",
            "SchemaVersion",
        ]
        values = [getattr(self.obj, name) for name in names]
        modes = [self.obj.getEditorMode(name) for name in names]
        obj = self.reopened()
        self.assertEqual([getattr(obj, name) for name in names], values)
        self.assertEqual([obj.getEditorMode(name) for name in names], modes)
        self.assertEqual(obj.Spine[0].Name, "Spline")

    def test_bound_of_a_tiny_surface_comes_back(self):
        pipe = make_canal_surface(self.line_object(1e-3), 1e-4, name="Pipe")
        bound = pipe.DeviationBound
        self.assertLess(bound, 1e-17)
        self.reopened()
        self.assertEqual(self.document.getObject("Pipe").DeviationBound, bound)

    def test_recompute_after_reopening_changes_nothing(self):
        data = shape_data(self.obj.Shape)
        obj = self.reopened()
        self.assertNotIn("Touched", obj.State)
        obj.touch()
        self.document.recompute()
        self.assertTrue(obj.isValid(), obj.getStatusString())
        self.assertEqual(shape_data(obj.Shape), data)

    def test_results_cannot_be_edited(self):
        for name in ("Degree", "Poles", "Deviation", "Exact", "MinOffset", "MaxOffset", "Status"):
            self.assertEqual(self.obj.getEditorMode(name), ["ReadOnly"])
        self.assertEqual(self.obj.getEditorMode("SchemaVersion"), ["Hidden"])

    def test_document_of_an_older_schema(self):
        self.obj.removeProperty("ParameterLines")
        obj = self.reopened()
        self.assertEqual(obj.ParameterLines, "Even")
        obj.touch()
        self.document.recompute()
        self.assertTrue(obj.isValid(), obj.getStatusString())

    def test_without_the_kernel(self):
        self.assert_passes_in_own_freecad("without_kernel")

    def test_in_a_fresh_freecad(self):
        self.assert_passes_in_own_freecad("fresh_start")

    def assert_passes_in_own_freecad(self, test_module):
        """The tests of a module pass in another process, which finds the saved document."""
        self.document.saveAs(self.file)
        command = ["freecadcmd", "-P", pathlib.Path(__file__).parent, "-t", test_module]
        environment = {**os.environ, "PNSURFACES_TEST_DOCUMENT": self.file}
        run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
