# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by storage_test in a FreeCAD of its own: a saved document, before anything uses the addon."""

import os
import sys
import unittest

import FreeCAD


class FreshStart(unittest.TestCase):
    def test_the_document_finds_its_classes(self):
        self.assertNotIn("pnsurfaces", sys.modules)
        document = FreeCAD.openDocument(os.environ["PNSURFACES_TEST_DOCUMENT"])
        horn = document.getObject("Horn")
        self.assertEqual(type(horn.Proxy).__name__, "CanalSurface")
        horn.Distance = 1
        document.recompute()
        self.assertTrue(horn.isValid(), horn.getStatusString())
