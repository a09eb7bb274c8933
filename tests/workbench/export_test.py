# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP files, read back by FreeCAD's own reader."""

import math
import re

import Part
from FreeCAD import Placement, Rotation, Vector
from support import RADII, DocumentTest, surface_data

from pnsurfaces import export_step, make_canal_surface, make_quadric_offset


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

    def test_the_answer_says_what_was_compared(self):
        solid = make_canal_surface(self.line_object(10), 2, Output="Solid")
        sentence = export_step([solid], self.file)
        self.assertRegex(sentence, r"^horn\.step \(AP214, \d+ kB\) was read back and is the same: ")
        self.assertIn("faces 3, B-spline faces 1 with", sentence)
        self.assertIn(f"{solid.Poles} poles, bit for bit", sentence)
        self.assertIn("volume 125.663706", sentence)

    def test_parametric_curves_are_a_choice(self):
        for wanted in (True, False):
            export_step([self.obj], self.file, parametric_curves=wanted)
            with open(self.file, encoding="ascii") as file:
                self.assertEqual("PCURVE" in file.read(), wanted)

    def test_what_does_not_come_back_is_refused(self):
        """Without parametric curves OpenCASCADE loses part of this face near its pole."""
        cup = make_quadric_offset("Two-sheet hyperboloid", 30, 20, 10, -1, bounds={"z": (0, 14)})
        export_step([cup], self.file)
        with open(self.file, "rb") as file:
            kept = file.read()
        with self.assertRaisesRegex(RuntimeError, "Face 1 has the area .* Write the parametric"):
            export_step([cup], self.file, parametric_curves=False)
        with open(self.file, "rb") as file:
            self.assertEqual(file.read(), kept)

    def test_offset_surfaces_are_refused(self):
        spline = self.obj.Shape.Faces[0].Surface
        offset = self.shape_object(Part.OffsetSurface(spline, 0.5).toShape())
        with self.assertRaisesRegex(RuntimeError, "Face 1 is an offset surface"):
            export_step([offset], self.file)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_shapes_of_other_kinds_come_back_too(self):
        others = [
            self.document.addObject(f"Part::{kind}", kind)
            for kind in ("Box", "Sphere", "Cone", "Torus")
        ]
        self.document.recompute()
        sentence = export_step([*others, self.obj], self.file)
        self.assertIn("B-spline faces 2", sentence)

    def test_progress_reaches_the_end_and_may_stop(self):
        parts = []
        export_step([self.obj], self.file, progress=parts.append)
        self.assertEqual(parts, sorted(parts))
        self.assertAlmostEqual(parts[-1], 1)

        def stop(part):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            export_step([self.obj], str(self.folder / "other.step"), progress=stop)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["horn.step"])

    def test_nothing_to_export(self):
        with self.assertRaisesRegex(ValueError, "no object"):
            export_step([], self.file)
        group = self.document.addObject("App::DocumentObjectGroup", "Group")
        with self.assertRaisesRegex(ValueError, "Group has no shape"):
            export_step([group], self.file)

    def test_folder_that_does_not_exist(self):
        with self.assertRaises(FileNotFoundError):
            export_step([self.obj], str(self.folder / "nowhere" / "horn.step"))
