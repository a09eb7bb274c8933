# SPDX-License-Identifier: LGPL-2.1-or-later
"""All tests in FreeCAD's window: freecad -P tests/gui -t all_tests."""

import pathlib
import unittest


def load_tests(loader, _standard_tests, _pattern):
    """Those of the keyboard come first: they walk over every widget in a form, and PySide takes the
    Python half of a widget that an earlier test has left for that of a later one at its address."""
    modules = loader.discover(str(pathlib.Path(__file__).parent), pattern="*_test.py")
    return unittest.TestSuite(sorted(modules, key=lambda tests: "keyboard_test" not in str(tests)))
