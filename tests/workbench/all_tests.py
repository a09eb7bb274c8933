# SPDX-License-Identifier: LGPL-2.1-or-later
"""All tests of the workbench without its window: freecadcmd -P tests/workbench -t all_tests."""

import pathlib


def load_tests(loader, _standard_tests, _pattern):
    return loader.discover(str(pathlib.Path(__file__).parent), pattern="*_test.py")
