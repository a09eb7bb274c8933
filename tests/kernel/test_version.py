# SPDX-License-Identifier: LGPL-2.1-or-later
"""One version in all manifests: CMake's project, FreeCAD's package.xml, the Python package."""

import pathlib
import re
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]


def found_in(path, pattern):
    return re.search(pattern, (ROOT / path).read_text(encoding="utf-8")).group(1)


def test_all_say_the_same():
    package = ElementTree.parse(ROOT / "package.xml").getroot()
    version = package.find("{https://wiki.freecad.org/Package_Metadata}version").text
    assert found_in("CMakeLists.txt", r"project\([^)]*VERSION (\S+?)[\s)]") == version
    assert found_in("workbench/pnsurfaces/__init__.py", r'__version__ = "(.*)"') == version
