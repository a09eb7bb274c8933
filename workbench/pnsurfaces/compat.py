# SPDX-License-Identifier: LGPL-2.1-or-later
"""The modules of Qt under their own names, whatever the version of FreeCAD calls them."""

from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    # FreeCAD 0.20 keeps the widgets in QtGui.
    QtWidgets = QtGui

__all__ = ["QtCore", "QtGui", "QtWidgets"]
