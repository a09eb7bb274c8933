# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of every schema version, which open for ever, and of versions that are yet to come."""

import pathlib

import FreeCAD
from support import DocumentTest, feature_classes, shape_data

import pnsurfaces
from pnsurfaces.shape import measured

DOCUMENTS = pathlib.Path(__file__).parent / "documents"


def features_of(document):
    """The exact surfaces in a document."""
    return [obj for obj in document.Objects if "SchemaVersion" in obj.PropertiesList]


class StoredDocuments(DocumentTest):
    def test_they_open_and_compute_what_they_show(self):
        for path in DOCUMENTS.glob("*.FCStd"):
            document = FreeCAD.openDocument(str(path))
            for obj in features_of(document):
                with self.subTest(path.name):
                    self.assertEqual(obj.SchemaVersion, obj.Proxy.schema_version)
                    self.assertNotIn("Touched", obj.State)
                    # That of FreeCAD depends on the lines of the faces.
                    area = measured(obj.Shape)["Area"]
                    obj.touch()
                    document.recompute()
                    self.assert_valid(obj)
                    self.assertAlmostEqual(measured(obj.Shape)["Area"] / area, 1, delta=1e-12)

    def test_every_class_has_one_of_its_present_schema(self):
        stems = {path.stem for path in DOCUMENTS.glob("*.FCStd")}
        for kind in feature_classes():
            module = kind.__module__.split(".")[-1]
            self.assertIn(f"{module}_schema_{kind.schema_version}", stems)


class NewerDocuments(DocumentTest):
    def setUp(self):
        super().setUp()
        pipe = pnsurfaces.make_canal_surface(self.line_object(), 2, name="Pipe")
        self.data = shape_data(pipe.Shape)
        pipe.SchemaVersion = 1000
        file = str(self.folder / "newer.FCStd")
        self.document.saveAs(file)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(file)
        self.pipe = self.document.Pipe

    def test_the_shape_stays_and_the_status_says_why(self):
        sentence = "A newer version of PN Surfaces has saved Pipe (schema 1000, this one knows"
        self.assertIn(sentence, self.pipe.Status)
        self.assertEqual(shape_data(self.pipe.Shape), self.data)
        self.pipe.Radius = 3
        self.document.recompute()
        self.assert_error(self.pipe, sentence)
        self.assertEqual(shape_data(self.pipe.Shape), self.data)

    def test_it_is_saved_as_it_was(self):
        self.assertEqual(self.pipe.SchemaVersion, 1000)
