# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FreeCAD that is killed while it saves, and documents whose end is missing.

PN_TEST_SEED chooses the moments and the places.
"""

import os
import random
import signal
import time
import zipfile

import FreeCAD
from stored_documents_test import DOCUMENTS, features_of
from support import RADII, DocumentTest, shape_data

from pnsurfaces import make_canal_surface

SEED = int(os.environ.get("PN_TEST_SEED", "1"))
KILLS = 8

# So many times as long as saving takes is waited at most: two states are saved in turn.
TURNS = 2


class KilledFreeCAD(DocumentTest):
    """FreeCAD writes another file, renames the old one to a backup, and then the new one.

    So a whole document is always there: between the two renames it is the backup.
    """

    def setUp(self):
        super().setUp()
        law = ("Values at vertices", RADII)
        self.horn = make_canal_surface(self.spline_object(), law, 1, name="Horn")
        self.file = self.folder / "horn.FCStd"
        self.document.saveAs(str(self.file))
        self.states = {1: shape_data(self.horn.Shape), 2: self._second_state()}
        # From now on there is a backup, as there is of most documents.
        start = time.perf_counter()
        self.document.save()
        self.seconds = time.perf_counter() - start

    def test_a_whole_document_stays(self):
        choose = random.Random(SEED)
        for number in range(KILLS):
            with self.subTest(f"PN_TEST_SEED={SEED}, number {number}"):
                self._kill_while_it_saves(choose.uniform(0, TURNS * self.seconds))
                self._check(self._document_that_stayed())

    def _second_state(self):
        """As a step that can be undone, so that nothing is computed between saving and saving."""
        self.document.UndoMode = 1
        self.document.openTransaction("Distance")
        self.horn.Distance = 2
        self.document.recompute()
        self.document.commitTransaction()
        return shape_data(self.horn.Shape)

    def _kill_while_it_saves(self, seconds):
        """A copy of this process saves; it is killed so long after it was done for the first time."""
        has_saved, tell = os.pipe()
        process = os.fork()
        if process == 0:
            self._save_without_end(tell)
        os.close(tell)
        self.assertEqual(os.read(has_saved, 1), b".")
        time.sleep(seconds)
        os.kill(process, signal.SIGKILL)
        _, status = os.waitpid(process, 0)
        os.close(has_saved)
        self.assertEqual(os.waitstatus_to_exitcode(status), -signal.SIGKILL)

    def _save_without_end(self, tell):
        """Never returns: an error ends the process too, and the test sees by which signal."""
        try:
            while True:
                for step in (self.document.undo, self.document.redo):
                    step()
                    self.document.save()
                    os.write(tell, b".")
        finally:
            os._exit(1)

    def _document_that_stayed(self):
        return self.file if self.file.exists() else self.file.with_name(self.file.name + "1")

    def _check(self, path):
        """The document is one of the states that were saved, as a whole."""
        copy = self.folder / "copy.FCStd"
        copy.write_bytes(path.read_bytes())
        document = FreeCAD.openDocument(str(copy))
        horn = document.Horn
        self.assert_valid(horn)
        self.assertEqual(horn.Status, "Valid")
        self.assertEqual(shape_data(horn.Shape), self.states[horn.Distance.Value])
        FreeCAD.closeDocument(document.Name)


class DocumentsWithoutTheirEnd(DocumentTest):
    """FreeCAD refuses what ends within Document.xml, and opens what it can read of the others."""

    def setUp(self):
        super().setUp()
        self.choose = random.Random(SEED)

    def test_without_all_its_properties_a_document_is_refused(self):
        for path in sorted(DOCUMENTS.glob("*.FCStd")):
            self._check_refused(self._cut(path, 0, _size_of_properties(path)))

    def test_lost_shapes_are_computed_anew(self):
        """Or the status says why not, when what they are made from is lost as well."""
        for path in sorted(DOCUMENTS.glob("*.FCStd")):
            size = _size_of_properties(path)
            self._check_opened(self._cut(path, size, size + 1))
            self._check_opened(self._cut(path, size, path.stat().st_size))

    def test_a_lost_shape_stands_where_it_stood(self):
        pipe = make_canal_surface(self.line_object(), 2, name="Pipe")
        pipe.Placement.Base = FreeCAD.Vector(1, 2, 3)
        self.document.recompute()
        shape, path = shape_data(pipe.Shape), self.folder / "pipe.FCStd"
        self.document.saveAs(str(path))
        with zipfile.ZipFile(path) as stored:
            end = stored.getinfo("PartShape1.brp").header_offset
        FreeCAD.closeDocument(self.document.Name)
        path.write_bytes(path.read_bytes()[:end])
        pipe = FreeCAD.openDocument(str(path)).Pipe
        self.assertEqual(shape_data(pipe.Shape), shape)
        self.assertEqual(pipe.Placement.Base, FreeCAD.Vector(1, 2, 3))
        self.assertNotIn("Touched", pipe.State)

    def _cut(self, path, first, last):
        """A copy of the document that ends at a place chosen from these."""
        end = self.choose.randrange(first, last)
        copy = self.folder / f"{path.stem}_{end}_PN_TEST_SEED_{SEED}.FCStd"
        copy.write_bytes(path.read_bytes()[:end])
        return copy

    def _check_refused(self, path):
        with self.subTest(path.stem):
            with self.assertRaises(OSError):
                FreeCAD.openDocument(str(path))
            self.assertEqual(list(FreeCAD.listDocuments()), [self.document.Name])

    def _check_opened(self, path):
        with self.subTest(path.stem):
            document = FreeCAD.openDocument(str(path))
            for obj in features_of(document):
                # FreeCAD prints what this raises, and goes on.
                obj.Proxy.onDocumentRestored(obj)
                if obj.Shape.isNull():
                    self.assertRegex(obj.Status, r"^Error: [A-Z\d][^\n]*[.]$")
                else:
                    self.assert_valid(obj)
                    self.assertRegex(obj.Status, "^(Valid|Warning: .*)$")
            FreeCAD.closeDocument(document.Name)


def _size_of_properties(path):
    """How many bytes of a document there are up to the end of its first file, Document.xml."""
    with zipfile.ZipFile(path) as stored:
        first, second, *_ = stored.infolist()
    assert first.filename == "Document.xml"
    return second.header_offset
