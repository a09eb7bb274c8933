# SPDX-License-Identifier: LGPL-2.1-or-later
"""The addon's package.xml, as FreeCAD's addon manager and the index of addons read it."""

import datetime
import pathlib
import re
import unittest
import xml.etree.ElementTree as ElementTree

import FreeCAD

import pnsurfaces

ROOT = pathlib.Path(pnsurfaces.__file__).parents[2]
PACKAGE = FreeCAD.Metadata(str(ROOT / "package.xml"))


class Package(unittest.TestCase):
    def setUp(self):
        (self.workbench,) = PACKAGE.Content["workbench"]

    def test_version(self):
        self.assertEqual(PACKAGE.Version, pnsurfaces.__version__)
        # FreeCAD 0.20 does not read the date, later versions do.
        date = ElementTree.parse(ROOT / "package.xml").getroot().findtext("{*}date")
        datetime.date.fromisoformat(date)

    def test_maintainer_and_license(self):
        self.assertTrue(PACKAGE.Maintainer)
        for maintainer in PACKAGE.Maintainer:
            self.assertIn("@", maintainer["email"])
        (licence,) = PACKAGE.License
        self.assertEqual(licence["name"], "LGPL-2.1-or-later")
        self.assertTrue((ROOT / licence["file"]).is_file())

    def test_files_exist(self):
        for icon in (PACKAGE.Icon, self.workbench.Icon):
            self.assertTrue((ROOT / icon).is_file(), icon)
        self.assertTrue((ROOT / self.workbench.Subdirectory / "InitGui.py").is_file())

    def test_class_is_added_to_the_window(self):
        text = (ROOT / "InitGui.py").read_text(encoding="utf-8")
        self.assertIn(f"addWorkbench({self.workbench.Classname}())", text)

    def test_index_takes_its_words(self):
        """The index wants no name with FreeCAD in it, a short first sentence, three to seven tags."""
        self.assertNotIn("freecad", PACKAGE.Name.lower())
        self.assertLess(len(PACKAGE.Description.split(".")[0]), 60)
        self.assertIn(len(self.workbench.Tag), range(3, 8))
        for tag in self.workbench.Tag:
            self.assertTrue(re.fullmatch("[a-z]+", tag), tag)
