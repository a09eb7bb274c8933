# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where to write a file: FreeCAD's file dialog, which begins in the folder of the last export."""

import FreeCADGui

from pnsurfaces import preferences
from pnsurfaces.compat import QtWidgets


def ask_export_path(title, name, filters):
    """The file name that the user chooses, at first `name`; empty when there is none."""
    path, _ = QtWidgets.QFileDialog.getSaveFileName(
        FreeCADGui.getMainWindow(), title, preferences.export_path(name), filters
    )
    if path:
        preferences.remember_export_path(path)
    return path
