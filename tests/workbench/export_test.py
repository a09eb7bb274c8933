# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP files, read back by FreeCAD's own reader."""

import math
import re

import Part
from FreeCAD import Placement, Rotation, Vector
from support import RADII, DocumentTest, surface_data

from pnsurfaces import export_step, make_canal_surface


def _periodic(surface):
    """The data of a surface made periodic where it is closed, as the reader of STEP does."""
    surface = surface.copy()
    rows = surface.getPoles()
    if rows[0] == rows[-1]:
        surface.setUPeriodic()
    if all(row[0] == row[-1] for row in rows):
        surface.setVPeriodic()
    return surface_data(surface)


class StepFiles(DocumentTest):
    def setUp(self):
        super().setUp()
        self.obj = make_canal_surface(
            self.spline_object(), ("Values at vertices", RADII), 0.3, Sides="Both sides"
        )
        self.file = str(self.folder / "horn.step")

    def test_every_double_comes_back(self):
        export_step([self.obj], self.file)
        read = Part.read(self.file)
        self.assertEqual(
            [_periodic(face.Surface) for face in read.Faces],
            [_periodic(face.Surface) for face in self.obj.Shape.Faces],
        )

    def test_names_and_schema(self):
        other = make_canal_surface(self.line_object(), 2)
        self.obj.Label, other.Label = "Intake horn", "Straight pipe"
        for schema, name in (
            ("AP203", "CONFIG_CONTROL_DESIGN"),
            ("AP214", "AUTOMOTIVE_DESIGN"),
            ("AP242", "AP242"),
        ):
            export_step([self.obj, other], self.file, schema=schema)
            with open(self.file, encoding="ascii") as file:
                text = file.read()
            products = set(re.findall(r"= PRODUCT\('([^']*)'", text))
            self.assertLessEqual({"Intake horn", "Straight pipe"}, products)
            self.assertIn(name, re.search(r"FILE_SCHEMA\(\(\s*'([^']*)'", text).group(1))
            self.assertEqual(re.findall("[A-Z]*OFFSET_SURFACE|CYLINDRICAL_SURFACE", text), [])

    def test_global_coordinates(self):
        part = self.document.addObject("App::Part", "Part")
        part.Placement = Placement(Vector(100, 0, 0), Rotation())
        pipe = make_canal_surface(self.line_object(10), 2, Output="Solid")
        part.addObject(pipe)
        export_step([pipe], self.file)
        for vertex in Part.read(self.file).Vertexes:
            self.assertAlmostEqual(math.hypot(vertex.X - 100, vertex.Y), 2, delta=1e-12)

    def test_nothing_to_export(self):
        with self.assertRaisesRegex(ValueError, "no object"):
            export_step([], self.file)
        group = self.document.addObject("App::DocumentObjectGroup", "Group")
        with self.assertRaisesRegex(ValueError, "Group has no shape"):
            export_step([group], self.file)

    def test_folder_that_does_not_exist(self):
        with self.assertRaises(FileNotFoundError):
            export_step([self.obj], str(self.folder / "nowhere" / "horn.step"))
