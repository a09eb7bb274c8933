# SPDX-License-Identifier: LGPL-2.1-or-later
"""Python imports this module at its start, so that lines of the workbench count from the first on,
also those that FreeCAD's window runs before any test. COVERAGE_FILE says where they are written."""

import pathlib

import coverage

WORKBENCH = pathlib.Path(__file__).resolve().parents[2] / "workbench"

coverage.Coverage(source=[str(WORKBENCH)], data_suffix=True).start()
