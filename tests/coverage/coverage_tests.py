# SPDX-License-Identifier: LGPL-2.1-or-later
"""All tests of another folder, and which lines of the workbench they ran. FreeCAD ends without the
exit handlers of Python, so this is saved as soon as the last test has ended:
freecadcmd -P tests/workbench -t coverage_tests."""

import unittest

import all_tests
import coverage


class MeasuredSuite(unittest.TestSuite):
    def run(self, result, debug=False):
        try:
            return super().run(result, debug)
        finally:
            measured = coverage.Coverage.current()
            measured.stop()
            measured.save()


def load_tests(loader, standard_tests, pattern):
    return MeasuredSuite([all_tests.load_tests(loader, standard_tests, pattern)])
