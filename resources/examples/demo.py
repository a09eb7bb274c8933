# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the presentation in FreeCAD for scripts/demo, and tells by the exit status how it went."""

import os
import pathlib
import sys
import traceback

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "build" / "demo"

try:
    from presentation import present

    present(FOLDER)
except BaseException:
    # FreeCAD would report the error in its window, wait for its user and end with status 0.
    traceback.print_exc(file=sys.__stderr__)
    sys.__stderr__.flush()
    os._exit(1)
os._exit(0)
