# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by storage_test in a FreeCAD of its own: a saved document where the kernel is absent."""

import os
import sys

# An import of a module that is None here fails as if the module did not exist.
sys.modules["pnkernel"] = None
sys.modules["pnocct"] = None

import FreeCAD  # noqa: E402
from stored_documents_test import DOCUMENTS, features_of  # noqa: E402
from support import DocumentTest, shape_data  # noqa: E402

from pnsurfaces import kernel  # noqa: E402


class WithoutKernel(DocumentTest):
    def test_shape_stays_and_the_tree_says_how_to_install(self):
        document = FreeCAD.openDocument(os.environ["PNSURFACES_TEST_DOCUMENT"])
        obj = document.getObject("Horn")
        data = shape_data(obj.Shape)
        self.assertTrue(data)
        obj.Distance = 1
        document.recompute()
        self.assert_error(obj, "The PN Surfaces kernel is not built. Run scripts/build in")
        self.assertEqual(shape_data(obj.Shape), data)
        with self.assertRaises(kernel.KernelMissing):
            kernel.pnocct()

    def test_every_class_opens_with_its_shape(self):
        for path in DOCUMENTS.glob("*.FCStd"):
            document = FreeCAD.openDocument(str(path))
            for obj in features_of(document):
                with self.subTest(path.name):
                    data = shape_data(obj.Shape)
                    self.assertTrue(data)
                    obj.touch()
                    document.recompute()
                    self.assert_error(obj, "The PN Surfaces kernel is not built.")
                    self.assertEqual(shape_data(obj.Shape), data)
