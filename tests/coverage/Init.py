# SPDX-License-Identifier: LGPL-2.1-or-later
"""This folder is an addon too: FreeCAD runs this file before it has a window, so that the lines of the
workbench count from the first on. COVERAGE_FILE says where coverage_tests writes them."""

import coverage

coverage.Coverage(source_pkgs=["pnsurfaces"], data_suffix=True).start()
