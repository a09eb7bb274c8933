# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents with a stored value that is wrong: a sentence or another surface, never a surprise."""

import os
import random
import re
import zipfile

import FreeCAD
from stored_documents_test import DOCUMENTS, features_of
from support import DocumentTest

SEED = int(os.environ.get("PN_TEST_SEED", "1"))
TIMES = int(os.environ.get("PN_TEST_CORRUPTIONS", "50"))

# The values of properties in Document.xml, those of numbers and enumerations as text too.
VALUE = re.compile(rb'(?<= value=")[^"]*|(?<= value[XYZ]=")[^"]*')
WRONG = (b"", b"nan", b"inf", b"-inf", b"0", b"-1", b"7", b"1e300", b"1e-300", b"Sketch", b"1 / 0")

# A coordinate, weight or knot in the BREP text of a shape. FreeCAD itself reads what is around it.
NUMBER = re.compile(rb"-?\d+\.\d+(?:e-?\d+)?")
NUMBERS = (b"0", b"1", b"-1", b"1e9", b"1e-300", b"0.5", b"1e300")

# The numbers of a list follow their count.
COUNT_BYTES = 4


def _replaced(data, pattern, others, choose):
    place = choose.choice(list(pattern.finditer(data)))
    return data[: place.start()] + choose.choice(others) + data[place.end() :]


def _corrupt_properties(xml, choose):
    """One value of an exact surface, each of which has a property SchemaVersion."""
    objects = re.split(rb"(?=<Object name=)", xml)
    features = [i for i, part in enumerate(objects) if b'"SchemaVersion"' in part]
    feature = choose.choice(features)
    objects[feature] = _replaced(objects[feature], VALUE, WRONG, choose)
    return b"".join(objects)


def _corrupt_list(data, choose):
    place = choose.randrange(COUNT_BYTES, len(data))
    return data[:place] + bytes([choose.randrange(256)]) + data[place + 1 :]


def _corrupt(name, data, choose):
    if name == "Document.xml":
        return _corrupt_properties(data, choose)
    if name.endswith(".brp"):
        return _replaced(data, NUMBER, NUMBERS, choose)
    return _corrupt_list(data, choose)


class CorruptDocuments(DocumentTest):
    def test_they_open_and_compute_or_say_why_not(self):
        choose = random.Random(SEED)
        paths = sorted(DOCUMENTS.glob("*.FCStd"))
        for number in range(TIMES):
            with self.subTest(f"PN_TEST_SEED={SEED}, number {number}"):
                self._check(self._corrupted(choose.choice(paths), choose))

    def _corrupted(self, path, choose):
        """A copy of the document in which one file is not as it was."""
        copy = self.folder / path.name
        with zipfile.ZipFile(path) as stored, zipfile.ZipFile(copy, "w") as corrupted:
            names = stored.namelist()
            # Half of them in the properties: they are what most is decided by.
            wrong = choose.choice([*names, *["Document.xml"] * (len(names) - 2)])
            for name in names:
                data = stored.read(name)
                corrupted.writestr(name, _corrupt(name, data, choose) if name == wrong else data)
        return copy

    def _check(self, path):
        document = FreeCAD.openDocument(str(path))
        try:
            for obj in features_of(document):
                # FreeCAD prints what these raise, and goes on.
                obj.Proxy.onDocumentRestored(obj)
                self._check_computation(obj)
        finally:
            FreeCAD.closeDocument(document.Name)

    def _check_computation(self, obj):
        try:
            obj.Proxy.execute(obj)
        except ValueError as error:
            self.assertRegex(str(error), r"^[A-Z\d][^\n]*[.]$")
            self.assertEqual(obj.Status, f"Error: {error}")
        else:
            self.assertRegex(obj.Status, "^(Valid|Warning: .*)$")
            self.assertFalse(obj.Shape.isNull())
